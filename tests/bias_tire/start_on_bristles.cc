// SPDX-License-Identifier: LGPL-2.1-or-later

// A tire with a thin tread that does not start to roll in one step starts with
// smaller coefficients of friction, and then rolls as after stages with such
// coefficients.

#include <biface/model/quantities/rolling_summary.h>
#include <biface/stepping/step_report.h>

#include "../tests.h"
#include "bias_tire.h"

using namespace Biface;

namespace
{
  /** The last step of free rolling with the last of some coefficients, each in
   * a stage. */
  StepReport
  roll_freely(const std::vector<std::string> &coefficients)
  {
    std::vector<Override> overrides{
      "Mesh/Intervals alpha_1=-120:-45:4, -45:45:9, 45:120:4",
      "Mesh/Intervals alpha_2=-180:-30:5:smooth, -30:30:15, 30:180:5:smooth",
      "Loads/Pressure type=follower",
      "Contact/Multiplier mass=lumped",
      "Contact/Rolling friction=bristles",
      "Contact/Tread/Height=1",
      "Contact/Tread/Modulus=1.8",
      "Stage 2/Steps=2",
      "Number of stages=" + std::to_string(2 + coefficients.size())};
    for (unsigned int i = 0; i < coefficients.size(); ++i)
      for (const std::string entry : {"Contact=true",
                                      "Ground velocity=1",
                                      "Control=axle moment",
                                      "Steps=1"})
        {
          const std::string stage = "Stage " + std::to_string(3 + i) + "/";
          overrides.emplace_back(stage + entry);
          overrides.emplace_back(stage + "Friction=" + coefficients[i]);
        }
    return run_bias_tire(overrides).back();
  }
} // namespace


int
main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  const StepReport at_once = roll_freely({"2"}),
                   slowly  = roll_freely({"0.1", "0.4", "2"});
  const double radius      = slowly.rolling->rolling_radius;
  check_small(
    "rolling radius", at_once.rolling->rolling_radius - radius, 1e-7, radius);
  const double force = slowly.rolling->force[2];
  check_small("vertical force", at_once.rolling->force[2] - force, 1e-6, force);
  std::cout << "steps: " << at_once.step << std::endl;
}
