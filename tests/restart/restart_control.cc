// SPDX-License-Identifier: LGPL-2.1-or-later

// A run that is stopped while its step size is being adapted, and continued on
// another number of ranks, has the history of an uninterrupted run.

#include "../restart.h"

using namespace dealii;

namespace
{
  /** The words for a run of a roof on a coarse mesh. */
  std::vector<std::string>
  coarse_roof(const std::string              &file,
              const std::vector<std::string> &settings = {})
  {
    return with(with({file}, settings),
                {"Mesh/Intervals alpha_1=0:254:4",
                 "Mesh/Intervals alpha_2=0:5.729577951308232:4"});
  }
} // namespace


int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  check_restart(
    "loads in steps that are cut",
    with(soft_tire, {"Newton/Maximum iterations=4", "Stage 2/Steps=1", no_vtu}),
    4);
  check_restart("loads in steps that adapt",
                {"--set",
                 "Mesh/Intervals alpha_1=0:10:8",
                 "--set",
                 "Stage 1/Adaptive steps=true",
                 "--set",
                 "Step control/Maximum growth=4",
                 DATA_DIR "/../verification/cantilever_end_shear.prm"},
                5);
  check_restart("force on the ground",
                with(soft_tire,
                     {"Stage 2/Control=foundation force",
                      "Stage 2/Travel=0",
                      "Stage 2/Force=1500",
                      no_vtu}),
                4);
  check_restart("force on a body",
                {"--set",
                 "Supports/alpha_1 min=fixed",
                 "--set",
                 "Stage 1/Bodies=lever",
                 "--set",
                 "Stage 1/Steps=4",
                 "--set",
                 "Stage 1/Forces on bodies=lever lift: -10",
                 // above round-off, which decides about iterations otherwise
                 "--set",
                 "Newton/Residual tolerance=1e-10",
                 DATA_DIR "/plate_and_bodies.prm"},
                2);
  check_restart(
    "sealed gas", {"--set", "Stage 2/Steps=4", DATA_DIR "/gas_tube.prm"}, 3);
  check_restart("a snap with damping",
                coarse_roof(DATA_DIR "/../verification/hinged_roof.prm",
                            {"Stage 1/Control=load", "Stage 1/Damping=1e-5"}),
                7);
  check_restart(
    "arc length", coarse_roof(PRM_DIR "/snap_through_roof.prm"), 20);
  check_restart(
    "arc length beyond a limit point",
    coarse_roof(DATA_DIR "/../verification/hinged_roof_two_stages.prm"),
    8);
}
