// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/lac/solver_gmres.h>
#include <deal.II/lac/trilinos_sparse_matrix.h>

#include <algorithm>
#include <sstream>

#include <biface/model/rigid_motions.h>
#include <biface/solver/linear/multigrid_solver.h>

#include <Teuchos_ParameterList.hpp>
#include <ml_MultiLevelPreconditioner.h>

namespace Biface
{
  using namespace dealii;

  void
  LinearSolver::Parameters::Multigrid::add_parameters(ParameterHandler &prm)
  {
    prm.add_parameter("Maximum iterations",
                      max_iterations,
                      "Number of GMRES iterations after which a linear solve "
                      "has failed.",
                      Patterns::Integer(1));
    prm.add_parameter("Restart length",
                      restart_length,
                      "Number of iterations after which GMRES restarts; each "
                      "needs the memory of a vector.",
                      Patterns::Integer(10));
    prm.add_parameter("Smoother sweeps",
                      sweeps,
                      "Sweeps of symmetric Gauss-Seidel on each level, "
                      "before and after the coarser level.",
                      Patterns::Integer(1, 20));
  }


  MultigridSolver::MultigridSolver(const Parameters &parameters,
                                   const ShellMesh  &mesh,
                                   TimerOutput      &timer)
    : parameters(parameters), timer(timer)
  {
    for (const std::vector<double> &motion : rigid_motions(mesh))
      near_null_space.insert(
        near_null_space.end(), motion.begin(), motion.end());
  }


  LinearSolverResult
  MultigridSolver::factorize(const LA::SparseMatrix &A,
                             const bool /*symmetric*/,
                             const bool /*similar*/)
  {
    TimerOutput::Scope scope(timer, "Linear solver: multigrid set-up");
    preconditioner.clear();
    matrix = &A;

    Teuchos::ParameterList list;
    ML_Epetra::SetDefaults("SA", list);
    list.set("ML output", 0);
    list.set("PDE equations", 6);
    list.set("smoother: type", "symmetric Gauss-Seidel");
    list.set("smoother: sweeps", static_cast<int>(parameters.sweeps));
    list.set("coarse: type", "Amesos-KLU");
    list.set("coarse: max size", 3000);
    list.set("null space: type", "pre-computed");
    list.set("null space: dimension", 6);
    list.set("null space: vectors", near_null_space.data());

    LinearSolverResult result;
    try
      {
        preconditioner.initialize(A, list);
        result.success = true;
      }
    catch (const ExceptionBase &)
      {
        result.message = "the multigrid preconditioner could not be set up: "
                         "the tangent may be singular";
      }
    return result;
  }


  LinearSolverResult
  MultigridSolver::solve(LA::Vector       &x,
                         const LA::Vector &b,
                         const double      tolerance)
  {
    TimerOutput::Scope scope(timer, "Linear solver: multigrid iterations");

    Assert(matrix != nullptr, ExcNotInitialized());
    x = 0;

    // left preconditioning, so that the tolerance refers to the preconditioned
    // residual
    LinearSolverResult result;
    ReductionControl   control(parameters.max_iterations, 0, tolerance);
    const SolverGMRES<LA::Vector>::AdditionalData vectors(
      parameters.restart_length + 2);
    try
      {
        SolverGMRES<LA::Vector>(control, vectors)
          .solve(*matrix, x, b, preconditioner);
        result.success = true;
      }
    catch (const SolverControl::NoConvergence &)
      {
        std::ostringstream message;
        message << "GMRES with multigrid did not converge: after "
                << control.last_step()
                << " iterations the preconditioned residual was "
                << control.last_value() / control.initial_value()
                << " of the initial one (tolerance " << tolerance << ")";
        result.message = message.str();
        result.cause   = FailureCause::linear_iterations;
      }
    return result;
  }
} // namespace Biface
