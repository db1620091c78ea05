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
      for (const Imperfection::Series &series : parameters.series)
        variables.push_back(series.file.name);
      return Formula(
        imperfection_section + "Formula", parameters.formula, variables);
    }


    /** Tables or series whose files are not read yet. */
    template <typename Item>
    std::vector<Item>
    parse_files(const std::string &entry, const std::string &text)
    {
      std::vector<Item> items;
      for (const NamedFile &file :
           parse_named_files(entry, text, variables_of_position))
        items.push_back({file, {}});
      return items;
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
      "surface, of alpha_1, alpha_2, of the 'Tables' and of the 'Fourier "
      "series', such as 0.05*mode + 0.1*dent. It is zero where supports hold the shell along the normal, "
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
      parse_files<Table>,
      "Tables for the formula: a list of 'name: file', separated by "
      "commas. Each CSV file has rows 'alpha_1, alpha_2, value' that "
      "form a rectangular grid, such as measured deviations, or the "
      "shapes in buckling-NNNN-MMM.csv; values are interpolated "
      "linearly and constant beyond the grid; on a surface of "
      "revolution the last column of a full turn need not repeat the "
      "first if the columns are about evenly spaced. Paths are relative "
      "to the parameter file; see 'Laminate/Tables' for names in "
      "double quotes.",
      // the contents of the files are compared, here and below
      RestartChange::always);
    add_parsed(
      prm,
      "Fourier series",
      "",
      series,
      parse_files<Series>,
      "Measured shapes of a surface of revolution for the formula: a list of "
      "'name: file', separated by commas. Each CSV file has rows 'k, l, A, B' "
      "of whole numbers k and l and coefficients, and the name stands for "
      "the sum of cos(k pi x/L) (A cos(l alpha_2) + B sin(l alpha_2)), where "
      "x/L is 0 at the smallest and 1 at the largest alpha_1 of the meridian "
      "(-180 and 180 degrees of a circular arc), "
      "wherever the mesh ends. The formula gives it unit and sign: "
      "coefficients in thicknesses of a wall of 0.5, positive inward, "
      "are -0.5*name. At edges with the support 'symmetry' each term must be "
      "symmetric, and between 'cyclic' ones it must repeat. Paths are "
      "relative to the parameter file; see 'Laminate/Tables' for names in "
      "double quotes.",
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
    for (Series &one : series)
      one.terms = HalfWaveSeries(read_file(one.file.file_name, communicator),
                                 one.file.file_name);
  }


  void
  Imperfection::Parameters::check(const bool on_revolution) const
  {
    const std::string entry_of_series = imperfection_section + "Fourier series";
    for (const Series &one : series)
      {
        if (!on_revolution)
          throw InputError(entry_of_series,
                           one.file.name,
                           "it must be empty on a surface that is not a "
                           "'surface of revolution'");
        for (const Table &table : tables)
          if (table.file.name == one.file.name)
            throw InputError(entry_of_series,
                             one.file.name,
                             "the name must differ from those of the "
                             "'Tables'");
      }
    const auto used      = formula_of(*this).used_names();
    const auto check_use = [&used](const std::string &entry,
                                   const NamedFile   &file) {
      // without use it is rather a mistake in the formula
      if (std::count(used.begin(), used.end(), file.name) == 0)
        throw InputError(entry, file.name, "the 'Formula' must use this name");
    };
    for (const Table &table : tables)
      check_use(imperfection_section + "Tables", table.file);
    for (const Series &one : series)
      check_use(entry_of_series, one.file);
  }


  Imperfection::Imperfection(const Parameters       &parameters,
                             const ReferenceSurface &surface,
                             const SectorOfShell    &sector)
    : surface(surface)
    , formula(formula_of(parameters))
    , series(parameters.series)
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
    for (const Series &one : series)
      sector.check(one.terms, one.file.file_name);
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
    const auto [start, end] = surface.range();
    for (const Series &one : series)
      values.push_back(
        one.terms.value((alpha[0] - start) / (end - start), alpha[1]));
    return formula(values);
  }
} // namespace Biface
