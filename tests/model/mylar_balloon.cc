// SPDX-License-Identifier: LGPL-2.1-or-later

// Two disks of foil that does not stretch, joined at their rim, become a Mylar
// balloon: its radius is 0.7628 of that of the disks, and half its thickness
// 0.4569 (W. H. Paulsen, Amer. Math. Monthly 101 (1994), 953-958).

#include <algorithm>
#include <cmath>

#include <biface/model/equations/shell_equations.h>
#include <biface/model/mesh/shell_mesh.h>

#include <run_analysis.h>
#include <tests.h>

using namespace Biface;

int
main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  double radius = 0, half_thickness = 0;
  run_analysis(DATA_DIR "/mylar_balloon.prm",
               {},
               [&](const ShellEquations &equations,
                   const StepReport & /*report*/,
                   const State &state) {
                 radius = half_thickness = 0;
                 for (const Node &node : equations.mesh.nodes)
                   {
                     const auto x = equations.mesh.deformed_position(
                       state.displacement, node, Resultants::outer);
                     radius         = std::max(radius, std::hypot(x[0], x[2]));
                     half_thickness = std::max(half_thickness, std::abs(x[1]));
                   }
               });
  check_small("radius", radius - 0.7627597635, 1e-3, 0.7627597635);
  check_small(
    "half the thickness", half_thickness - 0.4569465810, 2e-3, 0.4569465810);
}
