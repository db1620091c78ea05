// SPDX-License-Identifier: LGPL-2.1-or-later

// A torus that is moved and turned as a rigid body stores no energy with the
// standard formulation; with that of the paper its energy decreases with the
// fourth power of the size of the cells.

#include <deal.II/physics/transformations.h>

#include <biface/laminate/layup.h>
#include <biface/model/contact/contact_interaction.h>
#include <biface/model/contact/contact_pair.h>
#include <biface/model/contact/contact_parameters.h>
#include <biface/model/equations/force_terms.h>
#include <biface/model/equations/shell_equations.h>
#include <biface/model/mesh/named_points.h>
#include <biface/model/mesh/supports.h>
#include <biface/surface/circular_arc.h>
#include <biface/surface/grid_parameters.h>
#include <biface/surface/intervals.h>
#include <biface/surface/surface_of_revolution.h>

#include <cord_ply.h>
#include <tests.h>

using namespace dealii;
using namespace Biface;

namespace
{
  /** The energy after x -> R x + t, and the energy of a stretch along x by
   * a thousandth. */
  std::array<double, 2>
  energies(const Formulation   formulation,
           const unsigned int  n,
           const Tensor<2, 3> &R,
           const Tensor<1, 3> &t)
  {
    CircularArc::Parameters arc;
    auto                    surface =
      std::make_unique<SurfaceOfRevolution>(std::make_shared<CircularArc>(arc));
    ChartGrid::Parameters parameters;
    parameters.intervals = {
      {parse_intervals("intervals", "-120:120:" + std::to_string(2 * n)),
       parse_intervals("intervals", "-30:30:" + std::to_string(n))}};
    parameters.closed = false;
    const ChartGrid          grid(parameters, *surface);
    const ShellMesh          mesh(MPI_COMM_WORLD,
                         std::move(surface),
                         grid,
                         Layup(Layup::Parameters(), cord_ply()),
                         Supports(),
                         {},
                         formulation);
    const ContactInteraction contact(mesh, ContactParameters());
    ShellEquations           equations(mesh, make_force_terms(mesh, contact));

    const auto energy = [&](const Tensor<2, 3> &A, const Tensor<1, 3> &b) {
      LA::Vector V = mesh.owned_vector();
      for (const Node &node : mesh.nodes)
        if (node.locally_owned)
          {
            std::array<Tensor<1, 3>, 2> u;
            for (unsigned int face = 0; face < 2; ++face)
              {
                const Tensor<1, 3> x =
                  node.surface.position +
                  node.face_heights[face] * node.surface.frame[2];
                u[face] = node.surface.to_frame(A * x + b - x);
              }
            for (unsigned int i = 0; i < 3; ++i)
              {
                V(node.dof(i, MixedElement::mean)) = (u[1][i] + u[0][i]) / 2;
                V(node.dof(i, MixedElement::half_difference)) =
                  (u[1][i] - u[0][i]) / 2;
              }
          }
      V.compress(VectorOperation::insert);
      State state(mesh);
      state.displacement = V;
      equations.internal_forces().settle_resultants(state);
      return equations.internal_forces().strain_energy(state);
    };
    Tensor<2, 3> stretch = unit_symmetric_tensor<3>();
    stretch[0][0] += 1e-3;
    return {{energy(R, t), energy(stretch, Tensor<1, 3>())}};
  }


  void
  print(const std::string &name, const Tensor<2, 3> &R, const Tensor<1, 3> &t)
  {
    const bool root = Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0;
    if (root)
      std::cout << name << std::endl;
    const auto coarse = energies(Formulation::paper, 6, R, t);
    const auto fine   = energies(Formulation::paper, 12, R, t);
    if (root)
      check_range("  paper, half and whole cells", coarse[0] / fine[0], 14, 18);
    const auto energy = energies(Formulation::standard, 6, R, t);
    if (root)
      check_small("  standard", energy[0], 1e-15, energy[1]);
  }
} // namespace


int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  const Tensor<2, 3>               unit = unit_symmetric_tensor<3>();
  print("moved by 15 mm along the axis", unit, Tensor<1, 3>({0, 15, 0}));
  print("turned by 40 degrees",
        Physics::Transformations::Rotations::rotation_matrix_3d(
          Point<3>(0, 1, 0), 40 * numbers::PI / 180),
        Tensor<1, 3>());
}
