// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/numbers.h>
#include <deal.II/base/utilities.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include <biface/base/errors.h>
#include <biface/input/parameter_tools.h>
#include <biface/laminate/layup.h>

namespace Biface
{
  using namespace dealii;

  void
  Layup::Parameters::add_parameters(ParameterHandler &prm)
  {
    add_parsed(prm,
               "Laminate/",
               "Plies",
               "cord: 1.2 @ 52, cord: 1.2 @ -52, cord: 1.2 @ 52, "
               "cord: 1.2 @ -52",
               plies,
               parse_plies,
               "The plies, inner ply first, separated by commas, each "
               "as 'material: thickness @ angle', followed by 'from A "
               "to B' if the ply covers only this part of alpha_1 "
               "(between two mesh lines; the jump in thickness is "
               "spread over the cells on both sides). The angle of the "
               "material's first axis is measured from the first "
               "coordinate line (the meridian) toward the second. "
               "Thickness and angle are numbers, or formulas of "
               "alpha_1 and of the 'Tables', such as 1.2 + "
               "0.01*abs(alpha_1). Units: length, degrees, alpha_1 as "
               "in 'Mesh'.");
    add_parsed(prm,
               "Laminate/",
               "Tables",
               "",
               tables,
               parse_tables,
               "Tables for the formulas of 'Plies': a list of 'name: "
               "file', separated by commas. Each CSV file has rows "
               "'alpha_1, value' with increasing alpha_1; values are "
               "interpolated linearly and constant beyond the ends. "
               "Paths are relative to the parameter file. A name with "
               "a comma must be put in double quotes, in which %XX "
               "stands for the byte with this hexadecimal number.");
    add_parsed(prm,
               "Laminate/",
               "Initial ply stresses",
               "",
               initial_stresses,
               parse_ply_stresses,
               "Initial stresses in the undeformed shell, one triple "
               "'sigma_L sigma_T tau_LT' per ply, inner ply first, "
               "separated by commas; empty for none. Each is a number "
               "or a formula, without blanks, as in 'Plies'. They act "
               "only through the nonlinear part of the strains, being "
               "in equilibrium with loads that are not given. Unit: "
               "force/area.");
    add_parsed(
      prm,
      "Laminate/",
      "Initial resultants",
      "",
      initial_resultants,
      parse_initial_resultants,
      "Initial resultants, the eleven H_ij of the theory, as functions "
      "of the position, added to those of 'Initial ply stresses': a "
      "list of 'H_ij FACE = FORMULA', separated by semicolons, with ij "
      "one of 11, 22, 12, 13, 23 and FACE one of inner, outer, both, or "
      "'H_33 = FORMULA'. A membrane force N is N/2 on both faces. The "
      "formulas are those of 'Loads/Pressure distribution'. They act "
      "like initial stresses, but are not part of the stresses of "
      "plies. Unit: force/length.");
    add_choice(prm,
               "Thickness law",
               law,
               {"symmetric", "asymmetric", "full"},
               "How the thickness strain enters the stiffness: 'symmetric' "
               "(constant thickness stress, eliminated; free of locking), "
               "'asymmetric' (the paper's law, with an unsymmetric tangent) "
               "or 'full' (three-dimensional law; locks in bending).");
    add_parsed(prm,
               "Laminate/",
               "Transverse shear",
               "constant strain",
               shear_law,
               parse_transverse_shear,
               "How the transverse shear strains of the faces enter the "
               "stiffness: 'constant strain' (the paper's law; too stiff, by "
               "1/5 for a homogeneous shell and more for thick laminates), "
               "'equilibrium' (the stiffness of the shear stresses in "
               "equilibrium with the bending stresses of the plies; 5/6 of "
               "'constant strain' for a homogeneous shell), or a factor, a "
               "number or formula above 0 and at most 1 such as 5/6, by which "
               "'constant strain' is multiplied.");
    add_parsed(prm,
               "Laminate/",
               "Reference surface",
               "inner",
               reference,
               parse_thickness_position,
               "The surface of the shell that 'Surface' describes: "
               "'inner', 'middle', 'outer', 'ply N' (the outer side of "
               "ply N, counted from the inner face), or its distance "
               "from the inner face. Unit: length.");
  }


  namespace
  {
    /** Split "from A to B" off the end of the text of a ply, if present. */
    std::pair<double, double>
    take_range(const std::string &entry,
               const std::string &text,
               std::string       &angle)
    {
      const double infinity = std::numeric_limits<double>::infinity();
      const auto   from     = angle.find(" from ");
      if (from == std::string::npos)
        return {-infinity, infinity};
      const std::string form =
        "the covered part must have the form 'from A to B' with numbers A < B";
      const std::vector<std::string> words =
        split_words(angle.substr(from + 6));
      if (words.size() != 3 || words[1] != "to")
        throw InputError(entry, text, form);
      const double begin = parse_number(entry, words[0], form);
      const double end   = parse_number(entry, words[2], form);
      if (!(begin < end))
        throw InputError(entry, text, form);
      angle.erase(from);
      return {begin, end};
    }
  } // namespace


  std::vector<PlyParameters>
  parse_plies(const std::string &entry, const std::string &text)
  {
    const std::string form = "each ply must have the form 'material: "
                             "thickness @ angle'";

    std::vector<PlyParameters> plies;
    for (const std::string &item : split_list(entry, text, ',', 1000))
      {
        const auto colon = item.find(':');
        const auto at    = item.find('@');
        if (colon == std::string::npos || at == std::string::npos || at < colon)
          throw InputError(entry, item, form);
        std::string       angle = item.substr(at + 1);
        const auto        range = take_range(entry, item, angle);
        const std::string thickness =
          Utilities::trim(item.substr(colon + 1, at - colon - 1));
        angle = Utilities::trim(angle);
        if (thickness.empty() || angle.empty())
          throw InputError(entry, item, form);
        plies.push_back({item,
                         Utilities::trim(item.substr(0, colon)),
                         Formula(entry, thickness),
                         Formula(entry, angle),
                         range.first,
                         range.second});
      }
    if (plies.empty())
      throw InputError(entry, text, form + ", and there must be one");
    return plies;
  }


  ThicknessPosition
  parse_thickness_position(const std::string &entry, const std::string &text)
  {
    using Kind             = ThicknessPosition::Kind;
    const std::string form = "it must be 'inner', 'middle', 'outer', 'ply N' "
                             "with N from 1, or a number";
    if (text == "inner")
      return {Kind::fraction, 0};
    if (text == "middle")
      return {Kind::fraction, 0.5};
    if (text == "outer")
      return {Kind::fraction, 1};
    if (text.rfind("ply ", 0) == 0)
      {
        const double n = parse_number(entry, text.substr(4), form);
        if (!(n >= 1 && n <= 1000 && n == std::floor(n)))
          throw InputError(entry, text, form);
        return {Kind::ply, n};
      }
    return {Kind::distance, parse_number(entry, text, form)};
  }


  PlyStresses
  parse_ply_stresses(const std::string &entry, const std::string &text)
  {
    PlyStresses stresses;
    for (const std::string &item : split_list(entry, text, ',', 1000))
      {
        const std::vector<std::string> words = split_words(item);
        if (words.size() != 3)
          throw InputError(entry,
                           item,
                           "each ply must have a triple 'sigma_L sigma_T "
                           "tau_LT'");
        stresses.push_back({{Formula(entry, words[0]),
                             Formula(entry, words[1]),
                             Formula(entry, words[2])}});
      }
    return stresses;
  }


  std::vector<InitialResultant>
  parse_initial_resultants(const std::string &entry, const std::string &text)
  {
    const std::string form =
      "each item must have the form 'H_ij FACE = FORMULA' with ij one of 11, "
      "22, 12, 13, 23 and FACE one of inner, outer, both, or 'H_33 = FORMULA'";
    const std::vector<std::string> tangential{"H_11", "H_22", "H_12"};
    const std::vector<std::string> transverse{"H_13", "H_23"};

    std::vector<InitialResultant> resultants;
    for (const std::string &item : split_list(entry, text, ';', 100))
      {
        const auto                     equals = item.find('=');
        const std::vector<std::string> words =
          split_words(item.substr(0, equals));
        if (equals == std::string::npos || equals + 1 == item.size() ||
            words.empty())
          throw InputError(entry, item, form);
        const Formula value = parse_position_formula(
          entry, Utilities::trim(item.substr(equals + 1)));
        if (words.size() == 1 && words[0] == "H_33")
          {
            resultants.push_back({Resultants::thickness, value});
            continue;
          }
        if (words.size() != 2 ||
            (words[1] != "inner" && words[1] != "outer" && words[1] != "both"))
          throw InputError(entry, item, form);
        const auto t =
          std::find(tangential.begin(), tangential.end(), words[0]);
        const auto s =
          std::find(transverse.begin(), transverse.end(), words[0]);
        if (t == tangential.end() && s == transverse.end())
          throw InputError(entry, item, form);
        for (const auto face : {Resultants::inner, Resultants::outer})
          if (words[1] == "both" ||
              (words[1] == "inner") == (face == Resultants::inner))
            resultants.push_back(
              {t != tangential.end()
                 ? Resultants::tangential(t - tangential.begin(), face)
                 : Resultants::transverse(s - transverse.begin(), face),
               value});
      }
    return resultants;
  }


  void
  Layup::Parameters::check(
    const std::vector<Material::Parameters> &materials) const
  {
    std::string names;
    for (const Material::Parameters &material : materials)
      names += (names.empty() ? "'" : ", '") + material.name + "'";
    for (const PlyParameters &ply : plies)
      {
        const auto material =
          std::find_if(materials.begin(), materials.end(), [&](const auto &m) {
            return m.name == ply.material;
          });
        if (material == materials.end())
          throw InputError(
            "Laminate/Plies", ply.text, "its material must be one of " + names);
        material->stiffness();
        material->get_strengths();
        for (Formula formula : {ply.thickness, ply.angle})
          MeridionalTables::bind(formula, tables);
      }

    if (!initial_stresses.empty() && initial_stresses.size() != plies.size())
      {
        std::string text;
        for (const auto &triple : initial_stresses)
          text += (text.empty() ? "" : ", ") + triple[0].get_text() + " " +
                  triple[1].get_text() + " " + triple[2].get_text();
        throw InputError("Laminate/Initial ply stresses",
                         text,
                         "it must contain one triple 'sigma_L sigma_T tau_LT' "
                         "per ply (" +
                           std::to_string(plies.size()) +
                           " plies), separated by commas");
      }
    for (const auto &triple : initial_stresses)
      for (Formula formula : triple)
        MeridionalTables::bind(formula, tables);

    if (reference.kind == ThicknessPosition::Kind::ply &&
        reference.value > plies.size())
      throw InputError("Laminate/Reference surface",
                       "ply " + number_to_string(reference.value),
                       "N must lie between 1 and " +
                         std::to_string(plies.size()));
  }


  Layup::Layup(const Parameters                        &parameters,
               const std::vector<Material::Parameters> &materials)
    : law(parameters.law)
    , shear_law(parameters.shear_law)
    , reference(parameters.reference)
    , initial_resultants(parameters.initial_resultants)
  {
    parameters.check(materials);
    const MeridionalTables tables(parameters.tables);
    for (unsigned int p = 0; p < parameters.plies.size(); ++p)
      {
        const PlyParameters &given = parameters.plies[p];
        const auto           material =
          std::find_if(materials.begin(), materials.end(), [&](const auto &m) {
            return m.name == given.material;
          });
        PlyDescription ply;
        ply.text           = given.text;
        ply.material       = given.material;
        ply.stiffness      = material->stiffness();
        ply.strengths      = material->get_strengths();
        ply.thickness      = tables.function(given.thickness);
        const auto degrees = tables.function(given.angle);
        ply.angle          = [degrees](const double alpha_1) {
          return degrees(alpha_1) * numbers::PI / 180;
        };
        ply.begin = given.begin;
        ply.end   = given.end;
        if (!parameters.initial_stresses.empty())
          {
            const auto &triple = parameters.initial_stresses[p];
            const auto  L      = tables.function(triple[0]);
            const auto  T      = tables.function(triple[1]);
            const auto  LT     = tables.function(triple[2]);
            ply.initial_stress = [L, T, LT](const double alpha_1) {
              SymmetricTensor<2, 3> stress;
              stress[0][0] = L(alpha_1);
              stress[1][1] = T(alpha_1);
              stress[0][1] = LT(alpha_1);
              return stress;
            };
          }
        plies.push_back(ply);
      }
  }


  namespace
  {
    /** The height of a position above the inner face, in given plies. */
    double
    height(const ThicknessPosition &position, const std::vector<Ply> &plies)
    {
      double thickness = 0, below = 0;
      for (const Ply &ply : plies)
        {
          thickness += ply.thickness;
          if (ply.number < position.value)
            below += ply.thickness;
        }
      switch (position.kind)
        {
          case ThicknessPosition::Kind::fraction:
            return position.value * thickness;
          case ThicknessPosition::Kind::ply:
            return below;
          case ThicknessPosition::Kind::distance:
            return position.value;
        }
      Assert(false, ExcInternalError());
      return 0;
    }
  } // namespace


  Laminate
  Layup::laminate(const double alpha_1, const double within) const
  {
    std::vector<Ply> present;
    for (unsigned int p = 0; p < plies.size(); ++p)
      {
        const PlyDescription &ply = plies[p];
        if (within < ply.begin || within > ply.end)
          continue;
        const double thickness = ply.thickness(alpha_1);
        if (!(thickness > 0))
          throw InputError("Laminate/Plies",
                           ply.text,
                           "a thickness must be positive, and at alpha_1 = " +
                             number_to_string(alpha_1) + " it is " +
                             number_to_string(thickness));
        present.push_back({ply.stiffness,
                           thickness,
                           ply.angle(alpha_1),
                           ply.initial_stress ? ply.initial_stress(alpha_1)
                                              : SymmetricTensor<2, 3>(),
                           p});
      }
    if (present.empty())
      throw InputError(
        "no ply of the entry 'Laminate/Plies' covers alpha_1 = " +
        number_to_string(within) + ".");
    const double reference_height = height(reference, present);
    return Laminate(std::move(present), law, reference_height, shear_law);
  }
} // namespace Biface
