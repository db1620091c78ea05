// SPDX-License-Identifier: LGPL-2.1-or-later

// Under a given force, predicted steps start in contact: no iteration fails,
// and there are no more of them than without predictor.


#include <biface/stepping/step_report.h>

#include "../run_analysis.h"
#include "../tests.h"

using namespace dealii;
using namespace Biface;

namespace
{
  unsigned int
  iterations(const std::string &predictor)
  {
    Analysis analysis(
      PRM_DIR "/belted_tire.prm",
      {"Mesh/Intervals alpha_1=0:131.2:2,131.2:251.2:4,251.2:382.4:2",
       "Mesh/Intervals alpha_2=-180:-24:3:smooth,-24:24:4,24:180:3:smooth",
       "Step control/Predictor=" + predictor});
    unsigned int sum = 0;
    const auto   result =
      analysis.simulation.run([&](const StepReport &report, const State &) {
        sum += report.iterations;
      });
    check_true("predictor " + predictor + ", converged", result.success);
    check_true("no iteration failed",
               analysis.screen.str().find("not converged") ==
                 std::string::npos);
    return sum;
  }
} // namespace


int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  const unsigned int with    = iterations("true");
  const unsigned int without = iterations("false");
  check_true("no more iterations", with <= without);
}
