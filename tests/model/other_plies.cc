// SPDX-License-Identifier: LGPL-2.1-or-later

// The forces of a mesh whose plies are replaced are those of a mesh that has
// these plies from the start; plies that place the faces elsewhere do not
// replace any.

#include <biface/laminate/layup.h>
#include <biface/model/state/loads.h>

#include "coarse_torus.h"
#include <cord_ply.h>
#include <tests.h>

using namespace dealii;
using namespace Biface;

namespace
{
  LA::Vector
  forces(const ShellMesh &mesh)
  {
    const ShellEquations equations(mesh);
    const State          state =
      at(equations, State(mesh), some_displacement(mesh, 0.2, 1));
    return equations.out_of_balance_forces(state, Loads());
  }
} // namespace

int
main(int argc, char **argv)
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  Layup::Parameters turned, thick;
  turned.plies = parse_plies("plies", "cord: 2.4 @ 40, cord: 2.4 @ -30");
  thick.plies  = parse_plies("plies", "cord: 2.5 @ 40, cord: 2.4 @ -30");

  std::shared_ptr<const ShellMesh> replaced;
  LA::Vector                       before;
  bool                             thick_fits;
  {
    // the new mesh outlives the old one
    const auto mesh = coarse_torus(Layup(Layup::Parameters(), cord_ply()));
    before          = forces(*mesh);
    replaced        = mesh->with_layup(Layup(turned, cord_ply()));
    thick_fits      = (mesh->with_layup(Layup(thick, cord_ply())) != nullptr);
  }
  LA::Vector       difference = forces(*replaced);
  const double     size       = difference.l2_norm();
  const LA::Vector anew = forces(*coarse_torus(Layup(turned, cord_ply())));
  before -= anew;
  difference -= anew;
  const double changed = before.l2_norm() / size;
  const double wrong   = difference.l2_norm() / size;
  if (Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) != 0)
    return 0;
  check_small("replaced against anew", wrong, 1e-13);
  std::cout << "the plies matter: " << (changed > 1e-3) << std::endl
            << "thicker plies fit: " << thick_fits << std::endl;
}
