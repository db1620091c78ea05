// SPDX-License-Identifier: LGPL-2.1-or-later

// The bifurcation of Euler's column that bisection finds along its path, with
// given loads or arc length, is the predicted buckling load to 0.1 %, and the
// elastica beyond it has the same displacements with both controls, on the side
// that the sign of the amplitude chooses. A step that passes the bifurcation
// says so. All this does not depend on the number of ranks.

#include <deal.II/base/mpi.h>

#include <iomanip>

#include <biface/model/equations/shell_equations.h>
#include <biface/stepping/buckling.h>
#include <biface/stepping/critical_point.h>

#include <run_analysis.h>
#include <tests.h>

using namespace dealii;
using namespace Biface;

namespace
{
  const std::string column = DATA_DIR "/../verification/critical_column.prm";

  /** The largest displacement across the strip. */
  double
  deflection(const ShellEquations &equations, const State &state)
  {
    double largest = 0;
    for (const Node &node : equations.mesh.nodes)
      {
        const double u =
          (equations.mesh.displacement(state.displacement, node, 0)[2] +
           equations.mesh.displacement(state.displacement, node, 1)[2]) /
          2;
        if (std::abs(u) > std::abs(largest))
          largest = u;
      }
    const double highest = Utilities::MPI::max(largest, MPI_COMM_WORLD);
    const double lowest  = Utilities::MPI::min(largest, MPI_COMM_WORLD);
    return highest > -lowest ? highest : lowest;
  }


  double
  follow(const std::string &what, const std::vector<Override> &overrides)
  {
    const bool root    = Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0;
    double     last    = 0;
    const auto reports = run_analysis(
      column,
      overrides,
      [&](const ShellEquations &equations,
          const StepReport & /*report*/,
          const State &state) { last = deflection(equations, state); });
    double predicted = 0, found = 0;
    bool   located = false;
    for (const StepReport &report : reports)
      {
        if (report.buckling)
          predicted = report.buckling->loads[0].level.factors[0];
        if (!report.critical_point)
          continue;
        found   = report.critical_point->loads.level.factors[0];
        located = report.critical_point->located;
        if (root)
          std::cout << what << ": " << report.critical_point->kind() << ", "
                    << report.critical_point->n_negative_before << " and "
                    << report.critical_point->n_negative_after
                    << " negative pivots" << std::endl;
      }
    if (root)
      {
        if (located)
          check_small(
            "  found against predicted", found - predicted, 0.001, predicted);
        std::cout << "  load " << std::setprecision(8) << found
                  << ", deflection " << std::round(1e5 * last) / 1e5
                  << std::endl;
      }
    return last;
  }
} // namespace


int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  const std::vector<Override> two_stages{"Number of stages=2",
                                         "Stage 2/Load factor=2.368193",
                                         "Stage 2/Steps=4",
                                         "Stage 1/Load factor=0.1",
                                         "Stage 1/Steps=1",
                                         "Stage 1/Buckling=1"};
  const auto                  with = [&](std::vector<Override> more) {
    more.insert(more.begin(), two_stages.begin(), two_stages.end());
    return more;
  };
  follow("passed", with({}));
  const double a =
    follow("load", with({"Stage 2/Critical points=switch branch"}));
  const double b = follow("arc length",
                          with({"Stage 2/Critical points=switch branch",
                                "Stage 2/Branch amplitude=-5",
                                "Stage 2/Control=arc length"}));
  if (Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
    check_small("  opposite deflections", a + b, 1e-6, a);
}
