// SPDX-License-Identifier: LGPL-2.1-or-later

// The shipped bias tire has the contact pressures of Table 1 of the paper with
// their central symmetry, and the displacement and forces of the
// independent program of doc/bias_tire.md.

#include <deal.II/base/utilities.h>

#include <cstdio>
#include <fstream>
#include <iostream>
#include <map>

#include <biface/stepping/step_report.h>

#include "../tests.h"
#include "bias_tire.h"

using namespace dealii;
using namespace Biface;

namespace
{
  /** (psi, 3 phi) in whole degrees. */
  using Place = std::pair<int, int>;

  Place
  place_of(const Node &node)
  {
    const double degree = numbers::PI / 180;
    return {static_cast<int>(std::lround(node.alpha[0] / degree)),
            static_cast<int>(std::lround(3 * node.alpha[1] / degree))};
  }


  /** Pressures of the paper in MPa. */
  std::map<Place, double>
  read_table_1()
  {
    std::map<Place, double>  table;
    std::ifstream            file(DATA_DIR "/table_1.csv");
    std::vector<std::string> header;
    std::string              line;
    while (std::getline(file, line))
      {
        if (line[0] == '#')
          continue;
        const auto cells = Utilities::split_string_list(line, ',');
        if (header.empty())
          header = cells;
        else
          for (unsigned int i = 1; i < cells.size(); ++i)
            if (!cells[i].empty())
              table[{std::stoi(cells[0]), std::stoi(header[i])}] =
                std::stod(cells[i]) / 10;
      }
    return table;
  }


  void
  print(const char *what, const double value, const char *format)
  {
    char text[64];
    std::snprintf(text, sizeof(text), format, value);
    std::cout << what << ": " << text << std::endl;
  }
} // namespace


int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  double                  equator = 0;
  std::map<Place, double> pressures;

  const auto reports = run_bias_tire(
    {},
    [&](const ShellEquations &equations,
        const StepReport     &report,
        const State          &state) {
      const auto &mesh = equations.mesh;
      for (unsigned int n = 0; n < mesh.nodes.size(); ++n)
        {
          const Node &node  = mesh.nodes[n];
          const Place place = place_of(node);
          if (report.step == 1 && place == Place(0, 0))
            equator =
              mesh.displacement(state.displacement, node, Resultants::outer)[2];
          if (report.level.travel == 20 && state.contacts[0].active[n])
            pressures[place] = state.ground().pressure(n);
        }
    });

  // steps and iterations of the whole run
  unsigned int n_iterations = 0;
  for (const auto &report : reports)
    n_iterations += report.iterations;
  check_range("steps", reports.size(), 21, 21);
  check_range("Newton iterations in all", n_iterations, 21, 120);

  print("equator displacement after inflation (mm)", equator, "%.3f");
  check_range("equator displacement", equator, -1.788, -1.784);

  const std::map<double, double> forces{{4, 236}, {12, 975}, {20, 1951}};
  for (const auto &report : reports)
    if (forces.count(report.level.travel))
      {
        const double      force = forces.at(report.level.travel);
        const std::string name =
          "P(" + std::to_string(static_cast<int>(report.level.travel)) + ")";
        print((name + " (N)").c_str(), report.contact.force, "%.1f");
        check_small(name + " against the independent one",
                    report.contact.force - force,
                    5e-3,
                    force);
      }

  const auto   table   = read_table_1();
  unsigned int n_found = 0;
  double       square  = 0;
  for (const auto &entry : table)
    if (pressures.count(entry.first))
      {
        ++n_found;
        square += std::pow(pressures[entry.first] / entry.second - 1, 2);
      }
  const double rms = std::sqrt(square / n_found);
  std::cout << "nodes of Table 1 in contact: " << n_found << " of "
            << table.size() << std::endl;
  check_true("at least 275 of 277", n_found >= 275 && table.size() == 277);
  print("RMS relative deviation from Table 1", rms, "%.3f");
  check_small("RMS deviation", rms, 0.085);
  print("pressure at the center (MPa)", pressures[Place(0, 0)], "%.4f");

  double asymmetry = 0, transverse = 0;
  for (const auto &entry : pressures)
    {
      const Place &place = entry.first;
      asymmetry          = std::max(
        asymmetry,
        std::abs(pressures[{-place.first, -place.second}] / entry.second - 1));
      if (table.count(place))
        transverse = std::max(
          transverse,
          std::abs(pressures[{place.first, -place.second}] - entry.second));
    }
  check_small("central symmetry of the pressures", asymmetry, 1e-6);
  check_true("no symmetry about the plane psi = 0", transverse > 0.01);
}
