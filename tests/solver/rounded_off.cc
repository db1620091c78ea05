// SPDX-License-Identifier: LGPL-2.1-or-later

// A very thin shell on small cells, whose linear systems are solved with few
// digits, is iterated until its updates have become small: the pinched cylinder
// with the radius over thickness 1e6 has the displacement of inextensional
// bending (Timoshenko and Woinowsky-Krieger, Theory of Plates and Shells, 120).

#include <biface/model/quantities/point_displacement.h>

#include <run_analysis.h>
#include <tests.h>

using namespace Biface;

int
main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  const double exact = 1.912;
  for (const unsigned int n : {32, 64})
    {
      const std::string cells = std::to_string(n);
      double            u     = 0;
      run_analysis(
        DATA_DIR "/../verification/pinched_free_cylinder_1000000.prm",
        {"Mesh/Intervals alpha_1=0:5.175:" + cells,
         "Mesh/Intervals alpha_2=0:90:" + cells},
        [&](const ShellEquations &equations,
            const StepReport &,
            const State &state) {
          const PointDisplacement at = displacement_at(
            equations.mesh.points[0], state.displacement, equations.mesh);
          u = (at.global[0][0] + at.global[1][0]) / 2;
        });
      check_small(cells + " cells", -u - exact, 5e-3, exact);
    }
}
