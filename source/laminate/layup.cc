// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/numbers.h>
#include <deal.II/base/utilities.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <utility>

#include <biface/base/errors.h>
#include <biface/input/entry_declarations.h>
#include <biface/input/parameter_tools.h>
#include <biface/input/read_file.h>
#include <biface/laminate/layup.h>

namespace Biface
{
  using namespace dealii;

  void
  Layup::Parameters::add_parameters(EntryDeclarations &prm)
  {
    // texts are parsed as they are read, so that a message names the entry; the
    // names in them are known only to check()
    add_parsed(prm,
               "Plies",
               "cord: 1.2 @ 52, cord: 1.2 @ -52, cord: 1.2 @ 52, "
               "cord: 1.2 @ -52",
               plies,
               parse_plies,
               "The plies, inner ply first, separated by commas, each "
               "as 'material: thickness @ angle', followed by 'from A "
               "to B' if the ply covers only this part of alpha_1 "
               "(between two mesh lines; the jump in thickness is "
               "spread over the cells on both sides; both may be formulas "
               "of 'end', the largest alpha_1 of the surface). The angle "
               "of the material's first axis is measured from the first "
               "coordinate line (the meridian) toward the second, see "
               "'Angle reference'. An angle '+-A' means two plies, at A and "
               "-A, and 'N x (...)' repeats the plies in parentheses. "
               "Thickness and angle are numbers, or formulas of "
               "alpha_1 and of the 'Tables', such as 1.2 + "
               "0.01*abs(alpha_1). On a surface of revolution they know "
               "'end', the radius r of the reference surface and the function "
               "lift(A), the angle of cords that have the angle A at the "
               "crown, the largest radius of the mesh, and pantograph: "
               "the cosine of their angle from the circumference is "
               "proportional to r. With the meridian 'cord equilibrium' "
               "they know its crown cord angle beta_c.",
               Unit::several("length, degrees, alpha_1 as in 'Mesh'"));
    add_parsed(
      prm,
      "Plies file",
      "",
      plies_file,
      parse_file_name,
      "A CSV file with the plies instead of 'Plies': a line for each, "
      "inner ply first, 'material, thickness, angle' or 'material, "
      "thickness, angle, from, to', after a line of these names, which may "
      "be missing; lines that start with '#' are comments. The "
      "cells are as in 'Plies'; those with a comma outside of "
      "parentheses stand in double quotes. In parameters.prm the "
      "plies are those of 'Plies', and so they are in 'Study' and "
      "'Sensitivities'. Relative to the parameter file.");
    add_choice(prm,
               "Angle reference",
               angle_reference,
               {"meridian", "circumference"},
               "The direction from which the angles in 'Plies' are counted: "
               "'meridian', from alpha_1 toward alpha_2, or 'circumference', "
               "from alpha_2 toward alpha_1, as usual for tires.");
    add_parsed(prm,
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
               "stands for the byte with this hexadecimal number.",
               // the contents of the files are compared
               RestartChange::always);
    add_parsed(prm,
               "Initial ply stresses",
               "",
               initial_stresses,
               parse_ply_stresses,
               "Initial stresses in the undeformed shell, one triple "
               "'sigma_L sigma_T tau_LT' per ply, inner ply first, separated "
               "by commas; empty for none. Each is a number or a formula, "
               "without blanks, as in 'Plies'. They act only through the "
               "nonlinear part of the strains: the loads that balance them "
               "in the undeformed shell are not part of the model.",
               Unit("force/area"));
    add_parsed(
      prm,
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
      "plies.",
      Unit("force/length"));
    add_choice(prm,
               "Thickness law",
               law,
               {"symmetric", "asymmetric", "full"},
               "How the thickness strain enters the stiffness: 'symmetric' "
               "(constant thickness stress, eliminated; free of locking), "
               "'asymmetric' (the paper's law, with an unsymmetric tangent) "
               "or 'full' (three-dimensional law; locks in bending).");
    add_parsed(prm,
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
               "Gradient factor",
               "by layers",
               gradient_factor,
               parse_gradient_factor,
               "Multiplies the stiffness of each layer against opposite "
               "transverse shear strains of its faces, those of a gradient of "
               "the thickness strain, which keeps a face that is compressed "
               "from wrinkling on cells shorter than the layer is thick: a "
               "number from 1 (the law itself) to 1000, or 'by layers', 8 if "
               "there are several 'Layers', 1 otherwise.");
    add_parsed(
      prm,
      "Layers",
      "one",
      layers,
      parse_layers,
      "The layers of the wall, in each of which displacements are "
      "linear in the height, so that L layers have L + 1 faces: 'one' "
      "of all plies; 'one per ply' or 'N per ply'; or the number of "
      "plies in each layer, inner layer first, separated by commas. "
      "Numbers may be fractions, such as 4, 1/2, 1/2: a ply is divided "
      "there. A soft ply next to a stiff one, such as a tread or the "
      "core of a sandwich, needs a layer of its own. With several "
      "layers, the transverse shear strain of each has its own "
      "stiffness, see 'Transverse shear'.");
    add_choice(
      prm,
      "Integrals",
      integrals,
      {"plate", "shell"},
      "The lengths and areas over which plies are integrated: "
      "'plate', the same over the thickness, as in Grigolyuk, Kulikov "
      "and Plotnikova (2004), or 'shell', which grow with the distance "
      "from the centers of curvature: it matters for plies of different "
      "stiffness on the two sides of a thick wall, by terms of the "
      "order of the thickness over the radius.");
    add_parsed(prm,
               "Reference surface",
               "inner",
               reference,
               parse_thickness_position,
               "The surface of the shell that 'Surface' describes: "
               "'inner', 'middle', 'outer', 'ply N' (the outer side of "
               "ply N, counted from the inner face), or its distance "
               "from the inner face.",
               Unit("length"));
  }


  namespace
  {
    constexpr unsigned int max_plies = 1000;

    const std::string ply_form = "each ply must have the form 'material: "
                                 "thickness @ angle'";

    const std::string range_form = "the covered part must have the form 'from "
                                   "A to B' with numbers A < B";


    /** Split "from A to B" off the end of the angle of the ply @p text, if
     * present. */
    std::optional<std::pair<Coordinate, Coordinate>>
    take_range(const std::string &entry,
               const std::string &text,
               std::string       &angle)
    {
      const auto from = angle.find(" from ");
      if (from == std::string::npos)
        return {};
      const auto to = angle.find(" to ", from);
      if (to == std::string::npos)
        throw InputError(entry, text, range_form);
      const auto coordinate = [&](const std::size_t at,
                                  const std::size_t length) {
        return Coordinate(
          entry, Utilities::trim(angle.substr(at, length)), text, range_form);
      };
      const auto range = std::make_pair(coordinate(from + 6, to - from - 6),
                                        coordinate(to + 4, std::string::npos));
      if (!range.first.uses_end() && !range.second.uses_end() &&
          !(range.first.value(0) < range.second.value(0)))
        throw InputError(entry, text, range_form);
      angle.erase(from);
      return range;
    }


    /** Read a ply, or two with the angle '+-A' or '-+A'. */
    void
    parse_ply(const std::string          &entry,
              const std::string          &item,
              std::vector<PlyParameters> &plies)
    {
      const auto colon = item.find(':');
      const auto at    = item.find('@');
      if (colon == std::string::npos || at == std::string::npos || at < colon)
        throw InputError(entry, item, ply_form);
      std::string       angle = item.substr(at + 1);
      const auto        range = take_range(entry, item, angle);
      const std::string thickness =
        Utilities::trim(item.substr(colon + 1, at - colon - 1));
      angle = Utilities::trim(angle);
      if (thickness.empty() || angle.empty())
        throw InputError(entry, item, ply_form);

      std::vector<std::string> angles{angle};
      const std::string        signs = angle.substr(0, 2);
      if (signs == "+-" || signs == "-+")
        {
          const std::string size = Utilities::trim(angle.substr(2));
          if (size.empty())
            throw InputError(entry, item, ply_form);
          angles = {size, "-(" + size + ")"};
          if (signs == "-+")
            std::swap(angles[0], angles[1]);
        }
      for (const std::string &one : angles)
        {
          // as if written alone
          std::string text = item;
          if (angles.size() == 2)
            text.replace(item.find(angle, at), angle.size(), one);
          plies.push_back({text,
                           Utilities::trim(item.substr(0, colon)),
                           parse_ply_formula(entry, thickness),
                           parse_ply_formula(entry, one),
                           range});
        }
    }


    /** The number and the plies of 'N x (...)', if a text has this form. */
    std::optional<std::pair<unsigned int, std::string>>
    take_repeat(const std::string &entry, const std::string &text)
    {
      const auto cross = text.find_first_not_of("0123456789 \t");
      const auto open  = text.find('(');
      if (cross == 0 || cross == std::string::npos || text[cross] != 'x' ||
          open == std::string::npos ||
          Utilities::trim(text.substr(cross + 1, open - cross - 1)) != "")
        return {};
      const std::string form =
        "plies must be repeated as 'N x (...)' with N from 1 to " +
        std::to_string(max_plies);
      if (text.back() != ')')
        throw InputError(entry, text, form);
      const double n =
        parse_number(entry, Utilities::trim(text.substr(0, cross)), form);
      if (!(n >= 1 && n <= max_plies && n == std::floor(n)))
        throw InputError(entry, text, form);
      return std::make_pair(static_cast<unsigned int>(n),
                            text.substr(open + 1, text.size() - open - 2));
    }


    std::vector<PlyParameters>
    parse_ply_list(const std::string &entry,
                   const std::string &text,
                   const unsigned int depth)
    {
      std::vector<PlyParameters> plies;
      for (const std::string &item : split_list(entry, text, ',', max_plies))
        {
          const auto repeat = take_repeat(entry, item);
          if (!repeat)
            {
              parse_ply(entry, item, plies);
              continue;
            }
          if (depth == 10)
            throw InputError(
              entry, item, "repeats must not be nested more than ten times");
          const std::vector<PlyParameters> group =
            parse_ply_list(entry, repeat->second, depth + 1);
          if (group.empty())
            throw InputError(entry, item, "there must be plies to repeat");
          for (unsigned int i = 0; i < repeat->first; ++i)
            {
              plies.insert(plies.end(), group.begin(), group.end());
              if (plies.size() > max_plies)
                break;
            }
          if (plies.size() > max_plies)
            throw InputError(entry,
                             item,
                             "there must be at most " +
                               std::to_string(max_plies) + " plies");
        }
      return plies;
    }
  } // namespace


  std::vector<PlyParameters>
  parse_plies(const std::string &entry, const std::string &text)
  {
    const std::vector<PlyParameters> plies = parse_ply_list(entry, text, 0);
    if (plies.empty())
      throw InputError(entry, text, ply_form + ", and there must be one");
    return plies;
  }


  namespace
  {
    /** What separates the cells of a line of plies: formulas contain commas,
     * but neither semicolons nor tabs. */
    char
    separator_of_plies(const std::string &line)
    {
      if (line.find(';') != std::string::npos)
        return ';';
      const std::vector<std::string> cells = split_cells(line, '\t');
      // tabs beside commas are blanks
      return cells.size() > 1 && std::none_of(cells.begin(),
                                              cells.end(),
                                              [](const std::string &cell) {
                                                return !cell.empty() &&
                                                       (cell.front() == ',' ||
                                                        cell.back() == ',');
                                              })
               ? '\t'
               : ',';
    }
  } // namespace


  std::string
  plies_of_csv(const std::string &text, const std::string &name)
  {
    const std::string form =
      "each line must contain 'material, thickness, angle' or 'material, "
      "thickness, angle, from, to', separated by commas, semicolons or tabs, "
      "without '#', '@', ':' and backslashes";
    std::string plies;
    bool        header_allowed = true;
    for (const NumberedLine &line : lines_of_csv(text, name, form))
      {
        std::vector<std::string> cells;
        const char               separator = separator_of_plies(line.text);
        // spreadsheets write empty cells at the end
        const auto end = line.text.find_last_not_of(",; \t");
        for (std::string cell : split_list(
               line.place,
               line.text.substr(0, end == std::string::npos ? end : end + 1),
               separator))
          {
            if (cell.size() >= 2 && cell.front() == '"' && cell.back() == '"')
              cell = Utilities::trim(cell.substr(1, cell.size() - 2));
            if (separator != ',' && is_decimal_comma(cell))
              cell[cell.find(',')] = '.';
            cells.push_back(cell);
          }
        if (cells.empty())
          continue;
        const auto is = [&](const unsigned int i, const std::string &title) {
          std::string cell = cells.size() > i ? cells[i] : "";
          for (char &c : cell)
            c = std::tolower(static_cast<unsigned char>(c));
          return cell == title;
        };
        const bool is_header =
          header_allowed && is(0, "material") && is(1, "thickness");
        header_allowed = false;
        if (is_header)
          continue;
        if ((cells.size() != 3 && cells.size() != 5) ||
            line.text.find_first_of("#@:\\") != std::string::npos)
          throw InputError(line.place, line.text, form);
        const std::string ply =
          cells[0] + ": " + cells[1] + " @ " + cells[2] +
          (cells.size() == 5 ? " from " + cells[3] + " to " + cells[4] : "");
        parse_plies(line.place, ply);
        plies += (plies.empty() ? "" : ", ") + ply;
      }
    if (plies.empty())
      throw InputError(name + ": there must be a ply.");
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


  LayerDivision
  parse_layers(const std::string &entry, const std::string &text)
  {
    constexpr unsigned int max_layers = 100;
    constexpr double       least      = 1e-3;

    const InputError error(
      entry,
      text,
      "it must be 'one', 'one per ply', 'N per ply' with N from 1 to " +
        std::to_string(max_layers) + ", or the numbers of plies in at most " +
        std::to_string(max_layers) +
        " layers, each at least 0.001, separated by commas");
    // any fault of an item is answered by the sentence on the whole entry
    const auto number = [&](const std::string &item) {
      try
        {
          const double value = Formula(entry, item, {})({});
          if (value >= least && value <= max_plies)
            return value;
        }
      catch (const InputError &)
        {}
      throw error;
    };

    if (text == "one")
      return {};
    const std::vector<std::string> words = split_words(text);
    if (words.size() == 3 && words[1] == "per" && words[2] == "ply")
      {
        const double n = (words[0] == "one" ? 1. : number(words[0]));
        if (n != std::floor(n) || n > max_layers)
          throw error;
        return {static_cast<unsigned int>(n), {}};
      }
    LayerDivision layers;
    for (const std::string &item : split_list(entry, text, ',', max_layers))
      layers.n_plies.push_back(number(item));
    if (layers.n_plies.empty())
      throw error;
    return layers;
  }


  std::vector<double>
  LayerDivision::sides(const unsigned int n_plies_of_wall) const
  {
    std::vector<double> sides{0};
    if (per_ply)
      for (unsigned int i = 1; i <= n_plies_of_wall * *per_ply; ++i)
        sides.push_back(static_cast<double>(i) / *per_ply);
    else if (n_plies.empty())
      sides.push_back(n_plies_of_wall);
    else
      for (const double n : n_plies)
        {
          // no slivers from the rounding of fractions
          const double side    = sides.back() + n;
          const double rounded = std::round(side);
          sides.push_back(std::abs(side - rounded) < 1e-9 ? rounded : side);
        }
    return sides;
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
        stresses.push_back({{parse_ply_formula(entry, words[0]),
                             parse_ply_formula(entry, words[1]),
                             parse_ply_formula(entry, words[2])}});
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
        // the only one without a face
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
  Layup::Parameters::check(const std::vector<MaterialParameters> &materials,
                           const PlyVariables &variables) const
  {
    std::string names;
    for (const MaterialParameters &material : materials)
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
        // here, and not for all materials: those that no ply uses may be
        // incomplete
        material->check();
        if ((material->is_hyperelastic() || material->relaxes()) &&
            law != ThicknessLaw::symmetric)
          throw InputError("the entry 'Laminate/Thickness law' must be "
                           "'symmetric' with the law of the material '" +
                           material->name + "', which is not linear.");
        if (material->has_slack_cords() && !initial_resultants.empty())
          throw InputError("the entry 'Laminate/Initial resultants' must be "
                           "empty with cords that go slack ('Material " +
                           material->name +
                           "/E_L compression'), since these resultants are "
                           "not those of single plies; use 'Laminate/Initial "
                           "ply stresses' instead.");
        material->get_strengths();
        material->get_density();
        if (material->get_loss_factor() > 0 && material->is_hyperelastic())
          throw InputError("the entry 'Material " + material->name +
                           "/Loss factor' may only be given with a linear "
                           "law.");
        for (Formula formula : {ply.thickness, ply.angle})
          variables.bind(formula, tables);
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
        variables.bind(formula, tables);

    if (reference.kind == ThicknessPosition::Kind::ply &&
        reference.value > plies.size())
      throw InputError("Laminate/Reference surface",
                       "ply " + number_to_string(reference.value),
                       "N must lie between 1 and " +
                         std::to_string(plies.size()));
    check_layers();
  }


  void
  Layup::Parameters::check_layers() const
  {
    constexpr unsigned int max_layers = 100;

    const std::vector<double> sides    = layers.sides(plies.size());
    const unsigned int        n_layers = sides.size() - 1;
    if (sides.back() != plies.size())
      throw InputError("the entry 'Laminate/Layers' must contain all plies of "
                       "'Laminate/Plies', " +
                       std::to_string(plies.size()) + ", but contains " +
                       number_to_string(sides.back()) + ".");
    if (n_layers > max_layers)
      throw InputError("the entry 'Laminate/Layers' divides the wall into " +
                       std::to_string(n_layers) + " layers, but at most " +
                       std::to_string(max_layers) + " are allowed.");
    if (n_layers == 1)
      return;
    if (law == ThicknessLaw::asymmetric)
      throw InputError(
        "the entry 'Laminate/Thickness law' must be 'symmetric' or 'full' with "
        "several layers ('Laminate/Layers'): the thickness stress would "
        "converge to a wrong limit with 'asymmetric'.");
    if (shear_law.kind == TransverseShearLaw::Kind::factor)
      throw InputError(
        "the entry 'Laminate/Transverse shear' must be 'constant strain' or "
        "'equilibrium' with several layers ('Laminate/Layers'): the deflection "
        "would converge to a wrong limit with a factor.");
    if (!initial_resultants.empty())
      throw InputError(
        "the entry 'Laminate/Initial resultants' must be empty with several "
        "layers ('Laminate/Layers'), since these resultants are those of the "
        "whole wall; use 'Laminate/Initial ply stresses' instead.");
  }


  namespace
  {
    /** An angle in degrees as that from e_1 toward e_2 in radians, between
     * -90 and 90 degrees if @p reference is the circumference. */
    double
    angle_from_meridian(const double angle, const AngleReference reference)
    {
      return (reference == AngleReference::meridian
                ? angle
                : std::remainder(90 - angle, 180)) *
             numbers::PI / 180;
    }


    /** The distance of the cords by alpha_1, see CordAndRubber::cord_pitch. */
    std::function<double(const double)>
    make_cord_pitch(const CordAndRubber                       &material,
                    const std::function<double(const double)> &angle,
                    const SurfaceOfPlies                      &surface)
    {
      // On a surface of revolution the number of cords is the same everywhere,
      // on other surfaces, and along the circumference, the distance.
      const double at_crown = material.cord_pitch;
      const double sine     = std::abs(std::cos(angle(surface.crown)));
      if (!surface.radius || sine < 1e-6)
        return [at_crown](const double) { return at_crown; };
      const double factor = at_crown / (surface.radius(surface.crown) * sine);
      return [factor, angle, radius = surface.radius](const double alpha_1) {
        return factor * radius(alpha_1) * std::abs(std::cos(angle(alpha_1)));
      };
    }


    /** Let a ply with the thickness and angle given consist of cords in
     * rubber. */
    void
    set_cords(const MaterialParameters &material,
              const SurfaceOfPlies     &surface,
              PlyDescription           &ply)
    {
      const CordAndRubber &cords = material.cord_and_rubber;
      ply.cord_pitch             = make_cord_pitch(cords, ply.angle, surface);
      // pitch times thickness is constant as the volume of the rubber
      if (cords.thickness == CordAndRubber::Thickness::constant_volume)
        ply.thickness = [given    = ply.thickness,
                         pitch    = ply.cord_pitch,
                         at_crown = cords.cord_pitch](const double alpha_1) {
          return given(alpha_1) * at_crown / pitch(alpha_1);
        };
      ply.laws = [material,
                  text      = ply.text,
                  pitch     = ply.cord_pitch,
                  thickness = ply.thickness](
                   const double                 alpha_1,
                   const SymmetricTensor<2, 3> &initial_stress) {
        const CordAndRubber &cords = material.cord_and_rubber;
        const double         t = thickness(alpha_1), P = pitch(alpha_1);
        if (!(P > cords.cord_diameter && t > cords.cord_diameter))
          throw InputError("Laminate/Plies",
                           text,
                           "at alpha_1 = " + number_to_string(alpha_1) +
                             " its cords of the diameter " +
                             number_to_string(cords.cord_diameter) +
                             " have the distance " + number_to_string(P) +
                             " in the thickness " + number_to_string(t) +
                             ", but both must be greater than the diameter");
        return material.laws(cords.cord_area() / (P * t), initial_stress);
      };
    }
  } // namespace


  Layup::Layup(const Parameters                      &parameters,
               const std::vector<MaterialParameters> &materials,
               const SurfaceOfPlies                  &surface)
    : sides_of_layers(parameters.layers.sides(parameters.plies.size()))
    , law(parameters.law)
    , shear_law(parameters.shear_law_of_layers())
    , curvature(parameters.integrals == ThicknessIntegrals::shell
                  ? surface.curvature
                  : nullptr)
    , reference(parameters.reference)
    , initial_resultants(parameters.initial_resultants)
  {
    parameters.check(materials,
                     {static_cast<bool>(surface.radius),
                      surface.crown_cord_angle.has_value()});
    const AngleReference   angle_reference = parameters.angle_reference;
    const MeridionalTables tables(parameters.tables, surface, angle_reference);
    for (unsigned int p = 0; p < parameters.plies.size(); ++p)
      {
        const PlyParameters &given = parameters.plies[p];
        const auto           material =
          std::find_if(materials.begin(), materials.end(), [&](const auto &m) {
            return m.name == given.material;
          });
        // functions of a ply own copies of all they need, so that a layup
        // outlives its parameters
        PlyDescription ply;
        ply.text            = given.text;
        ply.material        = given.material;
        ply.strengths       = material->get_strengths();
        ply.density         = material->get_density();
        ply.loss_factor     = material->get_loss_factor();
        ply.conductivity    = material->get_thermal_conductivity();
        ply.has_fibers      = !material->is_isotropic();
        ply.has_slack_cords = material->has_slack_cords();
        ply.is_hyperelastic = material->is_hyperelastic();
        ply.relaxes         = material->relaxes();
        ply.thickness       = tables.function(given.thickness);
        const auto degrees  = tables.function(given.angle);
        ply.angle           = [degrees, angle_reference](const double alpha_1) {
          return angle_from_meridian(degrees(alpha_1), angle_reference);
        };
        if (material->type == MaterialParameters::Type::cord_and_rubber)
          set_cords(*material, surface, ply);
        else
          ply.laws = [material = *material](
                       const double, const SymmetricTensor<2, 3> &initial) {
            return material.laws(0, initial);
          };
        if (given.range)
          {
            ply.begin = given.range->first.value(surface.end);
            ply.end   = given.range->second.value(surface.end);
            if (!(ply.begin < ply.end))
              throw InputError("Laminate/Plies", given.text, range_form);
          }
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


  std::vector<Ply>
  Layup::plies_at(const double alpha_1, const double within) const
  {
    std::vector<Ply> present;
    for (unsigned int p = 0; p < plies.size(); ++p)
      {
        const PlyDescription &ply = plies[p];
        // at the end of a ply, this selects the side
        if (within < ply.begin || within > ply.end)
          continue;
        const double thickness = ply.thickness(alpha_1);
        if (!(thickness > 0))
          throw InputError("Laminate/Plies",
                           ply.text,
                           "a thickness must be positive, and at alpha_1 = " +
                             number_to_string(alpha_1) + " it is " +
                             number_to_string(thickness));
        const SymmetricTensor<2, 3> initial_stress =
          ply.initial_stress ? ply.initial_stress(alpha_1)
                             : SymmetricTensor<2, 3>();
        const PlyLaws laws = ply.laws(alpha_1, initial_stress);
        present.push_back({laws.stiffness,
                           thickness,
                           ply.angle(alpha_1),
                           initial_stress,
                           p,
                           ply.cord_pitch ? ply.cord_pitch(alpha_1) : 0,
                           laws.cords,
                           laws.rubber,
                           laws.relaxation,
                           ply.density,
                           ply.loss_factor});
      }
    if (present.empty())
      throw InputError(
        "no ply of the entry 'Laminate/Plies' covers alpha_1 = " +
        number_to_string(within) + ".");
    return present;
  }


  Laminate
  Layup::laminate(const double alpha_1, const double within) const
  {
    std::vector<Ply> present          = plies_at(alpha_1, within);
    const double     reference_height = height(reference, present);
    return Laminate(std::move(present),
                    law,
                    reference_height,
                    shear_law,
                    curvature ? curvature(alpha_1)
                              : std::array<double, 2>{{0, 0}},
                    {},
                    along_normal);
  }


  std::vector<std::optional<Laminate>>
  Layup::layers(const double alpha_1, const double within) const
  {
    const std::vector<Ply> present          = plies_at(alpha_1, within);
    const double           reference_height = height(reference, present);

    const std::array<double, 2> at =
      (curvature ? curvature(alpha_1) : std::array<double, 2>{{0, 0}});

    std::vector<std::vector<Ply>> parts(n_layers());
    std::vector<Ply>              all;
    for (unsigned int k = 0; k < n_layers(); ++k)
      for (Ply ply : present)
        {
          ply.begin = std::max(0., sides_of_layers[k] - ply.number);
          ply.end   = std::min(1., sides_of_layers[k + 1] - ply.number);
          if (!(ply.begin < ply.end))
            continue;
          ply.thickness *= ply.end - ply.begin;
          parts[k].push_back(ply);
          all.push_back(ply);
        }

    // equilibrium with bending is that of the whole wall, of whose distribution
    // of shear each layer takes its part
    WallOfLayer wall;
    double      h = 0;
    if (n_layers() > 1)
      {
        const Laminate undivided(
          std::move(all), law, reference_height, shear_law, at);
        h          = undivided.thickness();
        wall.shear = std::make_shared<const TransverseShear>(
          undivided.get_transverse_shear());
      }
    std::vector<std::optional<Laminate>> result;
    for (std::vector<Ply> &part : parts)
      {
        if (part.empty())
          {
            result.emplace_back();
            continue;
          }
        const unsigned int n_plies = part.size();
        result.emplace_back(Laminate(std::move(part),
                                     law,
                                     reference_height - wall.height_below,
                                     shear_law,
                                     at,
                                     wall,
                                     along_normal));
        const double thickness = result.back()->thickness();
        if (thickness < 1e-6 * h)
          throw InputError("the entry 'Laminate/Layers' makes layer " +
                           std::to_string(result.size()) + " " +
                           number_to_string(thickness) +
                           " thick at alpha_1 = " + number_to_string(alpha_1) +
                           ", but a layer must have at least a millionth of "
                           "the thickness of the wall, " +
                           number_to_string(h) + ".");
        wall.n_below += n_plies;
        wall.height_below += thickness;
      }
    return result;
  }


  bool
  Layup::has_fibers() const
  {
    return std::any_of(plies.begin(), plies.end(), [](const auto &ply) {
      return ply.has_fibers;
    });
  }


  bool
  Layup::has_cords() const
  {
    return std::any_of(plies.begin(), plies.end(), [](const auto &ply) {
      return static_cast<bool>(ply.cord_pitch);
    });
  }


  bool
  Layup::has_slack_cords() const
  {
    return std::any_of(plies.begin(), plies.end(), [](const auto &ply) {
      return ply.has_slack_cords;
    });
  }


  bool
  Layup::relaxes() const
  {
    return std::any_of(
      plies.begin(), plies.end(), [](const auto &ply) { return ply.relaxes; });
  }


  bool
  Layup::is_hyperelastic() const
  {
    return std::any_of(plies.begin(), plies.end(), [](const auto &ply) {
      return ply.is_hyperelastic;
    });
  }


  bool
  Layup::has_loss() const
  {
    return std::any_of(plies.begin(), plies.end(), [](const auto &ply) {
      return ply.loss_factor > 0 || ply.relaxes;
    });
  }
} // namespace Biface
