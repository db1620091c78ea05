// SPDX-License-Identifier: LGPL-2.1-or-later

// A conical ring under pressure that spins more and more slowly, in
// displacement control, snaps through at a limit point of its angular velocity,
// where the pressure at constant speed has its limit point, too.

#include <iostream>

#include <biface/input/parameter_tools.h>
#include <biface/stepping/critical_point.h>

#include <run_analysis.h>
#include <tests.h>

using namespace dealii;
using namespace Biface;

namespace
{
  /** The loads at the first critical point. */
  LoadLevel
  find(const std::string &what, const std::vector<Override> &overrides)
  {
    for (const StepReport &report :
         run_analysis(DATA_DIR "/spinning_cone.prm", overrides))
      if (report.critical_point)
        {
          std::cout << what << ": " << report.critical_point->kind()
                    << std::endl;
          return report.level;
        }
    std::cout << what << ": nothing found" << std::endl;
    return {};
  }
} // namespace


int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  const LoadLevel slow = find("at constant pressure", {});
  check_true("  slower than before",
             0 < slow.angular_velocity && slow.angular_velocity < 14);
  const LoadLevel high =
    find("at constant speed",
         {"Stage 1/Pressure=1e-5",
          "Stage 1/Angular velocity=" + number_to_string(slow.angular_velocity),
          "Stage 2/Angular velocity=unchanged",
          "Stage 2/Pressure=2e-5"});
  check_small(
    "  the pressures", high.pressure - slow.pressure, 1e-3, slow.pressure);
}
