// SPDX-License-Identifier: LGPL-2.1-or-later

// A tire pressed with the force that a prescribed travel has given reaches that
// travel; the steps before are equal steps of the force, or larger if they
// adapt.

#include <biface/output/csv.h>
#include <biface/stepping/step_report.h>

#include "../bias_tire/bias_tire.h"
#include "../tests.h"

using namespace Biface;

namespace
{
  std::vector<StepReport>
  run(const std::vector<Override> &stage)
  {
    std::vector<Override> overrides{
      "Mesh/Intervals alpha_1=-120:120:14",
      "Mesh/Intervals alpha_2=-180:-20:4:smooth,-20:20:6,20:180:4:smooth"};
    overrides.insert(overrides.end(), stage.begin(), stage.end());
    return run_bias_tire(overrides);
  }
} // namespace


int
main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  // one rank speaks for all
  if (dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) != 0)
    std::cout.setstate(std::ios::failbit);

  const double travel = 12;
  const auto   by_travel =
    run({"Stage 2/Travel=" + csv_number(travel), "Stage 2/Steps=3"});
  const double                force = by_travel.back().contact.force;
  const std::vector<Override> by_force{"Stage 2/Control=foundation force",
                                       "Stage 2/Travel=0",
                                       "Stage 2/Force=" + csv_number(force)};
  check_true("a force", force > 100);

  auto overrides = by_force;
  overrides.push_back("Stage 2/Steps=4");
  const auto fixed = run(overrides);
  check_small("travel", fixed.back().level.travel - travel, 1e-6, travel);
  check_true("four steps after inflation", fixed.size() == 5);
  double deviation = 0;
  for (unsigned int step = 1; step < fixed.size(); ++step)
    deviation = std::max(
      deviation, std::abs(fixed[step].contact.force - step * force / 4));
  check_small("force in all steps", deviation, 1e-6, force);

  overrides = by_force;
  overrides.push_back("Stage 2/Steps=8");
  overrides.push_back("Stage 2/Adaptive steps=true");
  overrides.push_back("Step control/Maximum growth=4");
  const auto adaptive = run(overrides);
  check_small("travel, steps that adapt",
              adaptive.back().level.travel - travel,
              1e-6,
              travel);
  check_small("force", adaptive.back().contact.force - force, 1e-6, force);
  check_true("fewer steps", adaptive.size() < 1 + 8);
}
