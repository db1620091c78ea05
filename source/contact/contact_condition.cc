// SPDX-License-Identifier: LGPL-2.1-or-later

#include <string>

#include <biface/base/errors.h>
#include <biface/contact/contact_condition.h>
#include <biface/contact/contact_condition_parameters.h>
#include <biface/input/entry_declarations.h>
#include <biface/input/parameter_tools.h>

namespace Biface
{
  using namespace dealii;

  std::array<std::array<double, 4>, 4>
  mortar_matrix(const MortarMatrix kind, const std::array<double, 3> &density)
  {
    const bool is_lumped = (kind == MortarMatrix::lumped);
    // the lower bit of a vertex is its place along alpha_1, the other one that
    // along alpha_2: the bilinear matrix is a product of integrals over edges,
    // here of N_r N_s or, lumped, of N_r, of the same vertices and of others,
    // and of the first ones times a density that is odd
    const double same  = (is_lumped ? 1. / 2 : 1. / 3);
    const double other = (is_lumped ? 0. : 1. / 6);
    const double odd   = 1. / 6;

    std::array<std::array<double, 4>, 4> M;
    for (unsigned int r = 0; r < 4; ++r)
      for (unsigned int s = 0; s < 4; ++s)
        {
          const std::array<double, 2> integral{
            {(r ^ s) & 1 ? other : same, (r ^ s) & 2 ? other : same}};
          M[r][s] = density[0] * integral[0] * integral[1];
          for (unsigned int a = 0; a < 2; ++a)
            if (((r ^ s) >> a & 1) == 0)
              M[r][s] +=
                ((r >> a) & 1 ? odd : -odd) * density[1 + a] * integral[1 - a];
        }
    return M;
  }


  void
  ContactConditionParameters::add_parameters(EntryDeclarations &prm)
  {
    add_choice(
      prm,
      "Multiplier mass",
      mortar_matrix,
      {"consistent", "lumped"},
      "Mortar matrix, from nodal contact pressures to nodal "
      "forces: 'lumped' (that of dual basis functions: smooth pressures, "
      "symmetric tangent) or 'consistent' (as in the paper; pressures "
      "oscillate at the edge of the contact zone).");
    prm.add_parameter(
      "Points in cells",
      points_per_side,
      "The number k of k x k points in each cell that make contact, at the "
      "middle of equal parts of it, between which the deformed faces are "
      "bilinear; or 0, by which the nodes do. Points feel bodies that are "
      "smaller than the cells, but need a stiffness of contact that is not "
      "far above that of the wall: a 'Tread' or a 'Regularization'.",
      Patterns::Integer(0, 10));
    add_optional_number(
      prm,
      "Regularization",
      penalty_stiffness,
      "automatic",
      "The penalty stiffness epsilon of contact: a pressure p causes a "
      "penetration of p/epsilon. A positive number, or 'automatic': 7000 k with "
      "the lowest stiffness of the wall across its thickness, k = 1/sum(h/E), "
      "where h is the thickness of each ply and E its modulus in this "
      "direction. The penetration is then 1/7000 of what the pressure takes "
      "off the thickness. In a shell as thin as a membrane k is at most "
      "1000 sum(h E)/L^2 with the highest modulus of each ply in its plane and "
      "the diagonal L of the box around the shell.",
      Unit("pressure/length"));
  }


  void
  ContactConditionParameters::check() const
  {
    if (penalty_stiffness)
      check_positive("Contact/Regularization", *penalty_stiffness);
    if (points_per_side > 0 && mortar_matrix == MortarMatrix::consistent)
      throw InputError("Contact/Points in cells",
                       std::to_string(points_per_side),
                       "it must be 0 with 'Multiplier mass = consistent'");
  }


  ContactCondition::ContactCondition(const Parameters &parameters,
                                     const double      wall_stiffness)
    : ContactCondition(
        parameters.penalty_stiffness.value_or(7000 * wall_stiffness))
  {}
} // namespace Biface
