// SPDX-License-Identifier: LGPL-2.1-or-later

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>
#include <utility>
#include <vector>

#include <biface/base/errors.h>
#include <biface/input/entry_declarations.h>
#include <biface/input/formula.h>
#include <biface/input/parameter_tools.h>
#include <biface/laminate/cord_law.h>
#include <biface/laminate/material.h>
#include <biface/laminate/material_parameters.h>
#include <biface/laminate/rubber.h>

namespace Biface
{
  using namespace dealii;

  namespace
  {
    std::vector<double>
    parse_constants(const std::string &entry, const std::string &text)
    {
      std::vector<double> numbers;
      for (const std::string &item : split_list(entry, text))
        numbers.push_back(parse_number(
          entry, item, "it must be a list of numbers, separated by commas"));
      return numbers;
    }


    std::string
    text_of(const std::vector<double> &numbers)
    {
      std::string text;
      for (const double number : numbers)
        text += (text.empty() ? "" : ", ") + number_to_string(number);
      return text;
    }
  } // namespace


  void
  MaterialParameters::add_parameters(EntryDeclarations &prm)
  {
    // 0 stands for a constant that is not given, since a material has only
    // those of its type; check() asks for these and refuses others
    add_choice(
      prm,
      "Type",
      type,
      {"isotropic",
       "transversely isotropic",
       "orthotropic",
       "cord and rubber",
       "neo-Hooke",
       "Mooney-Rivlin",
       "Yeoh",
       "Ogden"},
      "Which of the constants below are used: 'isotropic' E, nu; "
      "'transversely isotropic' about the cords or fibers E_L to "
      "nu_TT; 'orthotropic' the nine constants E_1 to nu_23, axis 1 "
      "along the fibers, 3 across the ply; 'cord and rubber' E_cord "
      "to 'Ply thickness', from which the constants of a "
      "transversely isotropic ply are computed. These are linear; rubber at "
      "large strains is 'neo-Hooke' with mu, 'Mooney-Rivlin' with c10, c01, "
      "'Yeoh' with c10, c20, c30, or 'Ogden' with mu_i, alpha_i, each with K "
      "or nu.");

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
      prm.add_parameter(
        modulus.first,
        *modulus.second,
        (modulus.first[0] == 'E' ? "Young's modulus." : "Shear modulus."),
        Patterns::Double(),
        Unit("force/area"));

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
                        "under a stress along the first.",
                        Patterns::Double(),
                        Unit::none());

    const std::vector<std::tuple<std::string, double *, std::string>> of_rubber{
      {"K", &K, "The bulk modulus; 0: by nu"},
      {"mu", &mu, "The shear modulus"},
      {"c10", &c10, "The factor of I1 - 3"},
      {"c20", &c20, "The factor of (I1 - 3)^2"},
      {"c30", &c30, "The factor of (I1 - 3)^3"},
      {"c01", &c01, "The factor of I2 - 3"}};
    for (const auto &constant : of_rubber)
      prm.add_parameter(std::get<0>(constant),
                        *std::get<1>(constant),
                        std::get<2>(constant) + " of rubber, see 'Type'.",
                        Patterns::Double(),
                        Unit("force/area"));
    add_parsed(prm,
               "mu_i",
               "",
               mu_i,
               parse_constants,
               "List of the constants mu_i of 'Ogden', with the energy "
               "mu_i/alpha_i (l1^alpha_i + l2^alpha_i + l3^alpha_i - 3) "
               "of the principal stretches: the shear modulus is half "
               "the sum of mu_i alpha_i.",
               Unit("force/area"));
    add_parsed(prm,
               "alpha_i",
               "",
               alpha_i,
               parse_constants,
               "List of the exponents alpha_i of 'Ogden', as many as "
               "mu_i.",
               Unit::none());

    cord_and_rubber.add_parameters(prm);
    add_choice(prm,
               "Matrix",
               matrix,
               {"linear", "neo-Hooke"},
               "What is between the cords of 'transversely isotropic' or 'cord "
               "and rubber': a linear law for small strains, or neo-Hookean "
               "rubber with the shear modulus G_LT and the bulk modulus K (or "
               "by nu, or of the rubber of 'cord and rubber'), in which the "
               "cords have a force linear in their stretch, such that E_L is "
               "the modulus of the ply; then E_T is about 4 G_LT, and E_T, "
               "G_TT, nu_LT, nu_TT are not given.");
    prm.add_parameter("Compression onset",
                      compression_onset,
                      "The compressive strain of the cords from which on their "
                      "modulus is 'E_L compression': a number or a formula of "
                      "E_L, G_LT, not negative, or 'by matrix': 0 in a linear "
                      "one, G_LT/E_L, where cords buckle in the matrix, in "
                      "rubber.",
                      Patterns::Anything(),
                      Unit::none());
    prm.add_parameter("E_L compression",
                      E_L_compression,
                      "Young's modulus E_L where the strain along the cords is "
                      "negative, for cords that go slack: a number or a "
                      "formula of E_L such as E_L/100, above 0 and at most "
                      "E_L, with 'Matrix = neo-Hooke' at least that of the "
                      "matrix. Only for 'transversely isotropic' and 'cord and "
                      "rubber'.",
                      Patterns::Anything(),
                      Unit("force/area"));

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
                        "five or none.",
                        Patterns::Double(0),
                        Unit("force/area"));

    prm.add_parameter(
      "Density",
      density,
      "Density, of a ply as a whole for 'cord and rubber'. "
      "'Modes', 'Inertia' and a 'Frequency response' of a stage need it.",
      Patterns::Double(),
      Unit("mass/volume, where a unit of mass is that of "
           "force times time^2 per length: "
           "for N, mm and s it is the tonne"));

    prm.add_parameter("Loss factor",
                      loss_factor,
                      "The tangent of the angle by which strains lag behind "
                      "stresses in a cycle, the same at all frequencies, of a "
                      "ply as a whole for 'cord and rubber': a number not less "
                      "than 0. A rolling wheel then has a rolling resistance, "
                      "in rolling.csv.",
                      Patterns::Double(),
                      Unit::none());

    prm.add_parameter("Thermal conductivity",
                      thermal_conductivity,
                      "Conductivity of heat, in all directions: a number not "
                      "less than 0. Only 'Heat/Temperatures' needs it.",
                      Patterns::Double(),
                      Unit("power/(length * temperature)"));

    add_parsed(prm,
               "Relaxation times",
               "",
               relaxation_times,
               parse_constants,
               "List of the times of a Prony series by which the stresses "
               "relax, at the reference temperature; empty: they do not. The "
               "constants of the material are then the instantaneous ones, and "
               "time passes in stages with a 'Duration'.",
               Unit("time"));
    add_parsed(
      prm,
      "Relaxation moduli",
      "",
      relaxation_moduli,
      parse_constants,
      "List of the parts of the instantaneous moduli, all of them, that "
      "relax by these times, with a sum below 1.",
      Unit::none());
    add_choice(
      prm,
      "Temperature shift",
      shift.kind,
      {"none", "WLF", "Arrhenius"},
      "How the temperature of a stage multiplies these times, by a: "
      "'WLF' (Williams, Landel, Ferry): log10 a = -C1 (T - T_ref)/(C2 + "
      "T - T_ref); 'Arrhenius': ln a = C (1/T - 1/T_ref) with absolute "
      "temperatures.");
    prm.add_parameter("Reference temperature",
                      shift.reference,
                      "T_ref.",
                      Patterns::Double(),
                      Unit("temperature"));
    prm.add_parameter(
      "WLF C1",
      shift.C_1,
      "C1; the default is the universal constant, for T_ref the "
      "glass transition.",
      Patterns::Double(),
      Unit::none());
    prm.add_parameter(
      "WLF C2", shift.C_2, "C2.", Patterns::Double(), Unit("temperature"));
    prm.add_parameter("Arrhenius constant",
                      shift.activation,
                      "C, the activation energy over the gas constant.",
                      Patterns::Double(),
                      Unit("temperature"));
  }


  bool
  MaterialParameters::is_isotropic() const
  {
    return type != Type::transversely_isotropic && type != Type::orthotropic &&
           type != Type::cord_and_rubber;
  }


  bool
  MaterialParameters::is_hyperelastic() const
  {
    return matrix == Matrix::neo_Hooke ||
           (is_isotropic() && type != Type::isotropic);
  }


  void
  MaterialParameters::check_unused() const
  {
    // a constant without effect is mostly a misunderstanding, so that it is
    // refused and not ignored
    const std::string section = "Material " + name + "/";
    const auto        only    = [&](const std::string &entry,
                          const std::string &value,
                          const bool         given,
                          const bool         used,
                          const std::string &users) {
      if (given && !used)
        throw InputError(
          section + entry, value, "it may only be given with " + users);
    };
    const auto only_number = [&](const std::string &entry,
                                 const double       value,
                                 const bool         used,
                                 const std::string &users) {
      only(entry, number_to_string(value), value != 0, used, users);
    };
    const bool has_cords =
      type == Type::transversely_isotropic || type == Type::cord_and_rubber;
    only("Compression onset",
         compression_onset,
         compression_onset != MaterialParameters().compression_onset,
         has_slack_cords(),
         "'E_L compression'");
    only("Matrix",
         "neo-Hooke",
         matrix != Matrix::linear,
         has_cords,
         "'Type = transversely isotropic' or 'cord and rubber'");
    only_number(
      "E", E, !(is_isotropic() && is_hyperelastic()), "'Type = isotropic'");
    const bool polynomial = type == Type::Mooney_Rivlin || type == Type::Yeoh;
    only_number("mu", mu, type == Type::neo_Hooke, "'Type = neo-Hooke'");
    only_number("c10", c10, polynomial, "'Type = Mooney-Rivlin' or 'Yeoh'");
    only_number(
      "c01", c01, type == Type::Mooney_Rivlin, "'Type = Mooney-Rivlin'");
    only_number("c20", c20, type == Type::Yeoh, "'Type = Yeoh'");
    only_number("c30", c30, type == Type::Yeoh, "'Type = Yeoh'");
    for (const auto &constants :
         {std::make_pair("mu_i", &mu_i), std::make_pair("alpha_i", &alpha_i)})
      only(constants.first,
           text_of(*constants.second),
           !constants.second->empty(),
           type == Type::Ogden,
           "'Type = Ogden'");
    only_number("K",
                K,
                is_hyperelastic(),
                "a rubber ('neo-Hooke', 'Mooney-Rivlin', 'Yeoh', 'Ogden') or "
                "with 'Matrix = neo-Hooke'");
    only("Cord curve",
         cord_and_rubber.curve.name,
         !cord_and_rubber.curve.name.empty(),
         type == Type::cord_and_rubber && matrix == Matrix::neo_Hooke,
         "'Type = cord and rubber' and 'Matrix = neo-Hooke'");
    if (matrix != Matrix::linear)
      for (const auto &constant : {std::make_pair("E_T", E_T),
                                   std::make_pair("G_TT", G_TT),
                                   std::make_pair("nu_LT", nu_LT),
                                   std::make_pair("nu_TT", nu_TT)})
        only_number(
          constant.first, constant.second, false, "'Matrix = linear'");
  }


  double
  MaterialParameters::bulk_modulus(const double shear_modulus) const
  {
    const std::string section = "Material " + name + "/";
    if (K != 0)
      {
        if (nu != 0)
          throw InputError(section + "K",
                           number_to_string(K),
                           "it may only be given without 'nu'");
        check_finite(section + "K", K);
        // larger ones lose too many digits
        if (K > 1e7 * shear_modulus)
          throw InputError(section + "K",
                           number_to_string(K),
                           "it must be at most ten million times the shear "
                           "modulus, " +
                             number_to_string(shear_modulus));
        // below, Poisson's ratio would be negative
        if (!(K > 2. / 3 * shear_modulus))
          throw InputError(section + "K",
                           number_to_string(K),
                           "it must be greater than two thirds of the shear "
                           "modulus, " +
                             number_to_string(shear_modulus));
        return K;
      }
    if (type == Type::cord_and_rubber && nu == 0)
      return cord_and_rubber.E_rubber /
             (3 * (1 - 2 * cord_and_rubber.nu_rubber));
    if (!(nu > 0 && nu < 0.5))
      throw InputError(section + "nu",
                       number_to_string(nu),
                       "it must lie between 0 and 0.5 where 'K' is not given");
    return 2 * shear_modulus * (1 + nu) / (3 * (1 - 2 * nu));
  }


  std::shared_ptr<const MaterialLaw>
  MaterialParameters::rubber(const double shear_modulus) const
  {
    const std::string section         = "Material " + name + "/";
    const auto        bulk_modulus_of = [&](const std::string &entry,
                                     const std::string &value,
                                     const double       modulus) {
      if (!(modulus > 0 && std::isfinite(modulus)))
        throw InputError(section + entry,
                         value,
                         "the shear modulus must be positive; it is " +
                           number_to_string(modulus));
      return bulk_modulus(modulus);
    };
    switch (type)
      {
        case Type::Mooney_Rivlin:
        case Type::Yeoh:
          for (const auto &constant : {std::make_pair("c10", c10),
                                       std::make_pair("c20", c20),
                                       std::make_pair("c30", c30),
                                       std::make_pair("c01", c01)})
            check_finite(section + constant.first, constant.second);
          return std::make_shared<PolynomialRubber>(
            std::array<double, 3>{{c10, c20, c30}},
            c01,
            // the message names the constant that is to blame
            bulk_modulus_of(c10 > 0 ? "c01" : "c10",
                            number_to_string(c10 > 0 ? c01 : c10),
                            2 * (c10 + c01)));
        case Type::Ogden:
          {
            if (mu_i.empty())
              throw InputError(
                section + "mu_i", "", "it must contain at least one number");
            if (mu_i.size() != alpha_i.size())
              throw InputError(section + "alpha_i",
                               text_of(alpha_i),
                               "it must have as many numbers as 'mu_i', which "
                               "is '" +
                                 text_of(mu_i) + "'");
            std::vector<OgdenRubber::Term> terms;
            double                         modulus = 0;
            for (unsigned int i = 0; i < mu_i.size(); ++i)
              {
                check_not_zero(section + "mu_i", mu_i[i]);
                check_not_zero(section + "alpha_i", alpha_i[i]);
                terms.push_back({mu_i[i], alpha_i[i]});
                modulus += mu_i[i] * alpha_i[i] / 2;
              }
            return std::make_shared<OgdenRubber>(
              terms, bulk_modulus_of("mu_i", text_of(mu_i), modulus));
          }
        default:
          return std::make_shared<NeoHooke>(shear_modulus,
                                            bulk_modulus(shear_modulus));
      }
  }


  Material
  MaterialParameters::linear_material(const double cord_fraction) const
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
          return Material::isotropic(E, nu);
        case Type::orthotropic:
          return {E_1, E_2, E_3, G_12, G_13, G_23, nu_12, nu_13, nu_23};
        case Type::cord_and_rubber:
          cord_and_rubber.check(name);
          return cord_and_rubber.ply_material(cord_fraction);
        default:
          check_positive(section + "/E_L", E_L);
          check_positive(section + "/G_LT", G_LT);
          if (matrix == Matrix::linear)
            {
              check_positive(section + "/E_T", E_T);
              check_positive(section + "/G_TT", G_TT);
            }
          return Material::transversely_isotropic(
            E_L, E_T, G_LT, G_TT, nu_LT, nu_TT);
      }
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
  MaterialParameters::modulus_in_compression(const double E_L) const
  {
    const std::string entry   = "Material " + name + "/E_L compression";
    const double      modulus = Formula(entry, E_L_compression, {"E_L"})({E_L});
    // round-off must not refuse E_L itself
    if (!(modulus > 0 && modulus <= (1 + 1e-12) * E_L))
      throw InputError(entry,
                       E_L_compression,
                       "it must be above 0 and at most E_L, " +
                         number_to_string(E_L));
    return std::min(E_L, modulus);
  }


  double
  MaterialParameters::onset(const double E_L, const double G_LT) const
  {
    // fibers buckle in a matrix of rubber at about G_LT/E_L (Rosen 1965)
    if (compression_onset == MaterialParameters().compression_onset)
      return matrix == Matrix::linear ? 0 : G_LT / E_L;
    const std::string entry = "Material " + name + "/Compression onset";
    const double      value =
      Formula(entry, compression_onset, {"E_L", "G_LT"})({E_L, G_LT});
    if (!(value >= 0 && value < 1))
      throw InputError(
        entry, compression_onset, "it must be at least 0 and less than 1");
    return value;
  }


  namespace
  {
    /** The strain along the cords, axis 1, that causes an initial stress, where
     * beyond the strain -onset the stress is lost by which @p loss is the
     * modulus. */
    double
    initial_cord_strain(const SymmetricTensor<4, 3> &stiffness,
                        const SymmetricTensor<2, 3> &stress,
                        const double                 loss,
                        const double                 onset)
    {
      if (stress.norm() == 0)
        return 0;
      // slack cords have a greater strain e under the same stress: that of taut
      // cords plus what is lost, lost (e + onset)
      const SymmetricTensor<4, 3> compliance = invert(stiffness);
      const double                strain     = (compliance * stress)[0][0];
      const double                lost       = loss * compliance[0][0][0][0];
      return strain >= -onset ? strain : (strain + lost * onset) / (1 - lost);
    }
  } // namespace


  std::shared_ptr<const Relaxation>
  MaterialParameters::relaxation() const
  {
    const std::string section = "Material " + name + "/";
    if (relaxation_moduli.size() != relaxation_times.size())
      throw InputError(section + "Relaxation moduli",
                       text_of(relaxation_moduli),
                       "it must have as many numbers as 'Relaxation times', "
                       "which is '" +
                         text_of(relaxation_times) + "'");
    const auto only = [&](const std::string      &entry,
                          const double            value,
                          const double            unused,
                          Relaxation::Shift::Kind kind,
                          const std::string      &users) {
      if (value != unused && shift.kind != kind)
        throw InputError(
          section + entry,
          number_to_string(value),
          "it may only be given with 'Temperature shift = " + users + "'");
    };
    using Kind = Relaxation::Shift::Kind;
    const Relaxation::Shift none;
    only("WLF C1", shift.C_1, none.C_1, Kind::WLF, "WLF");
    only("WLF C2", shift.C_2, none.C_2, Kind::WLF, "WLF");
    only("Arrhenius constant",
         shift.activation,
         none.activation,
         Kind::Arrhenius,
         "Arrhenius");
    // a shift alone would have no effect
    if (!relaxes())
      {
        if (shift.kind != Kind::none)
          throw InputError(section + "Temperature shift",
                           shift.kind == Kind::WLF ? "WLF" : "Arrhenius",
                           "it may only be given with 'Relaxation times'");
        return {};
      }

    if (loss_factor > 0)
      throw InputError(section + "Loss factor",
                       number_to_string(loss_factor),
                       "it may only be given without 'Relaxation times'");
    std::vector<Relaxation::Term> terms;
    double                        sum = 0;
    for (unsigned int i = 0; i < relaxation_times.size(); ++i)
      {
        check_positive(section + "Relaxation times", relaxation_times[i]);
        check_positive(section + "Relaxation moduli", relaxation_moduli[i]);
        terms.push_back({relaxation_times[i], relaxation_moduli[i]});
        sum += relaxation_moduli[i];
      }
    if (!(sum < 1))
      throw InputError(section + "Relaxation moduli",
                       text_of(relaxation_moduli),
                       "the sum must be below 1");
    if (shift.kind == Kind::WLF)
      {
        check_positive(section + "WLF C1", shift.C_1);
        check_positive(section + "WLF C2", shift.C_2);
      }
    if (shift.kind == Kind::Arrhenius)
      {
        check_positive(section + "Arrhenius constant", shift.activation);
        check_positive(section + "Reference temperature", shift.reference);
      }
    return std::make_shared<Relaxation>(terms, shift);
  }


  void
  MaterialParameters::check() const
  {
    // the volume fraction of cords follows from the plies
    if (type != Type::cord_and_rubber || matrix == Matrix::linear)
      laws();
    else
      {
        check_unused();
        bulk_modulus(linear_material(0).G_12);
        relaxation();
      }
  }


  PlyMaterial
  MaterialParameters::of_ply() const
  {
    const std::string section = "Material " + name;
    for (const auto &[entry, value] :
         {std::make_pair("/Density", density),
          std::make_pair("/Loss factor", loss_factor),
          std::make_pair("/Thermal conductivity", thermal_conductivity)})
      check_not_negative(section + entry, value);

    PlyMaterial result;
    result.name            = name;
    result.has_fibers      = !is_isotropic();
    result.has_slack_cords = has_slack_cords();
    result.is_hyperelastic = is_hyperelastic();
    result.relaxes         = relaxes();
    result.density         = density;
    result.loss_factor     = loss_factor;
    result.conductivity    = thermal_conductivity;
    result.strengths       = get_strengths();
    return result;
  }


  PlyLaws
  MaterialParameters::laws(const double                 cord_fraction,
                           const SymmetricTensor<2, 3> &initial_stress) const
  {
    PlyLaws result    = elastic_laws(cord_fraction, initial_stress);
    result.relaxation = relaxation();
    return result;
  }


  PlyLaws
  MaterialParameters::elastic_laws(
    const double                 cord_fraction,
    const SymmetricTensor<2, 3> &initial_stress) const
  {
    const std::string section = "Material " + name;
    check_unused();
    PlyLaws result;
    if (is_isotropic() && is_hyperelastic())
      {
        if (type == Type::neo_Hooke)
          check_positive(section + "/mu", mu);
        result.rubber    = rubber(mu);
        result.stiffness = result.rubber->initial_stiffness();
        return result;
      }

    const Material constants = linear_material(cord_fraction);
    const bool     slack     = has_slack_cords();
    const double   E_c =
      slack ? modulus_in_compression(constants.E_1) : constants.E_1;
    if (matrix == Matrix::linear)
      {
        result.stiffness = constants.stiffness(section);
        // E_L as the stiffness has it
        const double E_L  = 1 / invert(result.stiffness)[0][0][0][0];
        const double loss = std::max(0., E_L - E_c);
        if (slack && loss > 0)
          {
            const double e_c = onset(constants.E_1, constants.G_12);
            result.cords     = std::make_shared<SlackCordLaw>(
              loss,
              e_c,
              initial_cord_strain(result.stiffness, initial_stress, loss, e_c));
          }
        return result;
      }

    const double G = constants.G_12, K_matrix = bulk_modulus(G);
    const double E_matrix = 9 * K_matrix * G / (3 * K_matrix + G);
    // round-off must not refuse plies with few cords
    if (!(E_c >= (1 - 1e-9) * E_matrix))
      throw InputError(section + (slack ? "/E_L compression" : "/E_L"),
                       number_to_string(E_c),
                       "it must be at least Young's modulus of the matrix, " +
                         number_to_string(E_matrix));
    if (slack && initial_stress.norm() > 0)
      throw InputError("a ply of the material '" + name +
                       "' with 'Matrix = neo-Hooke' and cords that go slack "
                       "('E_L compression') may have no initial stress "
                       "('Laminate/Initial ply stresses').");
    // the cords carry what the rubber does not, so that E_L is the initial
    // modulus of the ply
    result.rubber = rubber(G);
    const auto curve =
      type == Type::cord_and_rubber ? cord_and_rubber.force_curve() : nullptr;
    result.cords = std::make_shared<StretchedCordLaw>(
      std::max(0., constants.E_1 - E_matrix),
      std::max(0., E_c - E_matrix),
      onset(constants.E_1, G),
      curve,
      curve ? cord_fraction / cord_and_rubber.cord_area() : 0.);
    result.stiffness = result.rubber->initial_stiffness();
    // for all that is linear with the initial moduli, as the distribution of
    // transverse shear
    result.stiffness[0][0][0][0] += constants.E_1 - E_matrix;
    return result;
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
