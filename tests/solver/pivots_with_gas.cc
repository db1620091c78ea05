// SPDX-License-Identifier: LGPL-2.1-or-later

// A straight strip beyond its buckling load has one negative pivot, and none on
// a gas that resists its deflection, also if the load is controlled and the
// linear solver takes new factors in each solution.

#include <deal.II/base/timer.h>

#include <fstream>
#include <iostream>

#include <biface/model/state/loads.h>
#include <biface/problem/shell_model.h>
#include <biface/solver/linear/mumps_solver.h>
#include <biface/solver/newton.h>

#include <run_analysis.h>
#include <tests.h>

using namespace dealii;
using namespace Biface;

namespace
{
  const std::string strip = "subsection Surface\n  set Type = plane\nend\n"
                            "subsection Mesh\n"
                            "  set Intervals alpha_1 = 0:100:20\n"
                            "  set Intervals alpha_2 = 0:10:1\n"
                            "  set Closed in alpha_2 = false\nend\n"
                            "subsection Material cord\n"
                            "  set Type = isotropic\n"
                            "  set E    = 1000\n  set nu   = 0\nend\n"
                            "subsection Laminate\n  set Plies = cord: 2 @ 0\n"
                            "  set Reference surface = inner\nend\n"
                            "subsection Supports\n  set alpha_1 min = fixed\n"
                            "  set alpha_1 max = v_3 both\n"
                            "  set alpha_2 min = symmetry\n"
                            "  set alpha_2 max = symmetry\nend\n"
                            "subsection Loads\n"
                            "  set Edge forces = alpha_1 max: -1 0 0\nend\n"
                            "subsection Gas\n  set Ambient pressure = 0.1\n"
                            "  set Cavity volume = 100\nend\n";


  /** Reports the pivots of its factors with each solution. */
  class AlwaysNewFactors : public LinearSolver
  {
  public:
    explicit AlwaysNewFactors(TimerOutput &timer)
      : solver(MPI_COMM_WORLD, timer, false)
    {}

    LinearSolverResult
    factorize(const LA::SparseMatrix &A, const Symmetry symmetry) override
    {
      last = solver.factorize(A, symmetry);
      return last;
    }

    LinearSolverResult
    solve(LA::Vector &x, const LA::Vector &b, const double tolerance) override
    {
      solver.solve(x, b, tolerance);
      return last;
    }

    LinearSolverResult
    solve_transposed(LA::Vector       &x,
                     const LA::Vector &b,
                     const double      tolerance) override
    {
      solver.solve_transposed(x, b, tolerance);
      return last;
    }

  private:
    MumpsSolver        solver;
    LinearSolverResult last;
  };


  /** Prescribes the load factor. */
  class GivenFactor : public ControlEquation
  {
  public:
    explicit GivenFactor(const double factor)
      : ControlEquation(unit_factor()), factor(factor)
    {}

    double
    parameter_change(const Iteration &iteration,
                     const LA::Vector &,
                     const LA::Vector &) const override
    {
      return factor - iteration.loads.factors[0];
    }

    double
    violation(const Iteration &iteration) const override
    {
      return std::abs(factor - iteration.loads.factors[0]) / factor;
    }

  private:
    static LoadRates
    unit_factor()
    {
      LoadRates rates;
      rates.factors = {1};
      return rates;
    }

    const double factor;
  };
} // namespace


int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  ConditionalOStream               out(std::cout, false);
  TimerOutput timer(out, TimerOutput::never, TimerOutput::wall_times);

  std::ofstream("strip.prm") << strip;
  const Parameters parameters = parameters_of("strip.prm");
  ShellModel model(parameters, make_shell_mesh(parameters, MPI_COMM_SELF));
  AlwaysNewFactors solver(timer);
  Newton           newton(
    Newton::Parameters(), model.equations, model.contact, solver, out, timer);
  const GivenFactor equation(2);

  for (const bool sealed : {false, true})
    for (const bool controlled : {false, true})
      {
        ParametrizedLoads loads;
        loads.equations = (controlled ? &equation : nullptr);
        loads.at        = [sealed](const LoadParameters &factor) {
          Loads loads;
          loads.factors    = {factor[0]};
          loads.sealed_gas = sealed;
          return loads;
        };
        State state(*model.mesh);
        model.equations.start_stage(loads.at({0.}), state);
        LoadParameters     factor{controlled ? 1.9 : 2.};
        const NewtonResult result =
          newton.solve(state, loads, factor, NewtonIteration::mixed);
        std::cout << (sealed ? "with" : "without") << " gas"
                  << (controlled ? ", controlled: " : ": ")
                  << (result.converged ? "" : "not converged, ")
                  << result.n_negative_pivots.value_or(99) << std::endl;
      }
}
