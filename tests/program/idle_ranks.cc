// SPDX-License-Identifier: LGPL-2.1-or-later

// With more ranks than cells, some of which have no unknowns, everything is as
// on one rank: equilibria, a bifurcation that is passed, buckling loads, modes,
// derivatives, and the force of the ground.

#include <deal.II/base/mpi.h>

#include <fstream>
#include <sstream>

#include <biface/model/state/state.h>
#include <biface/solver/modal_analysis.h>
#include <biface/stepping/buckling.h>
#include <biface/stepping/sensitivity_table.h>

#include <run_analysis.h>
#include <tests.h>

using namespace dealii;
using namespace Biface;

namespace
{
  const std::string plate = "subsection Surface\n  set Type = plane\nend\n"
                            "subsection Mesh\n"
                            "  set Intervals alpha_1 = 0:100:2\n"
                            "  set Intervals alpha_2 = 0:50:1\n"
                            "  set Closed in alpha_2 = false\nend\n"
                            "subsection Material cord\n"
                            "  set Type    = isotropic\n"
                            "  set E       = 1000\n  set nu      = 0.3\n"
                            "  set Density = 1e-9\nend\n"
                            "subsection Laminate\n  set Plies = cord: 2 @ 0\n"
                            "  set Reference surface = middle\nend\n"
                            "subsection Supports\n"
                            "  set alpha_1 min = fixed\n"
                            "  set alpha_1 max = v_3 middle\nend\n"
                            "subsection Loads\n"
                            "  set Edge forces = alpha_1 max: -0.5 0 0\nend\n"
                            "subsection Contact\n"
                            "  set Direction = 0, 0, 1\nend\n"
                            "set Number of stages = 2\n"
                            "subsection Stage 1\n  set Load factor = 6\n"
                            "  set Steps    = 3\n  set Modes    = 2\n"
                            "  set Buckling = 1\nend\n"
                            "subsection Stage 2\n  set Load factor = 0\n"
                            "  set Contact = true\n  set Modes   = 1\n"
                            "  set Travel  = 0.1\nend\n"
                            "subsection Sensitivities\n"
                            "  set Entries = E: Material cord/E\n"
                            "  set Outputs = force, frequency 1\nend\n";


  /** The numbers of a run. */
  std::vector<double>
  run(const MPI_Comm communicator)
  {
    std::ostringstream  screen;
    Simulation          simulation(parameters_of("plate.prm",
                                        {"Stage 1/Critical points=locate",
                                                  "Stage 1/Load factor=12"}),
                          communicator,
                          screen);
    std::vector<double> numbers;
    const auto          result =
      simulation.run([&](const StepReport &report, const State &) {
        numbers.push_back(report.level.factors[0]);
        numbers.push_back(report.contact.force);
        numbers.push_back(report.n_negative_pivots.value_or(99));
        if (report.modes)
          for (const VibrationMode &mode : report.modes->modes)
            numbers.push_back(std::abs(mode.omega));
        if (report.buckling)
          for (const auto &load : report.buckling->loads)
            numbers.push_back(load.factor);
        if (report.sensitivities)
          for (const auto &row : report.sensitivities->derivatives)
            numbers.insert(numbers.end(), row.begin(), row.end());
      });
    if (!result.success)
      numbers.push_back(0);
    return numbers;
  }
} // namespace


int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  const bool is_root = (Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0);
  if (is_root)
    std::ofstream("plate.prm") << plate;
  MPI_Barrier(MPI_COMM_WORLD);

  const std::vector<double> together = run(MPI_COMM_WORLD),
                            alone    = run(MPI_COMM_SELF);
  if (!is_root)
    return 0;
  check_true("there are as many numbers", together.size() == alone.size());
  check_range("numbers", alone.size(), 15, 100);
  double difference = 0;
  for (unsigned int i = 0; i < std::min(alone.size(), together.size()); ++i)
    difference =
      std::max(difference,
               std::abs(together[i] - alone[i]) / (std::abs(alone[i]) + 1e-6));
  check_small("they differ", difference, 1e-6);
}
