// SPDX-License-Identifier: LGPL-2.1-or-later

// Derivatives are those of whole runs with a changed entry, by central
// differences, along every kind of path: where the ground touches a shell
// that depends on the entry, with friction, linear strain theory, a force or an
// arc length that is controlled, a sealed gas, and a stage that starts from an
// earlier one; of frequencies and buckling factors, too.

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

  const std::string           tire = PRM_DIR "/bias_tire.prm";
  const std::vector<Override> coarse{
    "Mesh/Intervals alpha_1=-120:120:8",
    "Mesh/Intervals alpha_2=-180:-20:3:smooth, -20:20:4, 20:180:3:smooth",
    "Contact/Multiplier mass=lumped",
    "Contact/Regularization=1e3",
    "Named points=side: 0 -180",
    "Stage 2/Steps=2"};
  const auto with = [&](const std::vector<Override> &more) {
    std::vector<Override> all = coarse;
    all.insert(all.end(), more.begin(), more.end());
    return all;
  };
  // for figures that have kinks where single nodes touch the ground
  const auto on_finer_mesh = [&](const std::vector<Override> &more) {
    std::vector<Override> all = with(
      {"Mesh/Intervals alpha_1=-120:120:14",
       "Mesh/Intervals alpha_2=-180:-20:4:smooth, -20:20:6, 20:180:4:smooth"});
    all.insert(all.end(), more.begin(), more.end());
    return all;
  };
  const std::string entries =
    "p: Stage 1/Pressure, Stage 2/Pressure; Stage 2/Travel; Laminate/Plies[2]; "
    "Material cord/E_L; Surface/Circular arc/Radius";
  const std::string outputs =
    "force, footprint_area, max_pressure, loaded_radius, side u_x, "
    "strain_energy, max_fiber_tension, alpha_1 min F_x";

  check_sensitivities(
    "touched", tire, with({"Stage 2/Travel=10"}), entries, outputs);
  check_sensitivities(
    "linear",
    tire,
    with({"Stage 2/Strain theory=linear", "Stage 2/Travel=10"}),
    entries,
    "force, side u_x");
  check_sensitivities("friction",
                      tire,
                      on_finer_mesh({"Contact/Friction=0.5",
                                     "Number of stages=3",
                                     "Stage 2/Travel=10",
                                     "Stage 3/Contact=true",
                                     "Stage 3/Slide=0,2,0",
                                     "Stage 3/Steps=2"}),
                      "Contact/Friction; Stage 3/Slide[2]; " + entries,
                      "force, foundation F_y, side u_y");
  // the ground penetrates by less than it moves with the entries
  check_sensitivities(
    "stiff contact with friction",
    tire,
    with({"Contact/Regularization=1e4", "Stage 2/Friction=0.5"}),
    "Stage 2/Travel; angle: Laminate/Plies[2], -Laminate/Plies[4], "
    "Laminate/Plies[6], -Laminate/Plies[8]; Material cord/E_L",
    "force, footprint_area, max_pressure");
  check_sensitivities("force",
                      tire,
                      with({"Stage 2/Travel=unchanged",
                            "Stage 2/Control=foundation force",
                            "Stage 2/Force=500"}),
                      "Stage 2/Force; Material cord/E_L; Laminate/Plies[2]",
                      "approach, side u_x");
  check_sensitivities("branch",
                      tire,
                      with({"Number of stages=3",
                            "Stage 3/Start from=1",
                            "Stage 3/Pressure=0.2",
                            "Stage 2/Travel=5"}),
                      "Stage 1/Pressure; Stage 3/Pressure; Material cord/E_L",
                      "side u_x, strain_energy");
  // the last step is that to the loads of the stage
  check_sensitivities("arc length",
                      DATA_DIR "/../verification/cantilever_end_shear.prm",
                      {"Stage 1/Control=arc length",
                       "Stage 1/Load factor=0.3",
                       "Stage 1/Steps=5"},
                      "Material strip/E; Stage 1/Load factor",
                      "load_factor, tip u_z, strain_energy");
  // a step along the critical shape is as long as in the run
  check_sensitivities("switched branch",
                      DATA_DIR "/../verification/critical_column.prm",
                      {"Mesh/Intervals alpha_1=0:100:10",
                       "Stage 1/Control=arc length",
                       "Stage 1/Load factor=2.2"},
                      "Material strip/E; Stage 1/Load factor",
                      "end u_x, strain_energy",
                      1e-3);
  check_sensitivities("imperfection",
                      DATA_DIR "/imperfect_column.prm",
                      {"Mesh/Intervals alpha_1=0:200:20"},
                      "Surface/Imperfection/Formula[1]; Material steel/E",
                      "middle u_z, strain_energy");
  // at 0.15 MPa the first two frequencies are so close that differences are not
  // exact
  check_sensitivities(
    "modes",
    tire,
    on_finer_mesh({"Formulation=standard",
                   "Material cord/Density=1.2e-9",
                   "Stage 2/Pressure=0.2",
                   "Stage 2/Travel=10",
                   "Stage 2/Modes=3"}),
    "Stage 1/Pressure; Material cord/E_L; Material cord/Density; "
    "Laminate/Plies[2]; Surface/Circular arc/Radius",
    "frequency 1, frequency 2, frequency 3");
  // pairs of the same factor
  check_sensitivities(
    "buckling",
    PRM_DIR "/laminated_cylinder.prm",
    {"Mesh/Intervals alpha_1=0:510:8",
     "Mesh/Intervals alpha_2=-180:180:16",
     "Stage 1/Buckling=0",
     "Stage 2/Load factor=0.04",
     "Stage 2/Critical points=ignore",
     "Stage 2/Steps=1",
     "Stage 2/Buckling=4"},
    "Material carbon/E_L; Material carbon/G_LT; Laminate/Plies[1]; "
    "radius: Surface/Straight line/Start[1], Surface/Straight line/End[1]; "
    "Supports/alpha_1 max",
    "buckling factor 1, buckling factor 2, buckling factor 3, buckling "
    "factor 4");
  check_sensitivities("buckling after steps",
                      tire,
                      on_finer_mesh({"Stage 1/Pressure=-0.001",
                                     "Stage 2/Pressure=0.1",
                                     "Stage 2/Travel=10",
                                     "Stage 2/Buckling=1"}),
                      "Stage 1/Pressure; Stage 2/Pressure; Material cord/E_L; "
                      "Laminate/Plies[2]; Surface/Circular arc/Radius",
                      "buckling factor 1, side u_x");
  check_sensitivities(
    "gas",
    DATA_DIR "/gas_tube.prm",
    {"Named points=middle: 25 0", "Mesh/Intervals alpha_1=0:25:2, 25:50:2"},
    "Gas/Ambient pressure; Stage 1/Pressure; Material wall/E; "
    "Supports/alpha_1 max; Surface/Straight line/Start[1]",
    "pressure, volume, middle u_x");
  check_sensitivities(
    "modes with gas",
    DATA_DIR "/gas_tube.prm",
    {"Material wall/Density=1e-9",
     "Supports/alpha_1 max=v_1 both = 5",
     "Stage 2/Modes=2"},
    "Gas/Ambient pressure; Stage 1/Pressure; Material wall/E; "
    "Supports/alpha_1 max",
    "frequency 1, frequency 2");
}
