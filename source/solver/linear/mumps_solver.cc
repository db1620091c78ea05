// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/mpi.h>
#include <deal.II/lac/solver_gmres.h>

#include <Epetra_CrsMatrix.h>
#include <dmumps_c.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <limits>
#include <string>
#include <vector>

#include <biface/solver/linear/mumps_solver.h>

namespace Biface
{
  using namespace dealii;

  /** A MUMPS object for one sparsity pattern. */
  class MumpsSolver::Instance
  {
  public:
    Instance(const MPI_Comm          communicator,
             const LA::SparseMatrix &A,
             const bool              symmetric)
      : symmetric(symmetric)
      , pattern_size(A.n_nonzero_elements())
      , communicator(communicator)
      , is_root(Utilities::MPI::this_mpi_process(communicator) == 0)
    {
      mumps.comm_fortran = MPI_Comm_c2f(communicator);
      mumps.par          = 1;
      mumps.sym          = (symmetric ? 2 : 0);
      call(initialize);

      // no output by MUMPS
      for (const int i : {1, 2, 3})
        icntl(i) = -1;
      icntl(4)  = 0;
      icntl(14) = 40; // per cent of workspace beyond the estimate
      icntl(18) = 3;  // each rank passes its own entries
      // ScaLAPACK is slower for the root front on few ranks
      if (Utilities::MPI::n_mpi_processes(communicator) <= 4)
        icntl(13) = 1;

      collect_pattern(A);
      mumps.n       = A.m();
      mumps.nnz_loc = rows.size();
      mumps.irn_loc = rows.data();
      mumps.jcn_loc = columns.data();
      if (is_root)
        rhs.resize(A.m());
      mumps.nrhs = 1;
      mumps.lrhs = A.m();
    }

    ~Instance()
    {
      // collective: not called if a single rank unwinds
      if (std::uncaught_exceptions() == 0)
        call(terminate);
    }

    bool
    is_for(const LA::SparseMatrix &A, const bool symmetric) const
    {
      return this->symmetric == symmetric &&
             pattern_size == A.n_nonzero_elements();
    }

    int
    analyze()
    {
      return call(analysis);
    }

    int
    factorize(const LA::SparseMatrix &A)
    {
      const double *matrix_values = get_storage(A).values;
      for (unsigned int k = 0; k < values.size(); ++k)
        values[k] = matrix_values[places[k]];
      mumps.a_loc = values.data();

      // more fill-in than estimated, due to pivoting: increase the workspace
      int status = call(factorization);
      while ((status == -8 || status == -9) && icntl(14) < 1000)
        {
          icntl(14) *= 2;
          status = call(factorization);
        }
      factorized = (status >= 0);
      return status;
    }

    /** The number of iterations of GMRES with the factors as a preconditioner
     * that take less time than a factorization; zero if they are too few to be
     * of use, or without factors. */
    unsigned int
    max_refinements() const
    {
      // Operations of a factorization per entry of the factors that take the
      // time of an iteration, which is bound by memory, with a margin.
      constexpr double       operations = 32;
      constexpr unsigned int least = 6, most = 8;

      if (!factorized)
        return 0;
      // MUMPS counts in millions if the number is large
      const double n_entries =
        (mumps.infog[28] < 0 ? -1e6 : 1) * mumps.infog[28];
      const double n = mumps.rinfog[2] / (operations * n_entries);
      return n < least ? 0 : std::min<double>(n, most);
    }

    /** Of the last factorization. */
    unsigned int
    n_negative_pivots() const
    {
      return mumps.infog[11];
    }

    int
    solve(LA::Vector &x, const LA::Vector &b)
    {
      gather(b);
      mumps.rhs        = rhs.data();
      const int status = call(solution);
      scatter(x);
      return status;
    }

  private:
    enum Job
    {
      initialize    = -1,
      terminate     = -2,
      analysis      = 1,
      factorization = 2,
      solution      = 3
    };

    int
    call(const Job job)
    {
      mumps.job = job;
      dmumps_c(&mumps);
      return mumps.infog[0];
    }

    /** ICNTL with the numbering of the manual. */
    MUMPS_INT &
    icntl(const int i)
    {
      return mumps.icntl[i - 1];
    }

    /** The arrays in which Epetra stores the rows of this rank. */
    struct Storage
    {
      int    *row_starts;
      int    *columns;
      double *values;
    };

    static Storage
    get_storage(const LA::SparseMatrix &A)
    {
      Storage   storage;
      const int error = A.trilinos_matrix().ExtractCrsDataPointers(
        storage.row_starts, storage.columns, storage.values);
      AssertThrow(error == 0, ExcTrilinosError(error));
      return storage;
    }

    void
    collect_pattern(const LA::SparseMatrix &A)
    {
      const Epetra_CrsMatrix &epetra  = A.trilinos_matrix();
      const Storage           storage = get_storage(A);

      for (int row = 0; row < epetra.NumMyRows(); ++row)
        for (int k = storage.row_starts[row]; k < storage.row_starts[row + 1];
             ++k)
          {
            const int i = epetra.GRID(row);
            const int j = epetra.GCID(storage.columns[k]);
            if (symmetric && j > i)
              continue;
            rows.push_back(i + 1);
            columns.push_back(j + 1);
            places.push_back(k);
          }
      values.resize(places.size());

      // owned ranges are contiguous and in the order of the ranks
      counts = Utilities::MPI::all_gather(communicator, epetra.NumMyRows());
      starts.assign(counts.size(), 0);
      for (unsigned int r = 1; r < counts.size(); ++r)
        starts[r] = starts[r - 1] + counts[r - 1];
    }

    void
    gather(const LA::Vector &b)
    {
      MPI_Gatherv(b.begin(),
                  b.locally_owned_size(),
                  MPI_DOUBLE,
                  rhs.data(),
                  counts.data(),
                  starts.data(),
                  MPI_DOUBLE,
                  0,
                  communicator);
    }

    void
    scatter(LA::Vector &x) const
    {
      MPI_Scatterv(rhs.data(),
                   counts.data(),
                   starts.data(),
                   MPI_DOUBLE,
                   x.begin(),
                   x.locally_owned_size(),
                   MPI_DOUBLE,
                   0,
                   communicator);
    }

    const bool                    symmetric;
    const types::global_dof_index pattern_size;
    const MPI_Comm                communicator;
    const bool                    is_root;
    DMUMPS_STRUC_C                mumps{};
    bool                          factorized = false;

    std::vector<MUMPS_INT> rows;
    std::vector<MUMPS_INT> columns;
    /** Positions of the entries among the values of the Epetra matrix. */
    std::vector<int>    places;
    std::vector<double> values;
    /** The right hand side, then the solution, on the first rank. */
    std::vector<double> rhs;
    std::vector<int>    counts;
    std::vector<int>    starts;
  };


  MumpsSolver::MumpsSolver(const MPI_Comm communicator, TimerOutput &timer)
    : communicator(communicator), timer(timer)
  {}


  MumpsSolver::~MumpsSolver() = default;


  namespace
  {
    LinearSolverResult
    mumps_failure(const std::string &phase, const int status)
    {
      LinearSolverResult result;
      result.message = "MUMPS failed in the " + phase +
                       " with INFOG(1) = " + std::to_string(status);
      if (status == -10)
        result.message += ": the tangent is singular";
      else if (status == -9 || status == -13)
        {
          result.message += ": out of memory";
          result.cause = FailureCause::out_of_memory;
        }
      return result;
    }
  } // namespace


  LinearSolverResult
  MumpsSolver::factorize(const LA::SparseMatrix &A,
                         const bool              symmetric,
                         const bool              similar)
  {
    const bool keep_factors = similar && instance &&
                              instance->is_for(A, symmetric) &&
                              instance->max_refinements() > 0;
    matrix              = &A;
    matrix_is_symmetric = symmetric;
    factors_are_current = false;
    return keep_factors ? factorized() : factorize_anew();
  }


  LinearSolverResult
  MumpsSolver::factorize_anew()
  {
    if (!instance || !instance->is_for(*matrix, matrix_is_symmetric))
      {
        TimerOutput::Scope scope(timer, "Linear solver: analysis");
        instance = std::make_unique<Instance>(
          communicator, *matrix, matrix_is_symmetric);
        if (const int status = instance->analyze(); status < 0)
          {
            instance.reset();
            return mumps_failure("analysis", status);
          }
      }

    TimerOutput::Scope scope(timer, "Linear solver: factorization");
    if (const int status = instance->factorize(*matrix); status < 0)
      return mumps_failure("factorization", status);
    factors_are_current = true;
    return factorized();
  }


  LinearSolverResult
  MumpsSolver::factorized() const
  {
    LinearSolverResult result;
    result.success = true;
    if (matrix_is_symmetric)
      result.n_negative_pivots = instance->n_negative_pivots();
    return result;
  }


  namespace
  {
    /** Stops GMRES as soon as its last iteration is unlikely to reach the
     * tolerance. */
    class BoundedEffort : public ReductionControl
    {
    public:
      BoundedEffort(const unsigned int max_iterations, const double tolerance)
        : ReductionControl(max_iterations, 0, tolerance)
      {}

      State
      check(const unsigned int step, const double value) override
      {
        // the convergence gets faster with each iteration
        constexpr unsigned int earliest = 3;
        constexpr double       hope     = 1e5;

        const State state = ReductionControl::check(step, value);
        if (state != iterate || step < earliest)
          return state;
        const double at_the_end =
          std::pow(value / initial_value(), double(max_steps()) / step);
        return at_the_end > hope * reduction() ? failure : iterate;
      }
    };
  } // namespace


  bool
  MumpsSolver::solve_with_old_factors(LA::Vector &x, const LA::Vector &b)
  {
    // the residual at which solve_with_refinement() has no doubt
    constexpr double tolerance = 1e-10;

    struct OldFactors
    {
      Instance &instance;
      bool     &failed;

      void
      vmult(LA::Vector &x, const LA::Vector &b) const
      {
        if (instance.solve(x, b) < 0)
          {
            failed = true;
            x      = b;
          }
      }
    };

    const unsigned int max_iterations = instance->max_refinements();
    bool               failed         = false;
    BoundedEffort      control(max_iterations, tolerance);
    x = 0;
    try
      {
        SolverFGMRES<LA::Vector>(
          control, SolverFGMRES<LA::Vector>::AdditionalData(max_iterations + 1))
          .solve(*matrix, x, b, OldFactors{*instance, failed});
      }
    catch (const SolverControl::NoConvergence &)
      {
        failed = true;
      }
    return !failed;
  }


  LinearSolverResult
  MumpsSolver::solve(LA::Vector       &x,
                     const LA::Vector &b,
                     const double /*tolerance*/)
  {
    Assert(matrix != nullptr, ExcNotInitialized());
    LinearSolverResult result;
    if (!factors_are_current)
      {
        {
          TimerOutput::Scope scope(timer, "Linear solver: solution");
          if (solve_with_old_factors(x, b))
            {
              result.success = true;
              return result;
            }
        }
        result = factorize_anew();
        if (!result.success)
          return result;
      }

    const auto         n_negative_pivots = result.n_negative_pivots;
    TimerOutput::Scope scope(timer, "Linear solver: solution");
    result = solve_with_refinement(
      *matrix, x, b, [&](LA::Vector &x, const LA::Vector &b) {
        if (const int status = instance->solve(x, b); status < 0)
          return mumps_failure("solution", status);
        LinearSolverResult result;
        result.success = true;
        return result;
      });
    result.n_negative_pivots = n_negative_pivots;
    return result;
  }
} // namespace Biface
