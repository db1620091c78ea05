// SPDX-License-Identifier: LGPL-2.1-or-later

// Cylinders buckle under external pressure that follows the wall, where the
// tangent is unsymmetric by the error of the discretization: one with supported
// ends at the load of von Mises (1914; Timoshenko and Gere, Theory of Elastic
// Stability, section 11.5), one with fixed ends at that of 'Buckling', and the
// step that passes it says so. All this does not depend on the number of ranks
// or on the linear solver.

#include <deal.II/base/mpi.h>

#include <biface/stepping/buckling.h>
#include <biface/stepping/critical_point.h>

#include <run_analysis.h>
#include <tests.h>

using namespace dealii;
using namespace Biface;

namespace
{
  const std::string cylinder = DATA_DIR "/cylinder_under_pressure.prm";

  bool
  is_root()
  {
    return Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0;
  }


  /** The pressure at which a sector buckles: the last critical point. */
  double
  critical_pressure(const std::string           &what,
                    const std::vector<Override> &overrides)
  {
    double pressure = 0;
    for (const StepReport &report : run_analysis(cylinder, overrides))
      if (report.critical_point)
        {
          const CriticalPoint &point = *report.critical_point;
          pressure                   = point.loads.level.pressure;
          if (is_root())
            std::cout << what << ": "
                      << (point.located ? "located " : "passed ")
                      << point.kind() << ", " << point.n_negative_before
                      << " and " << point.n_negative_after << " negative pivots"
                      << std::endl;
        }
    return pressure;
  }


  void
  check(const std::string &what,
        const double       pressure,
        const double       expected,
        const double       bound)
  {
    if (is_root())
      check_small("  " + what, pressure - expected, bound, std::abs(expected));
  }


  /** Von Mises' pressure for n waves around a cylinder with supported ends. */
  double
  von_mises(const unsigned int n, const double length)
  {
    const double E = 70000, nu = 0.3, h = 1, R = 100;
    const double a = std::pow(n * length / (numbers::PI * R), 2);
    const double m = n * n - 1;
    return E * h / R *
           (1 / (m * (1 + a) * (1 + a)) +
            h * h / (12 * R * R * (1 - nu * nu)) *
              (m + (2 * n * n - 1 - nu) / (1 + a)));
  }
} // namespace


int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  // the sector of half a wave, and half of the length
  const double supported =
    critical_pressure("supported ends",
                      {"Mesh/Intervals alpha_1=0:200:24",
                       "Mesh/Intervals alpha_2=0:45:16",
                       "Surface/Straight line/End=100, 200",
                       "Supports/alpha_1 min=symmetry",
                       "Supports/alpha_1 max=v_2 middle; v_3 middle",
                       "Stage 1/Pressure=-0.2"});
  check("against von Mises", supported, -von_mises(4, 400), 0.003);

  double     predicted = 0;
  const auto reports   = run_analysis(cylinder,
                                    {"Stage 1/Pressure=-0.005",
                                       "Stage 1/Critical points=ignore",
                                       "Stage 1/Buckling=1"});
  if (!reports.empty() && reports.back().buckling)
    predicted = reports.back().buckling->loads[0].level.pressure;
  const double located = critical_pressure("fixed ends", {});
  check("against the predicted pressure", located, predicted, 0.01);
  const double dead =
    critical_pressure("fixed ends, dead", {"Loads/Pressure type=dead"});
  // its direction does not resist n waves: 1 - 1/n^2, as for a ring
  check("against dead pressure", located, (1 - 1. / 49) * dead, 0.005);
  // without coarser meshes it is the direct solver
  const double iterative = critical_pressure("fixed ends, iterative",
                                             {"Linear solver/Type=iterative"});
  check("against the direct solver", iterative, located, 1e-9);
  critical_pressure("fixed ends, report",
                    {"Stage 1/Critical points=report", "Stage 1/Steps=4"});
}
