// SPDX-License-Identifier: LGPL-2.1-or-later

// Derivatives of frequencies and buckling factors are those of whole runs where
// the tangent is not symmetric, too, so that shapes change them to first order:
// under pressure that follows a free edge, and where a wheel spins or rolls
// with friction.

#include <deal.II/base/mpi.h>

#include <string>
#include <vector>

#include <biface/problem/parameters.h>
#include <biface/stepping/buckling.h>

#include "sensitivities.h"


int
main(int argc, char **argv)
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  const std::string panel = DATA_DIR "/panel_with_free_edges.prm";
  const std::string of_panel =
    "Stage 1/Pressure; Material cord/E; Laminate/Plies[2]";
  check_sensitivities("modes",
                      panel,
                      {"Loads/Pressure type=follower", "Stage 1/Modes=3"},
                      of_panel,
                      "frequency 1, frequency 2, frequency 3");
  // a thin panel whose shapes a turn stiffens by more than it changes them
  check_sensitivities("large motion",
                      panel,
                      {"Loads/Pressure type=follower",
                       "Mesh/Intervals alpha_1=0:40:8",
                       "Mesh/Intervals alpha_2=0:4:3",
                       "Laminate/Plies=cord: 0.2 @ 0",
                       "Stage 1/Pressure=3e-4",
                       "Stage 1/Steps=4",
                       "Stage 1/Modes=2"},
                      "Stage 1/Pressure; Material cord/E",
                      "frequency 1, frequency 2");
  check_sensitivities("buckling",
                      panel,
                      {"Loads/Pressure type=follower",
                       "Supports/alpha_1 max=v_1 both = -0.001",
                       "Stage 1/Pressure=0.001",
                       "Stage 1/Load factor=1",
                       "Stage 1/Buckling=2"},
                      of_panel,
                      "buckling factor 1, buckling factor 2");

  // each mode is double, and round-off makes them conjugate
  check_sensitivities(
    "double modes",
    DATA_DIR "/cone_with_free_edge.prm",
    {},
    "Surface/Straight line/Start[1]; Laminate/Plies[4]; Material m/E",
    "buckling factor 1");

  // two frequencies have become a complex pair
  check_sensitivities(
    "flutter",
    panel,
    {"Loads/Pressure type=follower",
     "Mesh/Intervals alpha_1=0:40:8",
     "Mesh/Intervals alpha_2=0:4:3",
     "Laminate/Plies=cord: 1 @ 0",
     "Stage 1/Pressure=0.035",
     "Stage 1/Steps=4",
     "Stage 1/Modes=3"},
    "Stage 1/Pressure; Material cord/E; Material cord/Density",
    "frequency 1, frequency 2, frequency 3");

  const std::string           tire = PRM_DIR "/bias_tire.prm";
  const std::vector<Override> wheel{
    "Material cord/Density=1.2e-9",
    "Mesh/Intervals alpha_1=-120:120:12",
    "Mesh/Intervals alpha_2=-180:-30:4, -30:30:15, 30:180:4",
    "Contact/Multiplier mass=lumped",
    "Contact/Regularization=1e3",
    "Contact/Critical velocity=100",
    "Stage 2/Travel=12",
    "Stage 2/Steps=1"};
  const auto with = [&](const std::vector<Override> &more) {
    std::vector<Override> all = wheel;
    all.insert(all.end(), more.begin(), more.end());
    return all;
  };
  check_sensitivities(
    "spinning",
    tire,
    with({"Stage 2/Angular velocity=50", "Stage 2/Modes=3"}),
    "Stage 2/Angular velocity; Material cord/E_L; Material cord/Density",
    "frequency 1, frequency 2, frequency 3");
  check_sensitivities(
    "rolling",
    tire,
    with({"Number of stages=3",
          "Stage 3/Contact=true",
          "Stage 3/Friction=0.5",
          "Stage 3/Ground velocity=5000",
          "Stage 3/Control=axle moment",
          "Stage 3/Steps=2",
          "Stage 3/Modes=10"}),
    "Stage 3/Ground velocity; Material cord/E_L; Stage 3/Friction",
    "frequency 2, frequency 6, frequency 10");
}
