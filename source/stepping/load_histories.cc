// SPDX-License-Identifier: LGPL-2.1-or-later

#include <algorithm>

#include <biface/base/errors.h>
#include <biface/input/entry_declarations.h>
#include <biface/input/parameter_tools.h>
#include <biface/stepping/load_histories.h>

namespace Biface
{
  using namespace dealii;

  namespace
  {
    std::vector<std::pair<std::string, Formula>>
    parse_histories(const std::string &entry, const std::string &text)
    {
      std::vector<std::pair<std::string, Formula>> histories;
      for (const std::string &item : split_list(entry, text, ';'))
        {
          const auto [name, formula] = split_named(
            entry, item, "each item must have the form 'name: formula of t'");
          std::string words;
          for (const std::string &word : split_words(name))
            words += (words.empty() ? "" : " ") + word;
          for (const auto &other : histories)
            if (other.first == words)
              throw InputError(entry, words, "it is given twice");
          histories.emplace_back(words, Formula(entry, formula));
        }
      return histories;
    }
  } // namespace


  void
  LoadHistories::add_parameters(EntryDeclarations &prm)
  {
    add_parsed(
      prm,
      "Load history",
      "",
      formulas,
      parse_histories,
      "Loads of a stage with inertia as formulas of the time t since its "
      "start: a list of 'name: formula', separated by semicolons. A name is "
      "'pressure', 'travel', 'turn', 'load factor', one of those of 'Load "
      "factors' or 'Forces on bodies', or, of a wheel that rolls, 'angular "
      "velocity', 'ground velocity', 'slip angle' or 'axle moment': 'load "
      "factor: sin(200*t)'. They replace "
      "the values of these names; all other loads change evenly in the stage, "
      "but for 'Forces on bodies' and 'Axle moment', which are constant.",
      RestartChange::within_stage);
    add_parsed(
      prm,
      "History tables",
      "",
      tables,
      [](const std::string &entry, const std::string &text) {
        return parse_tables(entry, text, "t");
      },
      "Tables for the formulas of 'Load history', where their names stand for "
      "their values at the time t: a list of 'name: file', separated by commas. "
      "Each CSV file has rows 't, value' with increasing t; values are "
      "interpolated linearly and constant beyond the ends. With 'road: "
      "road.csv', the history 'travel: 10 + 2*road'. Paths are relative to the "
      "parameter file; see 'Laminate/Tables' for names in double quotes.",
      RestartChange::within_stage);
  }


  void
  LoadHistories::read_tables(const std::string &section,
                             const MPI_Comm     communicator)
  {
    if (!tables.empty() && formulas.empty())
      throw InputError(section + "/History tables",
                       tables.front().name,
                       "it needs a 'Load history' that uses the tables");
    std::vector<std::string> variables{"t"};
    interpolated.clear();
    for (TableFile &table : tables)
      {
        table.file.read("t, value", communicator);
        interpolated.push_back(interpolate(table.file, "t"));
        variables.push_back(table.name);
      }
    for (auto &[name, formula] : formulas)
      formula.bind(variables);
  }


  std::vector<std::string>
  LoadHistories::names() const
  {
    std::vector<std::string> result;
    for (const auto &[name, formula] : formulas)
      result.push_back(name);
    return result;
  }


  bool
  LoadHistories::has(const std::string &name) const
  {
    return std::any_of(formulas.begin(), formulas.end(), [&](const auto &item) {
      return item.first == name;
    });
  }


  std::optional<double>
  LoadHistories::value(const std::string &name, const double t) const
  {
    for (const auto &[other, formula] : formulas)
      if (other == name)
        {
          std::vector<double> values{t};
          for (const InterpolatedTable &table : interpolated)
            values.push_back(table->value(Point<1>(t)));
          return formula(values);
        }
    return {};
  }
} // namespace Biface
