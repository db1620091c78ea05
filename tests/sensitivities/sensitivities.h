// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_tests_sensitivities_h
#define biface_tests_sensitivities_h

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iomanip>
#include <iostream>
#include <string>
#include <vector>

#include <biface/problem/design_variable.h>
#include <biface/problem/parameters.h>
#include <biface/stepping/sensitivity_table.h>

#include <run_analysis.h>

using namespace dealii;
using namespace Biface;

inline SensitivityTable
table_of(const std::string &file, const std::vector<Override> &overrides)
{
  const auto reports = run_analysis(file, overrides);
  return *reports.back().sensitivities;
}


/** Print 100 times the logarithmic derivatives, of which the absolute error
 * counts.
 * @param first the first of the outputs that are printed. */
inline void
print_logarithmic(const SensitivityTable &table, const unsigned int first = 0)
{
  std::cout << std::setprecision(10);
  for (unsigned int e = 0; e < table.entries.size(); ++e)
    for (unsigned int o = first; o < table.outputs.size(); ++o)
      std::cout << table.outputs[o].name << " by " << table.entries[e].name
                << ": " << 100 * table.logarithmic(e, o) << std::endl;
}


/** Compare derivatives at the end of the last stage with central differences
 * of whole runs.
 * @param tolerance relative to the derivative. */
inline void
check_sensitivities(const std::string           &title,
                    const std::string           &file,
                    const std::vector<Override> &overrides,
                    const std::string           &entries,
                    const std::string           &outputs,
                    const double                 tolerance = 1e-4)
{
  constexpr double step = 1e-4;

  std::vector<Override> all = overrides;
  all.emplace_back("Newton/Residual tolerance=1e-11");
  all.emplace_back("Sensitivities/Outputs=" + outputs);
  all.emplace_back("Sensitivities/Entries=" + entries);

  Parameters       parameters;
  ParameterHandler prm;
  read_parameters(file, all, MPI_COMM_WORLD, parameters, prm);
  const auto             variables = parse_design_variables("", entries);
  const SensitivityTable table     = table_of(file, all);
  // changed runs only give values, for which the cheapest table will do
  all.back() = "Sensitivities/Entries=" + entries.substr(0, entries.find(';'));

  double largest = 0;
  for (unsigned int e = 0; e < variables.size(); ++e)
    {
      const double value = variables[e].value(prm);
      const double size  = step * (value == 0 ? 1 : std::abs(value));
      std::array<SensitivityTable, 2> changed;
      for (unsigned int side = 0; side < 2; ++side)
        {
          std::vector<Override> with_change = all;
          for (const Override &setting :
               settings({variables[e]},
                        {value + (side == 0 ? -size : size)},
                        prm,
                        "test"))
            with_change.push_back(setting);
          changed[side] = table_of(file, with_change);
        }
      for (unsigned int o = 0; o < table.outputs.size(); ++o)
        {
          const double expected =
            (changed[1].outputs[o].value - changed[0].outputs[o].value) /
            (2 * size);
          const double found = table.derivatives[e][o];
          // outputs that hardly depend on the entry are round-off
          const double scale =
            std::max(std::abs(expected),
                     1e-3 * std::abs(table.outputs[o].value / size * step));
          const double error = std::abs(found - expected) / scale;
          largest            = std::max(largest, error);
          if (!(error <= tolerance) &&
              Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
            std::cout << "FAILED: " << title << ", d " << table.outputs[o].name
                      << " / d " << table.entries[e].name << " is " << found
                      << ", not " << expected << std::endl;
        }
    }
  if (Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
    std::cout << title << (largest <= tolerance ? "" : " deviates") << ": "
              << variables.size() << " entries, " << table.outputs.size()
              << " outputs" << std::endl;
}

#endif
