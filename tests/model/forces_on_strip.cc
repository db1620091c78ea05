// SPDX-License-Identifier: LGPL-2.1-or-later

// The forces and moments of the supports of a strip are those of statics: about
// the deformed positions of all loads, with moments, follower pressure,
// prescribed displacements and prestress; they balance the loads to round-off.

#include "forces.h"

using namespace dealii;
using namespace Biface;

namespace
{
  // two spans of length 5 and width 2, thickness 0.1
  const std::string strip = R"(
subsection Surface
  set Type = plane
end
subsection Mesh
  set Intervals alpha_1 = 0:10:8
  set Intervals alpha_2 = -1:1:2
  set Closed in alpha_2 = false
end
set Materials = steel
subsection Material steel
  set Type = isotropic
  set E    = 1e6
  set nu   = 0
end
subsection Laminate
  set Plies             = steel: 0.1 @ 0
  set Reference surface = middle
end
set Named points = middle: 5 0, end: 10 0
subsection Supports
  set alpha_1 min = fixed
end
subsection Stage 1
  set Load factor = 1
  set Steps       = 4
end
subsection Newton
  set Residual tolerance = 1e-11
end
)";


  /** Check what the clamp exerts against forces and moments. */
  void
  check(const std::string           &what,
        const std::vector<Override> &overrides,
        const std::string           &body,
        const Resultant             &expected)
  {
    const Forces forces(write_prm("strip.prm", strip), overrides);
    if (Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) != 0)
      return;
    std::cout << what << std::endl;
    check_small("  balance", forces.imbalance, 1e-8);
    check_small("  " + body, difference(forces.of.at(body), expected), 1e-7);
    const Resultant &rest = forces.of.at("interpolation");
    double           sum  = 0;
    for (const double r : rest)
      sum = std::max(sum, std::abs(r));
    check_small("  internal forces", sum, 1e-9);
  }
} // namespace


int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  // small stretching by a couple of forces: E A u/L
  check("prescribed displacement",
        {"Supports/alpha_1 max=v_1 both = 0.01; v_2 both; v_3 both",
         "Stage 1/Strain theory=linear"},
        "alpha_1 max",
        {{200, 0, 0, 0, 0, 0}});
  check("its clamp",
        {"Supports/alpha_1 max=v_1 both = 0.01; v_2 both; v_3 both",
         "Stage 1/Strain theory=linear"},
        "alpha_1 min",
        {{-200, 0, 0, 0, 0, 0}});

  // a moment of 30 per width, which turns the end by more than a radian
  check("follower moment",
        {"Loads/Edge moments=alpha_1 max: 15 follower"},
        "alpha_1 min",
        {{0, 0, 0, 0, -30, 0}});

  // on a sandwich, whose faces carry it
  check("follower moment on layers",
        {"Materials=steel, foam",
         "Material foam/Type=isotropic",
         "Material foam/E=1e4",
         "Material foam/nu=0",
         "Laminate/Plies=steel: 0.02 @ 0, foam: 0.06 @ 0, steel: 0.02 @ 0",
         "Laminate/Layers=one per ply",
         "Loads/Edge moments=alpha_1 max: 15 follower"},
        "alpha_1 min",
        {{0, 0, 0, 0, -30, 0}});

  // the lever arm of dead forces is the deformed one
  for (const std::string load : {"Loads/Point forces=end: 0 1 8",
                                 "Loads/Edge forces=alpha_1 max: 1 0 2 outer",
                                 "Loads/Area force=0, 0.1, -0.3"})
    {
      const Forces forces(write_prm("strip.prm", strip), {load});
      if (Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) != 0)
        continue;
      std::cout << load << std::endl;
      check_small("  balance", forces.imbalance, 1e-8);
      Resultant opposite = forces.of.at("loads");
      for (double &f : opposite)
        f = -f;
      check_small(
        "  clamp", difference(forces.of.at("alpha_1 min"), opposite), 1e-7);
      check_true("  it deflects", std::abs(forces.of.at("loads")[4]) > 0.1);
    }

  // normal to the shell after large rotations; both ends are held
  {
    const Forces forces(write_prm("strip.prm", strip),
                        {"Loads/Pressure type=follower",
                         "Stage 1/Pressure=2",
                         "Supports/alpha_1 max=v_3 both",
                         "Supports/Point supports=middle: v_3 inner = 0.3"});
    if (Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
      {
        std::cout << "follower pressure, three supports" << std::endl;
        check_small("  balance", forces.imbalance, 1e-8);
        check_small(
          "  support without friction", forces.of.at("alpha_1 max")[0], 1e-12);
        check_true("  the point pulls or pushes",
                   std::abs(forces.of.at("point middle")[2]) > 1);
        check_true("  no ground", forces.of.at("foundation") == Resultant{});
      }
  }

  // a string with the tension 3 per width, held at both ends
  check("prestress",
        {"Laminate/Initial resultants=H_11 both = 1.5",
         "Supports/alpha_1 max=fixed",
         "Stage 1/Strain theory=linear"},
        "alpha_1 max",
        {{6, 0, 0, 0, 0, 0}});
}
