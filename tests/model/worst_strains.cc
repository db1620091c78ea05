// SPDX-License-Identifier: LGPL-2.1-or-later

// The place at which a plate is compressed most and that at which it is sheared
// most are found, with their strains, on any number of ranks, and the stiffness
// of a compressed face against short waves, where cells are short.

#include <biface/model/quantities/worst_strains.h>
#include <biface/problem/parameters.h>
#include <biface/problem/shell_model.h>

#include "cord_shells.h"
#include <tests.h>

using namespace dealii;
using namespace Biface;

namespace
{
  void
  print(const std::string &name, const ValueAtPlace &strain)
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


  /** The stiffness of an isotropic plate without lateral contraction, with
   * cells of a quarter of its thickness, compressed along x. */
  void
  compress(const std::string &gradient_factor,
           const double       compression,
           const double       per_strain)
  {
    Parameters       parameters;
    ParameterHandler prm;
    read_parameters(DATA_DIR "/plate_and_bodies.prm",
                    {"Mesh/Intervals alpha_1=0:20:40",
                     "Laminate/Transverse shear=constant strain",
                     "Laminate/Gradient factor=" + gradient_factor},
                    MPI_COMM_WORLD,
                    parameters,
                    prm);
    const auto mesh = make_shell_mesh(parameters, MPI_COMM_WORLD);
    State      state(*mesh);
    LA::Vector V = mesh->owned_vector();
    for (const Node &node : mesh->nodes)
      if (node.locally_owned)
        V(node.dof(0, 0)) = -compression * node.alpha[0];
    V.compress(VectorOperation::insert);
    state.displacement = V;
    InternalForces forces(*mesh);
    forces.settle_resultants(state);

    WorstStrains worst  = worst_strains(*mesh, forces, state);
    worst.short_wave    = softest_short_wave(*mesh, forces, state, 0);
    const double strain = compression * (compression / 2 - 1);
    if (Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) != 0)
      return;
    check_small("stiffness against short waves",
                worst.short_wave->stiffness.value - (1 + per_strain * strain),
                1e-12);
    check_small("their direction", worst.short_wave->direction, 1e-12);
    check_true(
      "a sentence if it is small",
      (1 + per_strain * strain < 0.2) ==
        (describe(worst).find("Gradient factor") != std::string::npos));
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

  // K = Gh, R = Gh/3 and N = Ehe/2 on each face, with E = 2G: 1 + 2N/R, or
  // with eight times R, 1 + 2N/K
  compress("1", 0.05, 6);
  compress("1", 0.2, 6);
  compress("8", 0.2, 2);
}
