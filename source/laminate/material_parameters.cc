// SPDX-License-Identifier: LGPL-2.1-or-later

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include <biface/base/errors.h>
#include <biface/input/formula.h>
#include <biface/input/parameter_tools.h>
#include <biface/laminate/material.h>
#include <biface/laminate/material_parameters.h>

namespace Biface
{
  using namespace dealii;

  void
  MaterialParameters::add_parameters(ParameterHandler &prm)
  {
    add_choice(
      prm,
      "Type",
      type,
      {"isotropic", "transversely isotropic", "orthotropic", "cord and rubber"},
      "Which of the constants below are used: 'isotropic' E, nu; "
      "'transversely isotropic' about the cords or fibers E_L to "
      "nu_TT; 'orthotropic' the nine constants E_1 to nu_23, axis 1 "
      "along the fibers, 3 across the ply; 'cord and rubber' E_cord "
      "to 'Ply thickness', from which the constants of a "
      "transversely isotropic ply are computed.");

    const std::vector<std::pair<std::string, double *>> moduli{{"E", &E},
                                                               {"E_L", &E_L},
                                                               {"E_T", &E_T},
                                                               {"G_LT", &G_LT},
                                                               {"G_TT", &G_TT},
                                                               {"E_1", &E_1},
                                                               {"E_2", &E_2},
                                                               {"E_3", &E_3},
                                                               {"G_12", &G_12},
                                                               {"G_13", &G_13},
                                                               {"G_23", &G_23}};
    for (const auto &modulus : moduli)
      prm.add_parameter(modulus.first,
                        *modulus.second,
                        (modulus.first[0] == 'E'
                           ? "Young's modulus. Unit: force/area."
                           : "Shear modulus. Unit: force/area."),
                        Patterns::Double());

    const std::vector<std::pair<std::string, double *>> ratios{
      {"nu", &nu},
      {"nu_LT", &nu_LT},
      {"nu_TT", &nu_TT},
      {"nu_12", &nu_12},
      {"nu_13", &nu_13},
      {"nu_23", &nu_23}};
    for (const auto &ratio : ratios)
      prm.add_parameter(ratio.first,
                        *ratio.second,
                        "Poisson's ratio: the strain along the second axis "
                        "under a stress along the first. No unit.",
                        Patterns::Double());

    cord_and_rubber.add_parameters(prm);
    prm.add_parameter("E_L compression",
                      E_L_compression,
                      "Young's modulus E_L where the strain along the cords is "
                      "negative, for cords that go slack: a number or a "
                      "formula of E_L such as E_L/100, above 0 and at most "
                      "E_L. Only for 'transversely isotropic' and 'cord and "
                      "rubber'. Unit: force/area.",
                      Patterns::Anything());

    const std::vector<std::pair<std::string, double *>> all_strengths{
      {"X_t", &strengths.X_t},
      {"X_c", &strengths.X_c},
      {"Y_t", &strengths.Y_t},
      {"Y_c", &strengths.Y_c},
      {"S", &strengths.S}};
    for (const auto &strength : all_strengths)
      prm.add_parameter(strength.first,
                        *strength.second,
                        "Strength, a positive number, or 0 if not given: X_t, "
                        "X_c along axis 1 in tension and compression, Y_t, "
                        "Y_c along axis 2, S in shear between both. Give all "
                        "five or none. Unit: force/area.",
                        Patterns::Double(0));

    prm.add_parameter("Density",
                      density,
                      "Density, of a ply as a whole for 'cord and rubber'. "
                      "Only 'Modes' of a stage need it. Unit: mass/volume, "
                      "where a unit of mass is that of force times time^2 per "
                      "length: for N, mm and s it is the tonne.",
                      Patterns::Double());

    prm.add_parameter("Loss factor",
                      loss_factor,
                      "The tangent of the angle by which strains lag behind "
                      "stresses in a cycle, the same at all frequencies, of a "
                      "ply as a whole for 'cord and rubber': a number not less "
                      "than 0. A rolling wheel then has a rolling resistance, "
                      "in rolling.csv. No unit.",
                      Patterns::Double());
  }


  SymmetricTensor<4, 3>
  MaterialParameters::stiffness(const double cord_fraction) const
  {
    const std::string section = "Material " + name;
    switch (type)
      {
        case Type::isotropic:
          check_positive(section + "/E", E);
          if (!(nu > -1 && nu < 0.5))
            throw InputError(section + "/nu",
                             number_to_string(nu),
                             "it must lie between -1 and 0.5");
          return Material::isotropic(E, nu).stiffness(section);
        case Type::transversely_isotropic:
          check_positive(section + "/E_L", E_L);
          check_positive(section + "/E_T", E_T);
          check_positive(section + "/G_LT", G_LT);
          check_positive(section + "/G_TT", G_TT);
          return Material::transversely_isotropic(
                   E_L, E_T, G_LT, G_TT, nu_LT, nu_TT)
            .stiffness(section);
        case Type::orthotropic:
          return Material{E_1, E_2, E_3, G_12, G_13, G_23, nu_12, nu_13, nu_23}
            .stiffness(section);
        case Type::cord_and_rubber:
          cord_and_rubber.check(name);
          return cord_and_rubber.ply_material(cord_fraction).stiffness(section);
      }
    Assert(false, ExcInternalError());
    return {};
  }


  bool
  MaterialParameters::has_slack_cords() const
  {
    if (E_L_compression == MaterialParameters().E_L_compression)
      return false;
    const std::string entry = "Material " + name + "/E_L compression";
    if (type != Type::transversely_isotropic && type != Type::cord_and_rubber)
      throw InputError(entry,
                       E_L_compression,
                       "it may only be given with 'Type = transversely "
                       "isotropic' or 'cord and rubber'");
    Formula(entry, E_L_compression, {"E_L"});
    return true;
  }


  double
  MaterialParameters::compression_loss(const double E_L) const
  {
    const std::string entry   = "Material " + name + "/E_L compression";
    const double      modulus = Formula(entry, E_L_compression, {"E_L"})({E_L});
    // round-off must not refuse E_L itself
    if (!(modulus > 0 && modulus <= (1 + 1e-12) * E_L))
      throw InputError(entry,
                       E_L_compression,
                       "it must be above 0 and at most E_L, " +
                         number_to_string(E_L));
    return std::max(0., E_L - modulus);
  }


  double
  MaterialParameters::get_density() const
  {
    check_not_negative("Material " + name + "/Density", density);
    return density;
  }


  double
  MaterialParameters::get_loss_factor() const
  {
    check_not_negative("Material " + name + "/Loss factor", loss_factor);
    return loss_factor;
  }


  std::optional<Strengths>
  MaterialParameters::get_strengths() const
  {
    const std::array<std::pair<const char *, double>, 5> all{
      {{"X_t", strengths.X_t},
       {"X_c", strengths.X_c},
       {"Y_t", strengths.Y_t},
       {"Y_c", strengths.Y_c},
       {"S", strengths.S}}};
    if (std::all_of(all.begin(), all.end(), [](const auto &strength) {
          return strength.second == 0;
        }))
      return {};
    for (const auto &strength : all)
      {
        const std::string entry = "Material " + name + "/" + strength.first;
        if (strength.second == 0)
          throw InputError(entry,
                           "0",
                           "a material with strengths must have all five: X_t, "
                           "X_c, Y_t, Y_c, S");
        check_positive(entry, strength.second);
      }
    return strengths;
  }
} // namespace Biface
