// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/utilities.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>

#include <biface/base/errors.h>
#include <biface/input/parameter_tools.h>
#include <biface/input/read_file.h>
#include <biface/laminate/meridional_tables.h>
#include <biface/laminate/ply_parameters.h>
#include <biface/laminate/resultants.h>

namespace Biface
{
  using namespace dealii;

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


    /** Take "in GROUP" off the end of the angle of the ply @p text, if
     * present. */
    std::string
    take_group(const std::string &entry,
               const std::string &text,
               std::string       &angle)
    {
      const auto in = (angle + ' ').find(" in ");
      if (in == std::string::npos)
        return {};
      std::string group =
        Utilities::trim(angle.substr(std::min(in + 4, angle.size())));
      // a name that contains commas or parentheses
      if (!group.empty() && group.front() == '"')
        {
          if (group.size() < 2 || group.back() != '"')
            throw InputError(entry,
                             text,
                             "a name that begins with a quote must end with "
                             "one; '#' begins a comment, also in quotes");
          group = group.substr(1, group.size() - 2);
        }
      if (group.empty())
        throw InputError(entry,
                         text,
                         "the covered part must have the form 'in GROUP' with "
                         "the name of a group of cells");
      angle.erase(in);
      return group;
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
      const std::string group = take_group(entry, item, angle);
      const auto        range = take_range(entry, item, angle);
      const std::string thickness =
        Utilities::trim(item.substr(colon + 1, at - colon - 1));
      angle = Utilities::trim(angle);
      if (thickness.empty() || angle.empty())
        throw InputError(entry, item, ply_form);

      // '+-A' stands for two plies of this thickness each
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
                           range,
                           group});
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


  std::pair<double, double>
  PlyParameters::covered_part(const double end) const
  {
    if (!range)
      return {-std::numeric_limits<double>::infinity(),
              std::numeric_limits<double>::infinity()};
    const auto part =
      std::make_pair(range->first.value(end), range->second.value(end));
    if (!(part.first < part.second))
      throw InputError("Laminate/Plies", text, range_form);
    return part;
  }


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
      "each line must contain 'material, thickness, angle', 'material, "
      "thickness, angle, group' or 'material, thickness, angle, from, to', "
      "separated by commas, semicolons or tabs, "
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
          // a unit may follow
          return Utilities::trim(cell.substr(0, cell.find_first_of("[("))) ==
                 title;
        };
        const bool is_header = header_allowed && is(0, "material") &&
                               (is(1, "thickness") || is(1, "angle"));
        header_allowed = false;
        if (is_header && is(1, "thickness") &&
            (cells.size() < 3 || is(2, "angle")))
          continue;
        if (is_header || cells.size() < 3 || cells.size() > 5 ||
            line.text.find_first_of("#@:\\") != std::string::npos)
          throw InputError(line.place, line.text, form);
        const std::string ply =
          cells[0] + ": " + cells[1] + " @ " + cells[2] +
          (cells.size() == 5   ? " from " + cells[3] + " to " + cells[4]
           : cells.size() == 4 ? " in \"" + cells[3] + '"'
                               : "");
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
} // namespace Biface
