// SPDX-License-Identifier: LGPL-2.1-or-later

#include <cmath>
#include <limits>

#include <biface/laminate/layup.h>
#include <biface/laminate/material.h>
#include <biface/model/equations/shell_equations.h>
#include <biface/model/mesh/strip.h>
#include <biface/output/fiber_tension.h>
#include <biface/output/ply_results.h>
#include <biface/output/requested_criteria.h>

namespace Biface
{
  using namespace dealii;

  namespace
  {
    /** The height above the inner face. */
    double
    height_in_laminate(const Laminate    &laminate,
                       const unsigned int ply,
                       const double       fraction)
    {
      const std::vector<Ply> &plies = laminate.get_plies();
      double                  z     = fraction * plies[ply].thickness;
      for (unsigned int p = 0; p < ply; ++p)
        z += plies[p].thickness;
      return z;
    }
  } // namespace


  Tensor<1, 2>
  EquilibriumShear::stress(const unsigned int layer,
                           const unsigned int vertex,
                           const unsigned int ply,
                           const double       fraction)
  {
    const ShellMesh   &mesh    = equations.mesh;
    const unsigned int of_cell = mesh.wall_of(layer);
    const auto [first, end]    = mesh.layers_of(of_cell);
    // the plies of a wall are asked for one after the other
    if (wall != of_cell)
      {
        wall = of_cell;
        strains.clear();
        for (unsigned int c = first; c < end; ++c)
          strains.push_back(
            equations.internal_forces().strains_at_vertices(state, c));
      }

    const auto laminate = [&](const unsigned int c) -> const Laminate & {
      return *mesh.strips[mesh.cells[c].strip].at_vertices[vertex];
    };
    for (unsigned int c = first; c < end; ++c)
      if (laminate(c).ply_points())
        {
          constexpr double nan = std::numeric_limits<double>::quiet_NaN();
          return Tensor<1, 2>({nan, nan});
        }
    const double z = height_in_laminate(laminate(layer), ply, fraction);
    if (end == first + 1)
      return laminate(layer).interlaminar_stress(strains[0][vertex].E, ply, z);

    // equilibrium is that of the whole wall, from face to face, whatever the
    // strains of a layer are; its coefficients belong to the plies at the place
    std::vector<Tensor<1, 2>> shear_forces;
    for (unsigned int c = first; c < end; ++c)
      shear_forces.push_back(
        laminate(c).shear_force(strains[c - first][vertex].E));
    const Laminate *const key   = &laminate(first);
    auto                  known = of_walls.find(key);
    if (known == of_walls.end())
      {
        std::vector<TransverseShear> layers;
        for (unsigned int c = first; c < end; ++c)
          layers.push_back(laminate(c).get_transverse_shear());
        known =
          of_walls
            .emplace(key, InterlaminarShear(layers, layers.front().of_wall()))
            .first;
      }
    return known->second.stress(shear_forces, layer - first, ply, z);
  }


  PlyState::PlyState(const Laminate       &laminate,
                     const unsigned int    ply,
                     const double          fraction,
                     const StrainsOfPlies &E,
                     const Tensor<1, 2>   &interlaminar)
    : interlaminar(interlaminar)
  {
    // initial stresses are given in the axes of the ply
    const std::vector<Ply> &plies = laminate.get_plies();
    const double            z     = height_in_laminate(laminate, ply, fraction);
    strain                        = laminate.strain(E, ply, z);
    stress                        = laminate.stress(E, ply, z) +
             rotate_about_normal(plies[ply].initial_stress, plies[ply].angle);
    slack = laminate.is_slack(E.E, ply, z);
  }


  SymmetricTensor<2, 3>
  PlyState::failure_stress(const Ply &ply) const
  {
    // at large strains strengths refer to the true stress
    return rotate_about_normal(
      ply.laws.rubber ? cauchy_stress(stress, strain) : stress, -ply.angle);
  }


  FaceStress::FaceStress(const Laminate        &laminate,
                         const Resultants::Face face,
                         const StrainsOfPlies  &E)
  {
    const bool         is_outer = (face == Resultants::outer);
    const unsigned int ply = is_outer ? laminate.get_plies().size() - 1 : 0;
    const PlyState     state(laminate, ply, is_outer ? 1. : 0., E, {});
    stress      = state.stress;
    true_stress = (laminate.get_plies()[ply].laws.rubber
                     ? cauchy_stress(state.stress, state.strain)
                     : state.stress);
  }


  std::array<double, 4>
  FaceStress::values() const
  {
    return {{stress[0][0],
             stress[1][1],
             stress[0][1],
             std::sqrt(1.5) * deviator(true_stress).norm()}};
  }


  std::vector<std::string>
  ply_value_names(const FailureCriteria &criteria, const Layup &layup)
  {
    std::vector<std::string> names{
      "e_11", "e_22", "e_33", "g_23", "g_13", "g_12", "s_11", "s_22",
      "s_33", "t_23", "t_13", "t_12", "e_L",  "e_T",  "e_N",  "g_TN",
      "g_LN", "g_LT", "s_L",  "s_T",  "s_N",  "t_TN", "t_LN", "t_LT"};
    for (const FailureCriterion &criterion : criteria.requested())
      names.push_back(criterion.column + "_index");
    names.push_back("interlaminar_t_23");
    names.push_back("interlaminar_t_13");
    if (layup.has_cords())
      names.push_back("cord_tension");
    if (layup.has_slack_cords())
      names.push_back("slack");
    if (layup.is_hyperelastic())
      for (const char *component : {"L", "T", "N", "TN", "LN", "LT"})
        names.push_back(std::string("cauchy_") + component);
    return names;
  }


  std::vector<double>
  ply_values(const PlyState        &state,
             const Ply             &ply,
             const FailureCriteria &criteria,
             const Layup           &layup)
  {
    constexpr double    nan = std::numeric_limits<double>::quiet_NaN();
    std::vector<double> values;
    const auto          append = [&](const SymmetricTensor<2, 3> &tensor,
                            const double                 shear_factor) {
      for (unsigned int i = 0; i < 3; ++i)
        values.push_back(tensor[i][i]);
      values.push_back(shear_factor * tensor[1][2]);
      values.push_back(shear_factor * tensor[0][2]);
      values.push_back(shear_factor * tensor[0][1]);
    };
    const SymmetricTensor<2, 3> stress =
      rotate_about_normal(state.stress, -ply.angle);
    const SymmetricTensor<2, 3> strain =
      rotate_about_normal(state.strain, -ply.angle);
    // shear strains are angles, twice the components of the tensor
    append(state.strain, 2);
    append(state.stress, 1);
    append(strain, 2);
    append(stress, 1);

    const auto &strengths = layup.get_plies()[ply.number].material.strengths;
    for (const FailureCriterion &criterion : criteria.requested())
      values.push_back(
        strengths ? criterion.index(state.failure_stress(ply), *strengths)
                  : nan);
    values.push_back(state.interlaminar[1]);
    values.push_back(state.interlaminar[0]);
    if (layup.has_cords())
      // cords run in the whole ply, of which a layer may have a part
      values.push_back(ply.cord_pitch > 0
                         ? stress[0][0] * force_per_stress(ply, strain[0][0]) *
                             ply.thickness / (ply.end - ply.begin) *
                             ply.cord_pitch
                         : nan);
    if (layup.has_slack_cords())
      values.push_back(state.slack ? 1 : 0);
    if (layup.is_hyperelastic())
      append(cauchy_stress(stress, strain), 1);
    return values;
  }
} // namespace Biface
