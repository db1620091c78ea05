// SPDX-License-Identifier: LGPL-2.1-or-later

// The cavity below a plate that lifts and moves sideways grows by the area
// times the lift, wherever the plate lies in its plane.

#include <biface/model/forces/cavity.h>

#include "cord_shells.h"
#include <tests.h>

using namespace dealii;
using namespace Biface;

int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  const double       area = 20 * 10;
  const Tensor<1, 3> motion({-3, 5, 2});
  Cavity::Parameters parameters;
  parameters.volume = 1000;
  for (const std::string x : {"-10:10:4", "30:50:4"})
    {
      const auto mesh = free_shell(std::make_unique<Plane>(), {{x, "0:10:2"}});
      const Cavity cavity(*mesh, parameters, Resultants::inner);
      State        state(*mesh);
      check_small("volume at rest", cavity.volume(state) - 1000, 1e-12, 1000);

      LA::Vector V = mesh->owned_vector();
      for (const Node &node : mesh->nodes)
        if (node.locally_owned)
          for (unsigned int i = 0; i < 3; ++i)
            V(node.dof(i, MixedElement::mean)) = motion[i];
      V.compress(VectorOperation::insert);
      state.displacement = V;
      check_small(
        "growth", cavity.volume(state) - 1000 - area * motion[2], 1e-12, 1000);
    }
}
