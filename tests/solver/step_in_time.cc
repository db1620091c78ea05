// SPDX-License-Identifier: LGPL-2.1-or-later

// Newton's method solves any EquationSystem: with forces of inertia by the
// implicit Euler method, a free plate under a constant force moves in n steps
// of the time dt by n dt v_0 + n (n + 1)/2 dt^2 f/(rho h).

#include <deal.II/base/timer.h>

#include <fstream>
#include <iostream>

#include <biface/model/equations/mass_matrix.h>
#include <biface/model/state/loads.h>
#include <biface/problem/shell_model.h>
#include <biface/solver/linear/eigenpairs.h>
#include <biface/solver/linear/mumps_solver.h>
#include <biface/solver/newton.h>

#include <run_analysis.h>
#include <tests.h>

using namespace dealii;
using namespace Biface;

namespace
{
  const std::string plate = "subsection Surface\n  set Type = plane\nend\n"
                            "subsection Mesh\n"
                            "  set Intervals alpha_1 = 0:100:4\n"
                            "  set Intervals alpha_2 = 0:50:3\n"
                            "  set Closed in alpha_2 = false\nend\n"
                            "subsection Material cord\n"
                            "  set Type    = isotropic\n"
                            "  set E       = 1000\n  set nu      = 0.3\n"
                            "  set Density = 1e-9\nend\n"
                            "subsection Laminate\n  set Plies = cord: 2 @ 0\n"
                            "  set Reference surface = middle\nend\n"
                            "subsection Loads\n"
                            "  set Area force = 0, 0, 3e-6\nend\n";


  /** The equations of the shell with its inertia in a step in time. */
  class StepInTime : public EquationSystem
  {
  public:
    StepInTime(ShellEquations &shell, const double dt)
      : EquationSystem(shell.mesh), dt(dt), shell(shell), mass(shell.mesh)
    {}

    void
    start(const State &state)
    {
      before = state;
    }

    /** The velocity at the end of the step. */
    LA::Vector
    velocity(const State &state) const
    {
      LA::Vector result = mesh.owned_vector();
      result            = state.displacement;
      LA::Vector last   = mesh.owned_vector();
      last              = before.displacement;
      result -= last;
      result /= dt;
      return result;
    }

    void
    assemble(const State &state, const Loads &loads) override
    {
      shell.assemble(state, loads);
      set_tangent();
      add_inertia(state);
    }

    void
    add_contact(const State &state, const Loads &loads) override
    {
      shell.add_contact(state, loads);
      set_tangent();
      add_inertia(state);
    }

    void
    assemble_residual(const State &state, const Loads &loads) override
    {
      shell.assemble_residual(state, loads);
      add_inertia(state);
    }

    const LA::Vector &
    residual() const override
    {
      return rhs;
    }

    const LA::SparseMatrix &
    tangent() const override
    {
      return matrix;
    }

    double
    relative_residual() const override
    {
      return rhs.l2_norm() / scale;
    }

    bool
    is_symmetric(const Loads &loads) const override
    {
      return shell.is_symmetric(loads);
    }

    bool
    is_symmetric_but_for_loads(const Loads &loads) const override
    {
      return shell.is_symmetric_but_for_loads(loads);
    }

    std::vector<RankOne>
    low_rank_part(const State &state, const Loads &loads) const override
    {
      return shell.low_rank_part(state, loads);
    }

    Loads
    with_dependent_loads(const State &state, const Loads &loads) const override
    {
      return shell.with_dependent_loads(state, loads);
    }

    LA::Vector
    load_direction(const State     &state,
                   const Loads     &loads,
                   const LoadRates &rates) const override
    {
      return shell.load_direction(state, loads, rates);
    }

    double
    relative_roundoff(const State &state) const override
    {
      return shell.relative_roundoff(state);
    }

    double
    support_violation() const override
    {
      return shell.support_violation();
    }

    void
    distribute(LA::Vector &increment) const override
    {
      shell.distribute(increment);
    }

    void
    update(State                &state,
           const LA::Vector     &increment,
           const NewtonIteration iteration) const override
    {
      shell.update(state, increment, iteration);
    }

    void
    settle(State &state) const override
    {
      shell.settle(state);
    }

    const double dt;

  private:
    void
    set_tangent()
    {
      matrix.copy_from(shell.tangent());
      matrix.add(1 / (dt * dt), mass.get());
    }

    void
    add_inertia(const State &state)
    {
      LA::Vector change = velocity(state), last = mesh.owned_vector(),
                 inertia = mesh.owned_vector();
      last               = before.velocity;
      change -= last;
      mass.vmult(inertia, change);
      rhs   = shell.residual();
      scale = rhs.l2_norm() + inertia.l2_norm() / dt;
      rhs.add(-1 / dt, inertia);
    }

    ShellEquations  &shell;
    const MassMatrix mass;
    State            before;
    LA::SparseMatrix matrix;
    LA::Vector       rhs;
    double           scale = 1;
  };
} // namespace


int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  ConditionalOStream               out(std::cout, false);
  TimerOutput timer(out, TimerOutput::never, TimerOutput::wall_times);

  std::ofstream("plate.prm") << plate;
  const Parameters parameters = parameters_of("plate.prm");
  ShellModel model(parameters, make_shell_mesh(parameters, MPI_COMM_WORLD));
  const ShellMesh &mesh = *model.mesh;

  const double       dt = 1e-3, v_0 = 50, acceleration = 3e-6 / (1e-9 * 2);
  constexpr unsigned n_steps = 3;
  StepInTime         equations(model.equations, dt);
  MumpsSolver        solver(MPI_COMM_WORLD, timer);
  Newton             newton(
    Newton::Parameters(), equations, model.contact, solver, out, timer);
  ParametrizedLoads loads;
  loads.at = [](const LoadParameters &) {
    Loads loads;
    loads.factors = {1};
    return loads;
  };

  State state(mesh);
  model.equations.start_stage(loads.at({0.}), state);
  LA::Vector start = mesh.owned_vector();
  for (const Node &node : mesh.nodes)
    if (node.locally_owned)
      start(node.dof(2, MixedElement::mean)) = v_0;
  start.compress(VectorOperation::insert);
  state.velocity = mesh.ghosted_vector();
  state.velocity = start;

  bool converged = true;
  for (unsigned int n = 0; n < n_steps; ++n)
    {
      equations.start(state);
      LoadParameters mu{0.};
      converged =
        newton.solve(state, loads, mu, NewtonIteration::mixed).converged &&
        converged;
      state.velocity = equations.velocity(state);
    }

  const double exact =
    n_steps * dt * v_0 + n_steps * (n_steps + 1) / 2 * dt * dt * acceleration;
  double error = 0;
  for (const Node &node : mesh.nodes)
    for (unsigned int face = 0; face < 2; ++face)
      {
        Tensor<1, 3> difference =
          mesh.displacement(state.displacement, node, face);
        difference[2] -= exact;
        error = std::max(error, difference.norm() / exact);
      }
  error = Utilities::MPI::max(error, MPI_COMM_WORLD);
  if (Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
    {
      check_true("all steps converge", converged);
      check_small("displacement", error, 1e-9);
    }
}
