// SPDX-License-Identifier: LGPL-2.1-or-later

// The VTU file contains one quadrilateral for each face of each cell, at the
// deformed positions, and the displacement and the velocity as vectors.

#include <deal.II/base/mpi.h>

#include <iostream>
#include <limits>
#include <sstream>

#include <biface/laminate/layup.h>
#include <biface/model/state/loads.h>
#include <biface/output/shell_vtu.h>

#include "../cord_ply.h"
#include "../model/coarse_torus.h"
#include "../tests.h"

using namespace dealii;
using namespace Biface;

int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  const Layup          layup(Layup::Parameters(), cord_ply());
  const auto           mesh = coarse_torus(layup);
  const ShellEquations equations(*mesh);
  State                state(*mesh);
  state.displacement = some_displacement(*mesh, 3, 1);
  state.velocity     = some_displacement(*mesh, 200, 2);

  const FacePatches patches(equations, state, Loads());
  std::stringstream stream;
  patches.write_vtk(stream);

  const unsigned int n_quadrilaterals = 2 * mesh->n_cells();
  std::string        word;
  while (stream >> word)
    {
      if (word == "POINTS")
        {
          // the nearest deformed node of either face to each point
          unsigned int n;
          std::string  type;
          stream >> n >> type;
          double deviation = 0;
          for (unsigned int i = 0; i < n; ++i)
            {
              Point<3> x;
              stream >> x[0] >> x[1] >> x[2];
              double nearest = std::numeric_limits<double>::max();
              for (const Node &node : mesh->nodes)
                for (unsigned int face = 0; face < 2; ++face)
                  nearest = std::min(nearest,
                                     x.distance(mesh->deformed_position(
                                       state.displacement, node, face)));
              deviation = std::max(deviation, nearest);
            }
          check_true("four points a quadrilateral", n == 4 * n_quadrilaterals);
          // six digits of coordinates of about 250
          check_small("deformed positions", deviation, 4e-6, 250);
        }
      else if (word == "CELL_TYPES")
        {
          unsigned int n, type, n_good = 0;
          stream >> n;
          for (unsigned int i = 0; i < n; ++i)
            {
              stream >> type;
              n_good += (type == 9);
            }
          check_true("two quadrilaterals a cell",
                     n == n_quadrilaterals && n_good == n);
        }
      else if (word == "VECTORS")
        {
          stream >> word;
          std::cout << "a vector: " << word << std::endl;
        }
    }
}
