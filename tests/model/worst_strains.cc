// SPDX-License-Identifier: LGPL-2.1-or-later

// The place at which a plate is compressed most and that at which it is sheared
// most are found, with their strains, on any number of ranks.

#include <biface/model/quantities/worst_strains.h>

#include "cord_shells.h"
#include <tests.h>

using namespace dealii;
using namespace Biface;

namespace
{
  void
  print(const std::string &name, const StrainAtPlace &strain)
  {
    if (Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
      std::cout << name << " " << strain.value << " in cell " << strain.cell
                << " at " << strain.alpha << ", face "
                << (strain.face ? static_cast<int>(*strain.face) : -1)
                << std::endl;
  }


  /** @param v of the position along x and the height over the middle. */
  template <typename Displacement>
  void
  test(const ShellMesh &mesh, const Displacement &v)
  {
    InternalForces forces(mesh);
    State          state(mesh);
    LA::Vector     V = mesh.owned_vector();
    for (const Node &node : mesh.nodes)
      if (node.locally_owned)
        {
          const Tensor<1, 3> outer = v(node.alpha[0], 0.75);
          const Tensor<1, 3> inner = v(node.alpha[0], -0.75);
          for (unsigned int i = 0; i < 3; ++i)
            {
              V(node.dofs[2 * i])     = (outer[i] + inner[i]) / 2;
              V(node.dofs[2 * i + 1]) = (outer[i] - inner[i]) / 2;
            }
        }
    V.compress(VectorOperation::insert);
    state.displacement = V;

    const WorstStrains worst = worst_strains(mesh, forces, state);
    print("compression", worst.compression);
    print("shear", worst.shear);
    if (Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
      std::cout << "  names the end of the material: "
                << (describe(worst).find("-1/3") != std::string::npos ? "yes"
                                                                      : "no")
                << std::endl;
  }
} // namespace


int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  const auto mesh = plate();
  // bent downward at its end only, which compresses the inner face
  test(*mesh, [](const double x, const double z) {
    const double slope = (x > 3.9 ? 0.2 : 0);
    return Tensor<1, 3>({slope * z, 0, 0});
  });
  // crushed
  test(*mesh, [](const double, const double z) {
    return Tensor<1, 3>({0, 0, -0.4 * z});
  });
}
