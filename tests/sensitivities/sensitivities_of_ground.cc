// SPDX-License-Identifier: LGPL-2.1-or-later

// Derivatives by entries that move or reshape the ground are those of whole
// runs: by the radius of a drum under a wheel that rolls freely with friction,
// by the direction of the ground and its angle of turn, by the stiffnesses of
// contact in a stage, and by the center of moments.

#include <deal.II/base/mpi.h>

#include <string>
#include <vector>

#include <biface/problem/parameters.h>

#include "sensitivities.h"


int
main(int argc, char **argv)
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  const std::string           tire = PRM_DIR "/bias_tire.prm";
  const std::vector<Override> wheel{
    "Mesh/Intervals alpha_1=-120:120:12",
    "Mesh/Intervals alpha_2=-180:-30:4, -30:30:15, 30:180:4",
    "Contact/Multiplier mass=lumped",
    "Contact/Regularization=1e3",
    "Contact/Critical velocity=100",
    "Stage 2/Travel=12",
    "Stage 2/Steps=1",
    "Output/Write VTU=false"};
  const auto with = [&](const std::vector<Override> &more) {
    std::vector<Override> all = wheel;
    all.insert(all.end(), more.begin(), more.end());
    return all;
  };
  const std::vector<Override> rolling{"Number of stages=3",
                                      "Stage 3/Contact=true",
                                      "Stage 3/Friction=0.5",
                                      "Stage 3/Ground velocity=5000",
                                      "Stage 3/Slip angle=1",
                                      "Stage 3/Control=axle moment",
                                      "Stage 3/Steps=2"};
  std::vector<Override>       on_drum = with(rolling);
  on_drum.emplace_back("Contact/Foundation=drum");
  on_drum.emplace_back("Contact/Drum/Radius=500");
  check_sensitivities("drum",
                      tire,
                      on_drum,
                      "Contact/Drum/Radius",
                      "force, foundation F_y, foundation M_x");
  // whole runs have kinks where nodes enter
  check_sensitivities("camber",
                      tire,
                      with(rolling),
                      "Contact/Direction[3]",
                      "force, foundation F_y",
                      2e-3);
  // nodes that stick keep their tractions where the stiffnesses change
  check_sensitivities("stiffnesses of a stage",
                      tire,
                      with({"Contact/Friction=2",
                            "Contact/Tangential regularization=10",
                            "Number of stages=4",
                            "Stage 3/Contact=true",
                            "Stage 3/Slide=0, 3, 0",
                            "Stage 4/Contact=true",
                            "Stage 4/Glued=true",
                            "Stage 4/Slide=0, 4, 0",
                            "Stage 4/Steps=2",
                            "Stage 4/Regularization=5",
                            "Stage 4/Tangential regularization=1"}),
                      "Stage 4/Regularization; Stage 4/Tangential "
                      "regularization; Contact/Tangential regularization",
                      "force, foundation F_y",
                      1e-3);
  check_sensitivities("center of moments",
                      tire,
                      with({"Sensitivities/Relative step=1e-4"}),
                      "Output/Moment center[3]",
                      "foundation M_y");
}
