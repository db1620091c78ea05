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
    : parameters(parameters), mesh(mesh), timer(timer)
  {
    const auto is_free = [&](const types::global_dof_index dof) {
      return !mesh.constraints.is_constrained(dof);
    };
    for (const Node &node : mesh.nodes)
      if (node.locally_owned)
        for (unsigned int i = 0; i < 6; i += 2)
          if (is_free(node.dofs[i]) && is_free(node.dofs[i + 1]))
            {
              Assert(node.dofs[i + 1] == node.dofs[i] + 1, ExcInternalError());
              pairs.push_back(
                mesh.locally_owned.index_within_set(node.dofs[i]));
            }

    for (std::vector<double> motion : rigid_motions(mesh))
      {
        for (const unsigned int p : pairs)
          {
            const double inner = motion[p], outer = motion[p + 1];
            motion[p]     = (inner + outer) / 2;
            motion[p + 1] = (outer - inner) / 2;
          }
        near_null_space.insert(
          near_null_space.end(), motion.begin(), motion.end());
      }
  }


  void
  MultigridSolver::transform_matrix()
  {
    const Epetra_CrsMatrix &epetra = matrix.trilinos_matrix();
    int                    *starts;
    int                    *columns;
    double                 *values;
    const int error = epetra.ExtractCrsDataPointers(starts, columns, values);
    AssertThrow(error == 0,
                ExcMessage("The matrix is not stored "
                           "contiguously."));

    // columns: A <- A T, for the pairs whose two columns are adjacent
    std::vector<bool> paired_column(epetra.ColMap().NumMyElements(), false);
    for (int j = 0; j + 1 < epetra.ColMap().NumMyElements(); ++j)
      {
        const types::global_dof_index dof = epetra.GCID(j);
        paired_column[j]                  = dof % 2 == 0 &&
                           !mesh.constraints.is_constrained(dof) &&
                           !mesh.constraints.is_constrained(dof + 1);
      }
    for (int k = 0; k < starts[epetra.NumMyRows()]; ++k)
      if (paired_column[columns[k]])
        {
          Assert(epetra.GCID(columns[k + 1]) == epetra.GCID(columns[k]) + 1,
                 ExcInternalError());
          const double inner = values[k], outer = values[k + 1];
          values[k]     = outer + inner;
          values[k + 1] = outer - inner;
          ++k;
        }
    // rows: A <- T^T A; both rows of a pair have the same columns
    for (const unsigned int p : pairs)
      for (int k = starts[p], l = starts[p + 1]; k < starts[p + 1]; ++k, ++l)
        {
          Assert(columns[k] == columns[l], ExcInternalError());
          const double inner = values[k], outer = values[l];
          values[k] = outer + inner;
          values[l] = outer - inner;
        }
  }


  void
  MultigridSolver::to_means_and_differences(LA::Vector &forces) const
  {
    double *f = forces.begin();
    for (const unsigned int p : pairs)
      {
        const double inner = f[p], outer = f[p + 1];
        f[p]     = outer + inner;
        f[p + 1] = outer - inner;
      }
  }


  void
  MultigridSolver::to_faces(LA::Vector &displacements) const
  {
    double *v = displacements.begin();
    for (const unsigned int p : pairs)
      {
        const double mean = v[p], difference = v[p + 1];
        v[p]     = mean - difference;
        v[p + 1] = mean + difference;
      }
  }


  LinearSolverResult
  MultigridSolver::factorize(const LA::SparseMatrix &A,
                             const bool /*symmetric*/)
  {
    TimerOutput::Scope scope(timer, "Linear solver: multigrid set-up");
    preconditioner.clear();
    if (matrix.n_nonzero_elements() != A.n_nonzero_elements())
      matrix.reinit(A);
    matrix.copy_from(A);
    transform_matrix();

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
        preconditioner.initialize(matrix, list);
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

    LA::Vector rhs(b);
    to_means_and_differences(rhs);
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
          .solve(matrix, x, rhs, preconditioner);
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
    to_faces(x);
    return result;
  }
} // namespace Biface
