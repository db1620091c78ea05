// SPDX-License-Identifier: LGPL-2.1-or-later

// Supports hold Cartesian components and those about the axis: a cone follows
// its edges along the axis without strain, three points hold a shell statically
// with forces along their components only, a displacement is controlled in the
// radial direction, and equations that follow from others hold nothing more.

#include <biface/stepping/step_report.h>

#include "forces.h"

using namespace dealii;
using namespace Biface;

namespace
{
  // a sector of a cone of 45 degrees
  const std::string cone = R"(
subsection Surface
  set Meridian = straight line
  subsection Straight line
    set Start = 20, 0
    set End   = 10, 10
  end
end
subsection Mesh
  set Intervals alpha_1 = 0:14.142135623730951:4
  set Intervals alpha_2 = 20:110:6
  set Closed in alpha_2 = false
end
set Materials = steel
subsection Material steel
  set Type = isotropic
  set E    = 1e4
  set nu   = 0.3
end
subsection Laminate
  set Plies             = steel: 1 @ 0
  set Reference surface = middle
end
set Named points = a: 0 20, b: 0 110, c: 14.142135623730951 65
subsection Stage 1
  set Load factor = 1
  set Steps       = 2
end
subsection Newton
  set Residual tolerance = 1e-11
end
)";


  /** The unknowns of the cone, and its displacements at the end of a run:
   * Cartesian, of the middle surface, at the named points. */
  struct Cone
  {
    types::global_dof_index             n_unknowns = 0;
    std::map<std::string, Tensor<1, 3>> displacement;
    double                              energy  = 0;
    double                              largest = 0;

    Cone(const std::vector<Override> &overrides)
    {
      run_analysis(
        write_prm("cone.prm", cone),
        overrides,
        [&](const ShellEquations &equations,
            const StepReport &,
            const State &state) {
          const ShellMesh &mesh = equations.mesh;
          n_unknowns            = mesh.n_unknowns();
          energy  = equations.internal_forces().strain_energy(state);
          largest = 0;
          for (const Node &node : mesh.nodes)
            for (unsigned int face = 0; face < 2; ++face)
              largest = std::max(largest,
                                 (node.surface.from_frame(mesh.displacement(
                                    state.displacement, node, face)) -
                                  Tensor<1, 3>({0, 3, 0}))
                                   .norm());
          largest = Utilities::MPI::max(largest, MPI_COMM_WORLD);
          for (unsigned int p = 0; p < mesh.points.size(); ++p)
            {
              Tensor<1, 3>       u;
              const unsigned int n = mesh.nodes_of_points[p];
              if (n < mesh.nodes.size() && mesh.nodes[n].locally_owned)
                for (unsigned int face = 0; face < 2; ++face)
                  u += mesh.nodes[n].surface.from_frame(mesh.displacement(
                         state.displacement, mesh.nodes[n], face)) /
                       2;
              displacement[mesh.points[p].name] =
                Utilities::MPI::sum(u, MPI_COMM_WORLD);
            }
        });
    }
  };
} // namespace


int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  // one rank speaks for all
  if (Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) != 0)
    std::cout.setstate(std::ios::failbit);

  const auto degrees = [](const double angle) {
    return angle * numbers::PI / 180;
  };

  // free across the axis
  {
    const Cone moved(
      {"Supports/alpha_1 min=axial both = 3; circumferential both",
       "Supports/alpha_1 max=axial both = 3"});
    check_small("a cone moved along its axis", moved.largest, 1e-9, 3);
    check_small("its strain energy", moved.energy, 1e-12);
  }

  // x, y, z and radial, axial, circumferential say the same
  {
    const double      c = std::cos(degrees(20)), s = std::sin(degrees(20));
    const std::string u = std::to_string(2 * c - 1 * s),
                      w = std::to_string(2 * s + 1 * c);
    const std::vector<std::string> supports{
      "Supports/Point supports=a: radial both = 2; axial both = 0.5; "
      "circumferential both = 1",
      "Supports/Point supports=a: x both = " + u +
        "; y both = 0.5; z both = " + w};
    std::vector<Tensor<1, 3>> b;
    for (const std::string &support : supports)
      b.push_back(
        Cone({support, "Supports/alpha_1 max=fixed"}).displacement.at("b"));
    check_small(
      "prescribed both ways", (b[1] - b[0]).norm(), 1e-5, b[0].norm());
    check_true("it moves", b[0].norm() > 0.01);
  }

  // equations that follow from others
  {
    const std::string load    = "Loads/Point forces=b: 1 0 0";
    const std::string support = "Supports/alpha_1 max=";
    const auto        fixed   = Cone({load, support + "fixed"}).n_unknowns;
    check_true("held in space",
               Cone({load, support + "x both; y both; z both"}).n_unknowns ==
                 fixed);
    check_true("held more than once",
               Cone({load,
                     support + "x inner; y both; z middle; radial both; v_1 "
                               "difference; v_3 outer; circumferential outer"})
                   .n_unknowns == fixed);
    check_true("on an inclined edge, two of the three components",
               Cone({load,
                     support + "v_2 both; v_1 both; radial both",
                     "Supports/alpha_1 min=axial middle"})
                   .n_unknowns == fixed - 7);
  }

  // statically determinate: six components at three points
  {
    const Forces forces(
      write_prm("cone.prm", cone),
      {"Supports/Point supports=a: x inner; y inner; z inner, b: axial outer; "
       "radial outer, c: axial inner",
       "Loads/Area force=0.01, -0.02, 0.03"});
    check_small("balance", forces.imbalance, 1e-8);
    const Resultant &b = forces.of.at("point b"), &c = forces.of.at("point c");
    double           size = 0;
    for (const double entry : b)
      size = std::max(size, std::abs(entry));
    check_true("the points hold the shell", size > 0.1);
    check_small("only axially and radially",
                b[0] * std::sin(degrees(110)) - b[2] * std::cos(degrees(110)),
                1e-10,
                size);
    check_small("only axially", std::hypot(c[0], c[2]), 1e-10, size);
    check_true("  but there", std::abs(c[1]) > 0.1);
  }

  // displacement control
  {
    const Cone         controlled({"Supports/alpha_1 max=fixed",
                                   "Loads/Point forces=b: 1 0 1",
                                   "Stage 1/Control=displacement",
                                   "Stage 1/Control point=b",
                                   "Stage 1/Control component=radial",
                                   "Stage 1/Control value=-0.5"});
    const Tensor<1, 3> u = controlled.displacement.at("b");
    check_small("controlled radial displacement",
                u[0] * std::cos(degrees(110)) + u[2] * std::sin(degrees(110)) +
                  0.5,
                1e-9);
  }
}
