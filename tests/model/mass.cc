// SPDX-License-Identifier: LGPL-2.1-or-later

// The mass of the bias tire is its density times thickness and area of the
// middle surface. On a fine mesh a translation has this mass. The mass matrix
// of the free unknowns and the inertia of all agree.

#include <deal.II/base/mpi.h>

#include <biface/model/equations/mass_matrix.h>
#include <biface/model/mesh/rigid_motions.h>

#include <run_analysis.h>
#include <tests.h>

using namespace dealii;
using namespace Biface;

namespace
{
  void
  test(const std::vector<Override> &mesh_overrides, const double bound)
  {
    std::vector<Override> overrides = mesh_overrides;
    overrides.push_back("Material cord/Density=1.2e-9");
    const Analysis   analysis(PRM_DIR "/bias_tire.prm", overrides);
    const ShellMesh &mesh = analysis.simulation.get_equations().mesh;
    const MassMatrix mass(mesh);
    const bool root = Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0;

    // a torus of radii 200 and 52.4, from -120 to 120 degrees: the middle
    // surface has the area 2 pi 52.4 (200 psi + 52.4 sin psi)
    const double psi   = 2 * numbers::PI / 3;
    const double exact = 1.2e-9 * 4.8 * 2 * numbers::PI * 52.4 * 2 *
                         (200 * psi + 52.4 * std::sin(psi));
    if (root)
      {
        std::cout << "mesh with " << mesh.n_cells() << " cells" << std::endl;
        check_small("  mass", mass.total() - exact, 5e-4, exact);
        if (mesh_overrides.empty())
          check_small("  mass in t", mass.total() - 1.761e-3, 5e-4, 1.761e-3);
      }

    // without supports, the inertia of a translation adds up to the mass
    const auto motions = rigid_motions(mesh);
    for (unsigned int d = 0; d < 3; ++d)
      {
        LA::Vector owned = mesh.owned_vector(), ghosted = mesh.ghosted_vector();
        std::copy(motions[d].begin(), motions[d].end(), owned.begin());
        ghosted             = owned;
        const double square = inertia(mesh, ghosted) * owned;
        if (root)
          check_small("  mass of a translation",
                      square - mass.total(),
                      bound,
                      mass.total());
      }

    // displacements that satisfy the supports
    LA::Vector v = mesh.owned_vector(), ghosted = mesh.ghosted_vector();
    std::copy(motions[3].begin(), motions[3].end(), v.begin());
    mesh.constraints.set_zero(v);
    ghosted      = v;
    LA::Vector a = mesh.owned_vector();
    LA::Vector b = inertia(mesh, ghosted);
    mesh.condense(b);
    mass.vmult(a, v);
    a -= b;
    const double difference = a.l2_norm(), scale = b.l2_norm();
    if (root)
      check_small("  matrix and inertia", difference, 1e-13, scale);
  }
} // namespace


int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  test({}, 5e-2);
  test({"Mesh/Intervals alpha_1=-120:120:40",
        "Mesh/Intervals alpha_2=-180:180:120"},
       2e-3);
}
