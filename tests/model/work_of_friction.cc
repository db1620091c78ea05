// SPDX-License-Identifier: LGPL-2.1-or-later

// While a tire slides on a rough plane, loads and ground do as much work as
// its strain energy increases by, plus that of friction, and four times
// as many steps leave less than a quarter of the difference.

#include <vector>

#include <biface/stepping/step_report.h>

#include "../run_analysis.h"
#include "../tests.h"

using namespace dealii;
using namespace Biface;

int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  const bool is_root = Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0;

  double last = 1;
  for (const unsigned int n_steps : {5, 20})
    {
      std::vector<double> energy;
      const auto          reports = run_analysis(
        PRM_DIR "/bias_tire.prm",
        {"Mesh/Intervals alpha_1=-120:120:14",
                  "Mesh/Intervals alpha_2=-180:-20:4:smooth,-20:20:6,"
                           "20:180:4:smooth",
                  "Contact/Multiplier mass=lumped",
                  "Contact/Friction=0.4",
                  "Stage 2/Steps=2",
                  "Stage 2/Travel=15",
                  "Number of stages=3",
                  "Stage 3/Contact=true",
                  "Stage 3/Slide=0, 5, 0",
                  "Stage 3/Steps=" + std::to_string(n_steps)},
        [&](const ShellEquations &equations,
            const StepReport &,
            const State &state) {
          energy.push_back(equations.internal_forces().strain_energy(state));
        });
      const Work  &start  = reports[2].work;
      const Work  &end    = reports.back().work;
      const double done   = end.loads + end.ground - start.loads - start.ground;
      const double stored = energy.back() - energy[2];
      const double friction   = end.friction - start.friction;
      const double difference = std::abs(done - stored - friction) / done;
      if (is_root)
        {
          std::cout << n_steps << " steps" << std::endl;
          check_range("  part of friction", friction / done, 0.4, 0.8);
          check_small("  balance", difference, n_steps == 5 ? 0.02 : 5e-4);
          check_range(
            "  difference over that before", difference / last, 0, 0.25);
        }
      last = difference;
    }
}
