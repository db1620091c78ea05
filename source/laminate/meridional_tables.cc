// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/utilities.h>

#include <array>
#include <vector>

#include <biface/base/errors.h>
#include <biface/input/formula.h>
#include <biface/input/parameter_tools.h>
#include <biface/input/read_file.h>
#include <biface/laminate/meridional_tables.h>

namespace Biface
{
  using namespace dealii;

  MeridionalTables::MeridionalTables(const std::string &list,
                                     const MPI_Comm     communicator)
  {
    const std::string entry = "Laminate/Tables";
    check_list_length(entry, list, 1000);

    for (const std::string &text : Utilities::split_string_list(list, ','))
      {
        const std::string form = "each table must have the form 'name: file'";
        const auto        item = split_named(entry, text, form);
        if (item.second.empty())
          throw InputError(entry, text, form);
        check_name(item.first);
        const auto pairs = parse_pairs(
          read_file(item.second, communicator), item.second, "alpha_1, value");
        if (pairs.size() < 2)
          throw InputError(item.second +
                           ": the table needs at least two rows to "
                           "interpolate.");

        std::vector<double>      alpha;
        dealii::Table<1, double> values(pairs.size());
        for (unsigned int i = 0; i < pairs.size(); ++i)
          {
            if (i > 0 && !(pairs[i][0] > alpha.back()))
              throw InputError(item.second +
                               ": alpha_1 must increase from "
                               "row to row, but " +
                               number_to_string(alpha.back()) +
                               " is followed by " +
                               number_to_string(pairs[i][0]) + ".");
            alpha.push_back(pairs[i][0]);
            values(i) = pairs[i][1];
          }
        tables[item.first] = std::make_shared<const Table>(
          std::array<std::vector<double>, 1>{{alpha}}, values);
      }
  }


  /** Throw an InputError if the name of a table cannot be used in formulas or
   * is not unique. */
  void
  MeridionalTables::check_name(const std::string &name) const
  {
    bool usable = true;
    try
      {
        // throws if the name is taken, such as pi, or is not one word
        Formula("", name, {"alpha_1", name});
      }
    catch (const InputError &)
      {
        usable = false;
      }
    if (!usable || name == "alpha_1" || tables.count(name) > 0)
      throw InputError("Laminate/Tables",
                       name,
                       "the name of a table must start with a letter, "
                       "consist of letters, digits and '_', "
                       "and differ from other tables, variables and constants");
  }


  std::function<double(const double)>
  MeridionalTables::parse(const std::string &entry,
                          const std::string &text) const
  {
    std::vector<std::string>                  names{"alpha_1"};
    std::vector<std::shared_ptr<const Table>> functions;
    for (const auto &table : tables)
      {
        names.push_back(table.first);
        functions.push_back(table.second);
      }
    const Formula formula(entry, text, names);
    return [formula, functions](const double alpha_1) {
      std::vector<double> values{alpha_1};
      for (const auto &function : functions)
        values.push_back(function->value(Point<1>(alpha_1)));
      return formula(values);
    };
  }
} // namespace Biface
