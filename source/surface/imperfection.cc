// SPDX-License-Identifier: LGPL-2.1-or-later

#include <algorithm>
#include <cmath>

#include <biface/base/errors.h>
#include <biface/input/entry_declarations.h>
#include <biface/input/grid_data.h>
#include <biface/input/parameter_tools.h>
#include <biface/input/read_file.h>
#include <biface/surface/greatest_deviation.h>
#include <biface/surface/imperfection.h>

namespace Biface
{
  using namespace dealii;

  namespace
  {
    const std::string imperfection_section = "Surface/Imperfection/";

    /** In the order of ReferenceSurface::formula_variables(). */
    const std::vector<std::string> variables_of_position{
      "x", "y", "z", "alpha_1", "alpha_2"};


    Formula
    formula_of(const Imperfection::Parameters &parameters)
    {
      std::vector<std::string> variables = variables_of_position;
      for (const Imperfection::Table &table : parameters.tables)
        variables.push_back(table.file.name);
      return Formula(
        imperfection_section + "Formula", parameters.formula, variables);
    }


    std::vector<Imperfection::Table>
    parse_charts(const std::string &entry, const std::string &text)
    {
      std::vector<Imperfection::Table> tables;
      for (const NamedFile &file :
           parse_named_files(entry, text, variables_of_position))
        tables.push_back({file, {}});
      return tables;
    }
  } // namespace


  void
  Imperfection::Parameters::add_parameters(EntryDeclarations &prm)
  {
    add_parsed(
      prm,
      "Formula",
      "0",
      formula,
      [](const std::string &entry, const std::string &text) {
        Formula(entry, text);
        return text;
      },
      "The deviation of the stress-free shell from the surface, along the "
      "outward normal: a number or a formula of the position x, y, z on the "
      "surface, of alpha_1, alpha_2 and of the 'Tables', such as 0.05*mode + "
      "0.1*dent. It is zero where supports hold the shell along the normal, "
      "and at most " +
        number_to_string(GreatestDeviation::allowed) +
        " of the smaller radius of curvature. "
        "Displacements are counted from the surface, so that they contain it.",
      Unit("length"));
    add_parsed(
      prm,
      "Tables",
      "",
      tables,
      parse_charts,
      "Tables for the formula: a list of 'name: file', separated by "
      "commas. Each CSV file has rows 'alpha_1, alpha_2, value' that "
      "form a rectangular grid, such as measured deviations, or the "
      "shapes in buckling-NNNN-MMM.csv; values are interpolated "
      "linearly and constant beyond the grid; on a surface of "
      "revolution the last column of a full turn need not repeat the "
      "first if the columns are about evenly spaced. Paths are relative "
      "to the parameter file; see 'Laminate/Tables' for names in "
      "double quotes.",
      // the contents of the files are compared
      RestartChange::always);
  }


  bool
  Imperfection::Parameters::is_zero() const
  {
    Formula deviation(imperfection_section + "Formula", formula);
    if (!deviation.used_names().empty())
      return false;
    deviation.bind({});
    return deviation({}) == 0;
  }


  void
  Imperfection::Parameters::read_files(const MPI_Comm communicator)
  {
    for (Table &table : tables)
      for (const auto &row :
           parse_rows(read_file(table.file.file_name, communicator),
                      table.file.file_name,
                      "each line must contain three numbers, 'alpha_1, "
                      "alpha_2, value'",
                      3,
                      3,
                      {"alpha_1", "alpha_2", "value"}))
        table.rows.emplace_back(row[0], row[1], row[2]);
  }


  void
  Imperfection::Parameters::check() const
  {
    const auto used = formula_of(*this).used_names();
    for (const Table &table : tables)
      // a table without use is rather a mistake in the formula
      if (std::count(used.begin(), used.end(), table.file.name) == 0)
        throw InputError(imperfection_section + "Tables",
                         table.file.name,
                         "the 'Formula' must use this name");
  }


  Imperfection::Imperfection(const Parameters       &parameters,
                             const ReferenceSurface &surface)
    : surface(surface)
    , formula(formula_of(parameters))
    , period(surface.get_periodicity()[1] / surface.coordinate_unit(1))
  {
    for (const Table &table : parameters.tables)
      {
        GridData grid(
          table.rows, {{"alpha_1", "alpha_2", "value"}}, table.file.file_name);
        auto              &turn = grid.rows[1];
        const unsigned int n = grid.rows[0].size(), m = turn.size();
        constexpr double   round_off = 1e-9;
        const double       start = turn[0], span = turn[m - 1] - start;
        if (period > 0 && span > period * (1 + round_off))
          throw InputError(table.file.file_name +
                           ": alpha_2 must not span more than a full turn.");
        double widest = 0;
        for (unsigned int j = 1; j < m; ++j)
          widest = std::max(widest, turn[j] - turn[j - 1]);
        const bool is_turn = period > 0 && span > period * (1 - round_off);
        // a table of the full turn need not repeat its first column
        if (period > 0 && !is_turn && period - span < 1.5 * widest)
          turn.push_back(start + period);
        dealii::Table<2, double> values(n, turn.size());
        for (unsigned int i = 0; i < n; ++i)
          {
            const double *row = &grid.values[std::size_t(i) * m];
            for (unsigned int j = 0; j < turn.size(); ++j)
              values(i, j) = row[j < m ? j : 0];
            if (is_turn &&
                std::abs(row[0] - row[m - 1]) >
                  round_off * (std::abs(row[0]) + std::abs(row[m - 1])))
              throw InputError(
                table.file.file_name +
                ": the values at alpha_2 = " + number_to_string(start) +
                " and " + number_to_string(turn[m - 1]) +
                " belong to the same points and must be the same.");
          }
        charts.push_back(
          {std::make_shared<const Interpolation>(grid.rows, values),
           start,
           turn.back()});
      }
  }


  double
  Imperfection::operator()(const Point<3> &x, const Point<2> &alpha) const
  {
    std::vector<double> values = surface.formula_variables(x, alpha);
    for (const Chart &chart : charts)
      {
        Point<2> at(values[3], values[4]);
        if (period > 0)
          {
            // into the turn that begins with the first column
            at[1] -= period * std::floor((at[1] - chart.start) / period);
            // beyond the rows, that of the nearer end
            if (at[1] - chart.end > chart.start + period - at[1])
              at[1] = chart.start;
          }
        values.push_back(chart.values->value(at));
      }
    return formula(values);
  }
} // namespace Biface
