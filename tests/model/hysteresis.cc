// SPDX-License-Identifier: LGPL-2.1-or-later

// A triangular cycle dissipates 56 zeta(3)/pi^3 per volume at a loss factor of
// one, on any mesh, and its first harmonic 64/pi^3 of it. In a ring that waves
// with a single harmonic n a turn dissipates 4 pi n eta times the strain
// energy, with an error of second order, and each ply its share.

#include <deal.II/base/mpi.h>

#include <array>
#include <cmath>

#include <biface/laminate/layup.h>
#include <biface/model/equations/shell_equations.h>
#include <biface/model/mesh/named_points.h>
#include <biface/model/mesh/supports.h>
#include <biface/model/quantities/cyclic_loss.h>
#include <biface/model/quantities/hysteresis.h>
#include <biface/surface/grid_parameters.h>
#include <biface/surface/intervals.h>
#include <biface/surface/straight_line.h>
#include <biface/surface/surface_of_revolution.h>

#include <tests.h>

using namespace dealii;
using namespace Biface;

namespace
{
  void
  test_triangle()
  {
    // from 1 at 0.3 to -1 half a turn later
    const double              pi = numbers::PI;
    const std::vector<double> angles{
      0.3, 0.4, 1.1, 2.9, 3, 0.3 + pi, 3.5, 4.2, 5.9};
    const auto value = [&](const double angle) {
      return 1 - 2 * std::abs(angle - 0.3) / pi;
    };
    const auto loss = [&](const CyclicLoss &loss) {
      double sum = 0;
      for (unsigned int j = 0; j < angles.size(); ++j)
        for (unsigned int k = 0; k < angles.size(); ++k)
          {
            const auto at = [&](const double angle) {
              return angle <= 0.3 + pi ? value(angle) : -value(angle - pi);
            };
            sum += at(angles[j]) * loss.matrix()(j, k) * at(angles[k]);
          }
      return sum;
    };
    const double zeta_3 = 1.2020569031595942;
    const double exact  = 56 * zeta_3 / (pi * pi * pi);
    check_small("triangular cycle", loss(CyclicLoss(angles)) - exact, 1e-12);
    check_small("its first harmonic",
                loss(CyclicLoss(angles, 1)) - 64 / (pi * pi * pi),
                1e-12);
  }


  struct Losses
  {
    double                energy;
    std::array<double, 2> plies;
    double                first;
  };

  /** The losses of a ring with waves, relative to those of a single
   * harmonic. */
  Losses
  losses_of_ring(const unsigned int n_cells)
  {
    constexpr unsigned int   n = 3;
    StraightLine::Parameters line;
    line.start   = Point<2>(100, 0);
    line.end     = Point<2>(100, 10);
    auto surface = std::make_unique<SurfaceOfRevolution>(
      std::make_shared<StraightLine>(line));
    ChartGrid::Parameters parameters;
    parameters.intervals = {
      {parse_intervals("intervals", "0:10:2"),
       parse_intervals("intervals", "0:360:" + std::to_string(n_cells))}};
    parameters.closed = true;
    const ChartGrid                 grid(parameters, *surface);
    std::vector<MaterialParameters> materials(2);
    for (unsigned int m = 0; m < 2; ++m)
      {
        materials[m].name        = (m == 0 ? "soft" : "stiff");
        materials[m].E           = (m == 0 ? 10 : 30);
        materials[m].loss_factor = (m == 0 ? 0.3 : 0.1);
      }
    Layup::Parameters layup;
    layup.plies     = parse_plies("plies", "soft: 2 @ 0, stiff: 2 @ 0");
    layup.reference = parse_thickness_position("reference", "2");
    const ShellMesh      mesh(MPI_COMM_WORLD,
                         std::move(surface),
                         grid,
                         Layup(layup, materials),
                         Supports(),
                         {},
                         Formulation::paper);
    const ShellEquations equations(mesh);

    // both faces move by cos(n phi) along the normal: small strains of a
    // single harmonic, hoop strain and transverse shear
    LA::Vector V = mesh.owned_vector();
    for (const Node &node : mesh.nodes)
      if (node.locally_owned)
        V(node.dof(2, MixedElement::mean)) = 1e-6 * std::cos(n * node.alpha[1]);
    V.compress(VectorOperation::insert);
    State state(mesh);
    state.displacement = V;
    equations.internal_forces().settle_resultants(state);
    const double energy = equations.internal_forces().strain_energy(state);

    const Hysteresis hysteresis = find_hysteresis(equations, state);
    const double     scale      = 4 * numbers::PI * n * energy;
    return {hysteresis.energy() / scale,
            {{hysteresis.plies[0].energy / (0.3 * scale),
              hysteresis.plies[1].energy / (0.1 * scale)}},
            (hysteresis.plies[0].of_first_harmonics +
             hysteresis.plies[1].of_first_harmonics) /
              hysteresis.energy()};
  }
} // namespace


int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  const Losses                     coarse = losses_of_ring(24);
  const Losses                     fine   = losses_of_ring(48);
  if (Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) != 0)
    return 0;

  test_triangle();
  const auto excess = [](const Losses &losses) {
    return losses.plies[0] + losses.plies[1] - 1;
  };
  check_small("energy of the ring", excess(fine), 0.03);
  check_range("order", std::log2(excess(coarse) / excess(fine)), 1.9, 2.1);
  check_range("share of the first harmonics", fine.first, 0.995, 1);
  // both plies have nearly the same strains
  check_small(
    "ply of the triple modulus", fine.plies[1] / fine.plies[0] - 3, 0.02, 3);
  std::cout << "energy of the plies: " << fine.plies[0] << ' ' << fine.plies[1]
            << std::endl;
}
