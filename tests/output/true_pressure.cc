// SPDX-License-Identifier: LGPL-2.1-or-later

// The area of the faces of a plate, to which true_pressure refers, is 1.2 times
// 0.9 of what it was, where the plate is stretched by these factors.

#include <deal.II/base/mpi.h>

#include <biface/model/quantities/face_stretch.h>

#include "../model/cord_shells.h"
#include <tests.h>

using namespace dealii;
using namespace Biface;

int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  const auto mesh  = plate();
  LA::Vector owned = mesh->owned_vector();
  for (const Node &node : mesh->nodes)
    if (node.locally_owned)
      {
        owned(node.dof(0, MixedElement::mean)) = 0.2 * node.alpha[0];
        owned(node.dof(1, MixedElement::mean)) = -0.1 * node.alpha[1];
      }
  owned.compress(VectorOperation::insert);
  LA::Vector displacement = mesh->ghosted_vector();
  displacement            = owned;

  double error = 0;
  for (const auto face : {Resultants::inner, Resultants::outer})
    {
      const LA::Vector stretch = area_stretch(*mesh, displacement, face);
      for (const Node &node : mesh->nodes)
        if (node.locally_owned)
          error = std::max(
            error,
            std::abs(stretch(node.dof(2, MixedElement::mean)) - 1.2 * 0.9));
    }
  error = Utilities::MPI::max(error, MPI_COMM_WORLD);
  if (Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
    check_small("stretch of the area", error, 1e-12);
}
