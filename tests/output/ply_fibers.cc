// SPDX-License-Identifier: LGPL-2.1-or-later

// The fiber directions written for a plate with a ply at 30 degrees follow its
// deformation: it is stretched by half along x and rotated about z, so that the
// slope of the fibers to the rotated x axis is tan(30)/1.5.

#include <deal.II/base/mpi.h>
#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>
#include <sstream>

#include <biface/model/equations/shell_equations.h>
#include <biface/output/plies_vtu.h>

#include "../model/cord_shells.h"
#include "../tests.h"

using namespace dealii;
using namespace Biface;

int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  const auto           shell = plate();
  const ShellEquations equations(*shell);

  State        state(*shell);
  LA::Vector   V    = shell->owned_vector();
  const double turn = 0.7;
  for (const Node &node : shell->nodes)
    if (node.locally_owned)
      {
        const Point<3> &x = node.surface.position;
        const double    s = 1.5 * x[0];
        // the frame of a plate is that of space
        const Tensor<1, 3> u({s * std::cos(turn) - x[1] * std::sin(turn) - x[0],
                              s * std::sin(turn) + x[1] * std::cos(turn) - x[1],
                              0});
        for (unsigned int i = 0; i < 3; ++i)
          V(node.dof(i, MixedElement::mean)) = u[i];
      }
  V.compress(VectorOperation::insert);
  state.displacement = V;

  const PlyPatches  patches(equations, state, FailureCriteria());
  std::stringstream stream;
  patches.write_vtk(stream);

  const double       angle = std::atan(std::tan(numbers::PI / 6) / 1.5) + turn;
  const Tensor<1, 3> expected({std::cos(angle), std::sin(angle), 0});
  std::string        word;
  while (stream >> word)
    if (word == "fiber")
      {
        stream >> word;
        double deviation = 0;
        for (unsigned int i = 0; i < 8 * shell->n_cells(); ++i)
          {
            Tensor<1, 3> fiber;
            stream >> fiber[0] >> fiber[1] >> fiber[2];
            deviation = std::max(deviation, (fiber - expected).norm());
          }
        // six digits are written
        check_small("fibers", deviation, 3e-6);
      }
}
