// SPDX-License-Identifier: LGPL-2.1-or-later

// The frequencies of free rings that spin, in the frame that does not turn, are
// those of theory: of an inextensible ring, those of Bryan (1890), and of a
// string hoop, of which the waves that run against the rotation stand still at
// any speed. The waves travel forward and backward, and neither grow nor decay.
// The errors are of second order.

#include <deal.II/base/mpi.h>

#include <array>
#include <cmath>

#include <biface/contact/rolling.h>
#include <biface/model/state/loads.h>
#include <biface/problem/shell_model.h>
#include <biface/solver/linear/make_linear_solver.h>
#include <biface/solver/modal_analysis.h>

#include <run_analysis.h>
#include <tests.h>

using namespace dealii;
using namespace Biface;

namespace
{
  constexpr double R = 100, E = 1e5, omega = 10;

  struct Ring
  {
    unsigned int n_cells;
    double       thickness;
    /** @f$\varrho\Omega^2R^2/E@f$ */
    double speed;
  };


  /** The modes of the ring in its exact equilibrium, see spinning_ring.prm. */
  std::vector<VibrationMode>
  modes(const Ring &ring, const unsigned int n)
  {
    Parameters       parameters;
    ParameterHandler prm;
    read_parameters(
      DATA_DIR "/../verification/spinning_ring.prm",
      {"Formulation=paper",
       "Supports/Point supports=",
       "Mesh/Intervals alpha_2=0:360:" + std::to_string(ring.n_cells),
       "Material wall/Density=" +
         std::to_string(1e9 * ring.speed * E / (omega * omega * R * R)) + "e-9",
       "Laminate/Plies=wall: " + std::to_string(ring.thickness) + " @ 0"},
      MPI_COMM_WORLD,
      parameters,
      prm);
    ShellModel model(parameters, make_shell_mesh(parameters, MPI_COMM_WORLD));
    const ShellMesh &mesh = *model.mesh;

    State      state(mesh);
    LA::Vector V = mesh.owned_vector();
    for (const Node &node : mesh.nodes)
      if (node.locally_owned)
        V(node.dof(2, MixedElement::mean)) =
          (std::sqrt(1 + 2 * ring.speed) - 1) * R;
    V.compress(VectorOperation::insert);
    state.displacement = V;
    model.equations.internal_forces().settle_resultants(state);

    Loads loads;
    loads.rolling = std::make_shared<const Rolling>(Rolling{omega});
    ConditionalOStream no_output(std::cout, false);
    TimerOutput        timer(
      MPI_COMM_WORLD, no_output, TimerOutput::never, TimerOutput::wall_times);
    const auto linear_solver =
      make_linear_solver(parameters.linear_solver, mesh, timer);
    ModalAnalysis analysis(
      model.equations, model.contact, *linear_solver, timer);
    const VibrationModes found = analysis.compute(state, loads, n);
    if (!found.success)
      std::cout << "FAILED: " << found.message << std::endl;
    return found.modes;
  }


  /** The frequencies (radians/time) of the modes with n waves around the ring:
   * of waves that travel backward and forward. */
  std::array<double, 2>
  frequencies(const std::vector<VibrationMode> &modes, const unsigned int n)
  {
    std::array<double, 2> result{};
    bool                  as_waves = true;
    for (const VibrationMode &mode : modes)
      if (mode.waves->circumferential == n)
        {
          const bool is_forward = mode.waves->travel > 0;
          if (result[is_forward] == 0)
            result[is_forward] = mode.omega.real();
          as_waves = as_waves && 1 - std::abs(mode.waves->travel) < 1e-4 &&
                     mode.omega.imag() == 0;
        }
    check_true("  waves without growth", as_waves);
    return result;
  }


  /** With the bending stiffness D = E h^3/12, in an inertial frame, of Bryan:
   * Proc. Cambridge Phil. Soc. 7 (1890) 101-111. */
  void
  test_bending(const unsigned int n)
  {
    constexpr double thickness = 0.5, speed = 1e-6;
    constexpr double rho    = speed * E / (omega * omega * R * R);
    const double     n2     = n * n;
    const double     split  = 2 * n * omega * (n2 - 1) / (n2 + 1);
    const double     square = E * thickness * thickness /
                          (12 * rho * R * R * R * R) * n2 * (n2 - 1) *
                          (n2 - 1) / (n2 + 1);
    std::cout << "ring, n = " << n << std::endl;
    std::array<std::array<double, 2>, 2> errors{};
    for (unsigned int i = 0; i < 2; ++i)
      {
        const auto found =
          frequencies(modes({48u << i, thickness, speed}, 10), n);
        errors[i] = {{(found[1] - found[0]) / split - 1,
                      found[1] * found[0] / square - 1}};
      }
    check_small("  split", errors[1][0], 0.002);
    check_small("  product", errors[1][1], 0.03);
    for (unsigned int k = 0; k < 2; ++k)
      check_range("  order", std::log2(errors[0][k] / errors[1][k]), 1.8, 2.2);
  }


  /** The frequencies of a stretched hoop without bending stiffness, with
   * k = E (1 + g)^2/(rho R^2),
   * (1 + n^2) k (2 n Omega - omega) - 4 n Omega k +
   * omega ((2 n Omega - omega)^2 - 4 Omega^2) = 0, or omega = 0: from the
   * equations of motion with u and the tension E h (g + g^2/2) along x'. */
  double
  forward_wave(const double n, const double speed)
  {
    const double k = (1 + 2 * speed) / speed * omega * omega;
    double       x = 2 * n * omega * (n * n - 1) / (n * n + 1);
    for (unsigned int i = 0; i < 20; ++i)
      {
        const double a     = 2 * n * omega - x;
        const double value = (1 + n * n) * k * a - 4 * n * omega * k +
                             x * (a * a - 4 * omega * omega);
        const double slope =
          -(1 + n * n) * k + a * a - 4 * omega * omega - 2 * x * a;
        x -= value / slope;
      }
    return x;
  }


  void
  test_string(const unsigned int n)
  {
    constexpr double thickness = 0.2, speed = 0.02;
    const double     exact = forward_wave(n, speed);
    std::cout << "string, n = " << n << std::endl;
    std::array<double, 2> errors{};
    for (unsigned int i = 0; i < 2; ++i)
      {
        const auto found =
          frequencies(modes({32u << i, thickness, speed}, 24 << i), n);
        errors[i] = found[1] / exact - 1;
        check_small("  stands still", found[0] / omega, 1e-3);
      }
    check_small("  forward", errors[1], 0.02);
    check_range("  order", std::log2(errors[0] / errors[1]), 1.8, 2.2);
  }
} // namespace


int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  for (const unsigned int n : {2, 3})
    {
      test_bending(n);
      test_string(n);
    }
}
