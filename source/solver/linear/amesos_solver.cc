// SPDX-License-Identifier: LGPL-2.1-or-later

#include <Epetra_CrsMatrix.h>
#include <Epetra_LinearProblem.h>

#include <biface/solver/linear/amesos_solver.h>

#include <Amesos.h>

namespace Biface
{
  using namespace dealii;

  AmesosSolver::AmesosSolver(TimerOutput &timer) : timer(timer)
  {}


  AmesosSolver::~AmesosSolver() = default;


  namespace
  {
    LinearSolverResult
    failure(const std::string &phase, const int status)
    {
      LinearSolverResult result;
      result.message = "Amesos failed in the " + phase + " with the code " +
                       std::to_string(status) +
                       ": the tangent may be singular, or memory insufficient";
      return result;
    }
  } // namespace


  LinearSolverResult
  AmesosSolver::factorize(const LA::SparseMatrix &A,
                          const bool /*symmetric*/,
                          const bool /*similar*/)
  {
    // Amesos reads the matrix in each factorization, but needs the object in
    // advance; it does not change it
    if (!solver || matrix != &A)
      {
        TimerOutput::Scope scope(timer, "Linear solver: analysis");
        matrix  = &A;
        problem = std::make_unique<Epetra_LinearProblem>();
        problem->SetOperator(
          const_cast<Epetra_CrsMatrix *>(&A.trilinos_matrix()));

        Amesos factory;
        for (const char *package : {"Amesos_Umfpack", "Amesos_Klu"})
          if (factory.Query(package))
            {
              solver.reset(factory.Create(package, *problem));
              break;
            }
        AssertThrow(solver, ExcInternalError());
        if (const int status = solver->SymbolicFactorization(); status != 0)
          {
            solver.reset();
            return failure("analysis", status);
          }
      }

    TimerOutput::Scope scope(timer, "Linear solver: factorization");
    if (const int status = solver->NumericFactorization(); status != 0)
      return failure("factorization", status);
    LinearSolverResult result;
    result.success = true;
    return result;
  }


  LinearSolverResult
  AmesosSolver::solve(LA::Vector       &x,
                      const LA::Vector &b,
                      const double /*tolerance*/)
  {
    return solve(System::original, x, b);
  }


  LinearSolverResult
  AmesosSolver::solve_transposed(LA::Vector       &x,
                                 const LA::Vector &b,
                                 const double /*tolerance*/)
  {
    return solve(System::transposed, x, b);
  }


  LinearSolverResult
  AmesosSolver::solve(const System system, LA::Vector &x, const LA::Vector &b)
  {
    Assert(solver, ExcNotInitialized());
    TimerOutput::Scope scope(timer, "Linear solver: solution");
    return solve_with_refinement(
      {*matrix, system}, x, b, [&](LA::Vector &x, const LA::Vector &b) {
        x = 0;
        problem->SetLHS(&x.trilinos_vector());
        problem->SetRHS(const_cast<Epetra_MultiVector *>(
          static_cast<const Epetra_MultiVector *>(&b.trilinos_vector())));
        int status = solver->SetUseTranspose(system == System::transposed);
        if (status == 0)
          status = solver->Solve();
        if (status != 0)
          return failure("solution", status);
        LinearSolverResult result;
        result.success = true;
        return result;
      });
  }
} // namespace Biface
