// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/array_view.h>
#include <deal.II/base/mpi.h>
#include <deal.II/lac/solver_gmres.h>

#include <Epetra_CrsGraph.h>
#include <Epetra_CrsMatrix.h>
#include <Epetra_Import.h>
#include <Epetra_Vector.h>
#include <dmumps_c.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <string>
#include <type_traits>
#include <vector>

#include <biface/solver/linear/mumps_solver.h>
#include <biface/solver/linear/nested_dissection.h>

#include <smumps_c.h>

namespace Biface
{
  using namespace dealii;

  /** The factors of matrices with one sparsity pattern. */
  class MumpsSolver::Factors
  {
  public:
    explicit Factors(const Part part) : part(part)
    {}

    virtual ~Factors() = default;

    const Part part;

    virtual bool
    in_single_precision() const = 0;

    /** Whether they are for the sparsity pattern of a matrix. Must be called on
     * all ranks; likewise below. */
    virtual bool
    is_for(const LA::SparseMatrix &A, const Part part) const = 0;

    /** @return INFOG(1) of MUMPS, negative if it failed; likewise below. */
    virtual int
    analyze() = 0;

    virtual int
    factorize(const LA::SparseMatrix &A) = 0;

    /** @param x, b several solutions and right hand sides. */
    virtual int
    solve(const ArrayView<LA::Vector>       &x,
          const ArrayView<const LA::Vector> &b,
          const LinearSystem system = LinearSystem::original) = 0;

    int
    solve(LA::Vector        &x,
          const LA::Vector  &b,
          const LinearSystem system = LinearSystem::original)
    {
      return solve(
        ArrayView<LA::Vector>(x), ArrayView<const LA::Vector>(b), system);
    }

    /** After the analysis, the number of iterations of GMRES with factors as a
     * preconditioner that take less time than a factorization; zero if they
     * are too few to be of use. */
    virtual unsigned int
    max_gmres_iterations() const = 0;

    /** The number of negative pivots in the last factorization. */
    virtual unsigned int
    n_negative_pivots() const = 0;
  };


  namespace
  {
    /** MUMPS in one precision. */
    template <typename number>
    struct Mumps;

    template <>
    struct Mumps<float>
    {
      using Struct                = SMUMPS_STRUC_C;
      static constexpr auto &call = smumps_c;
    };

    template <>
    struct Mumps<double>
    {
      using Struct                = DMUMPS_STRUC_C;
      static constexpr auto &call = dmumps_c;
    };
  } // namespace


  namespace
  {
    /** The entries of a matrix on this rank, row by row; their columns are
     * numbers on this rank in ascending order. */
    struct LocalEntries
    {
      int    *row_starts, *columns;
      double *values;

      explicit LocalEntries(const Epetra_CrsMatrix &A)
      {
        const int error = A.ExtractCrsDataPointers(row_starts, columns, values);
        AssertThrow(error == 0,
                    TrilinosWrappers::SparseMatrix::ExcTrilinosError(error));
      }
    };
  } // namespace


  /** @tparam number the precision of the factors. */
  template <typename number>
  class MumpsSolver::FactorsIn : public Factors
  {
  public:
    FactorsIn(const MPI_Comm          communicator,
              const LA::SparseMatrix &A,
              const Part              part)
      : Factors(part)
      , graph(A.trilinos_matrix().Graph())
      , communicator(communicator)
      , is_root(Utilities::MPI::this_mpi_process(communicator) == 0)
    {
      mumps.comm_fortran = MPI_Comm_c2f(communicator);
      mumps.par          = 1;
      mumps.sym          = (part == Part::whole ? 0 : 2);
      call(initialize);

      // no output by MUMPS
      for (const int i : {1, 2, 3})
        icntl(i) = -1;
      icntl(4) = 0;
      icntl(8) = 0; // set_scales() is sufficient, and faster
      // A preconditioner need not be stable: a threshold of 0.01 for pivots
      // doubles the time where a wheel starts to roll.
      if (in_single_precision())
        cntl(1) = 1e-3;
      icntl(14) = 40; // per cent of workspace beyond the estimate
      icntl(18) = 3;  // each rank passes its own entries
      // ScaLAPACK is slower for the root front on few ranks
      if (Utilities::MPI::n_mpi_processes(communicator) <= 4)
        icntl(13) = 1;

      const bool only_counts =
        (part == Part::symmetric_part && !in_single_precision());
      icntl(31) = only_counts; // discard the factors

      // MUMPS would let METIS order unknowns: more fill-in, but in very thin
      // shells, which need double precision, a smaller error of the solution
      if (in_single_precision() || only_counts)
        order_by_nodes(A);

      if (part == Part::symmetric_part)
        find_transposed_entries(A);
      collect_pattern(A);
      mumps.n       = A.m();
      mumps.nnz_loc = rows.size();
      mumps.irn_loc = rows.data();
      mumps.jcn_loc = columns.data();
      mumps.lrhs    = A.m();
    }

    ~FactorsIn() override
    {
      // collective: not called if a single rank unwinds
      if (std::uncaught_exceptions() == 0)
        call(terminate);
    }

    bool
    in_single_precision() const override
    {
      return std::is_same_v<number, float>;
    }

    bool
    is_for(const LA::SparseMatrix &A, const Part part) const override
    {
      if (this->part != part)
        return false;
      return !Utilities::MPI::logical_or(!has_pattern_of(A), communicator);
    }

    int
    analyze() override
    {
      return call(analysis);
    }

    int
    factorize(const LA::SparseMatrix &A) override
    {
      set_scales(A);
      auto value = values.begin();
      for_each_entry(A, [&](const int row, const int column, const double a) {
        *value++ = a * row_scales[row] * column_scales[column];
      });
      mumps.a_loc = values.data();

      // more fill-in than estimated, due to pivoting: increase the workspace
      int status = call(factorization);
      while ((status == -8 || status == -9) && icntl(14) < 1000)
        {
          icntl(14) *= 2;
          status = call(factorization);
        }
      return status;
    }

    using Factors::solve;

    int
    solve(const ArrayView<LA::Vector>       &x,
          const ArrayView<const LA::Vector> &b,
          const LinearSystem                 system) override
    {
      const std::size_t   n = b.size();
      std::vector<double> scales(n);
      if (is_root)
        rhs.resize(n * mumps.n);
      for (std::size_t i = 0; i < n; ++i)
        {
          // within the range of single precision
          const double norm = b[i].linfty_norm();
          scales[i]         = (norm > 0 ? std::exp2(-std::ilogb(norm)) : 1);
          for (unsigned int r = 0; r < own_rows.size(); ++r)
            own_rows[r] = b[i].begin()[r] * row_scales[r] * scales[i];
          MPI_Gatherv(own_rows.data(),
                      own_rows.size(),
                      mpi_type,
                      rhs.data() + (is_root ? i * mumps.n : 0),
                      counts.data(),
                      starts.data(),
                      mpi_type,
                      0,
                      communicator);
        }
      mumps.nrhs       = n;
      mumps.rhs        = rhs.data();
      icntl(9)         = (system == LinearSystem::original ? 1 : 0);
      const int status = call(solution);
      for (std::size_t i = 0; i < n; ++i)
        {
          MPI_Scatterv(rhs.data() + (is_root ? i * mumps.n : 0),
                       counts.data(),
                       starts.data(),
                       mpi_type,
                       own_rows.data(),
                       own_rows.size(),
                       mpi_type,
                       0,
                       communicator);
          for (unsigned int r = 0; r < own_rows.size(); ++r)
            x[i].begin()[r] = own_rows[r] * (row_scales[r] / scales[i]);
        }
      return status;
    }

    unsigned int
    max_gmres_iterations() const override
    {
      // Operations of a factorization per entry of the factors that take the
      // time of an iteration, which is bound by memory, with a margin.
      constexpr double       operations = 32;
      constexpr unsigned int least = 6, most = 8;

      // MUMPS counts in millions if the number is large
      const double n_entries =
        (mumps.infog[19] < 0 ? -1e6 : 1) * mumps.infog[19];
      const double n = mumps.rinfog[0] / (operations * n_entries);
      return n < least ? 0 : std::min<double>(n, most);
    }

    unsigned int
    n_negative_pivots() const override
    {
      return mumps.infog[11];
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
      Mumps<number>::call(&mumps);
      return mumps.infog[0];
    }

    /** ICNTL with the numbering of the manual. */
    MUMPS_INT &
    icntl(const int i)
    {
      return mumps.icntl[i - 1];
    }

    /** Likewise CNTL. */
    number &
    cntl(const int i)
    {
      return mumps.cntl[i - 1];
    }

    /** Call @p action with local row, local column and value of each entry of
     * this rank that MUMPS needs, always in the same order. */
    template <typename Action>
    void
    for_each_entry(const LA::SparseMatrix &A, const Action &action) const
    {
      const Epetra_CrsMatrix &epetra = A.trilinos_matrix();
      const LocalEntries      local(epetra);

      const int *row_ids    = epetra.RowMap().MyGlobalElements();
      const int *column_ids = epetra.ColMap().MyGlobalElements();
      for (int row = 0; row < epetra.NumMyRows(); ++row)
        for (int k = local.row_starts[row]; k < local.row_starts[row + 1]; ++k)
          {
            const int below = row_ids[row] - column_ids[local.columns[k]];
            double    value = local.values[k];
            if (part == Part::symmetric_part && below != 0)
              {
                // MUMPS adds what other ranks pass above the diagonal
                if (const int other = transposed_entries[k]; other >= 0)
                  value += local.values[other];
                value /= 2;
              }
            if (below >= 0 || part == Part::whole ||
                (part == Part::symmetric_part && transposed_entries[k] < 0))
              action(row, local.columns[k], value);
          }
    }

    /** Find the transposed entry of each of this rank's, negative if there is
     * none here. */
    void
    find_transposed_entries(const LA::SparseMatrix &A)
    {
      const Epetra_CrsMatrix &epetra = A.trilinos_matrix();
      const LocalEntries      local(epetra);
      transposed_entries.assign(epetra.NumMyNonzeros(), -1);
      for (int row = 0; row < epetra.NumMyRows(); ++row)
        {
          const int own_column = epetra.LCID(epetra.GRID(row));
          for (int k = local.row_starts[row]; k < local.row_starts[row + 1];
               ++k)
            if (const int other = epetra.LRID(epetra.GCID(local.columns[k]));
                other >= 0)
              {
                const int *const begin =
                  local.columns + local.row_starts[other];
                const int *const end =
                  local.columns + local.row_starts[other + 1];
                const int *const it = std::lower_bound(begin, end, own_column);
                if (it != end && *it == own_column)
                  transposed_entries[k] = it - local.columns;
              }
        }
    }

    void
    order_by_nodes(const LA::SparseMatrix &A)
    {
      positions = nested_dissection(A);
      for (int &position : positions)
        ++position;
      mumps.perm_in = positions.data();
      if (!Utilities::MPI::broadcast(communicator, positions.empty()))
        icntl(7) = 1;
    }

    /** Whether the rows of this rank have entries in the same places. Another
     * pattern may have as many. */
    bool
    has_pattern_of(const LA::SparseMatrix &A) const
    {
      const Epetra_CrsMatrix &epetra = A.trilinos_matrix();
      if (epetra.Graph().DataPtr() == graph.DataPtr())
        return true;
      if (part == Part::symmetric_part &&
          transposed_entries.size() != std::size_t(epetra.NumMyNonzeros()))
        return false;
      std::size_t n    = 0;
      bool        same = true;
      for_each_entry(A, [&](const int row, const int column, const double) {
        same = same && n < rows.size() && rows[n] == epetra.GRID(row) + 1 &&
               columns[n] == epetra.GCID(column) + 1;
        ++n;
      });
      return same && n == rows.size();
    }

    void
    collect_pattern(const LA::SparseMatrix &A)
    {
      const Epetra_CrsMatrix &epetra = A.trilinos_matrix();
      for_each_entry(A, [&](const int row, const int column, const double) {
        rows.push_back(epetra.GRID(row) + 1);
        columns.push_back(epetra.GCID(column) + 1);
      });
      values.resize(rows.size());
      own_rows.resize(epetra.NumMyRows());

      // owned ranges are contiguous and in the order of the ranks
      counts = Utilities::MPI::all_gather(communicator, epetra.NumMyRows());
      starts.assign(counts.size(), 0);
      for (unsigned int r = 1; r < counts.size(); ++r)
        starts[r] = starts[r - 1] + counts[r - 1];
    }

    /** Powers of two, which do not round, by which rows and columns are
     * multiplied so that the diagonal is close to one. */
    void
    set_scales(const LA::SparseMatrix &A)
    {
      const Epetra_CrsMatrix &epetra = A.trilinos_matrix();
      Epetra_Vector           scales(epetra.DomainMap());
      epetra.ExtractDiagonalCopy(scales);
      for (int i = 0; i < scales.MyLength(); ++i)
        scales[i] =
          (scales[i] == 0 ? 1 : std::exp2(-std::ilogb(scales[i]) / 2));
      row_scales.assign(scales.Values(), scales.Values() + scales.MyLength());

      Epetra_Vector of_columns(epetra.ColMap());
      if (const Epetra_Import *const importer = epetra.Importer())
        of_columns.Import(scales, *importer, Insert);
      else
        of_columns = scales;
      column_scales.assign(of_columns.Values(),
                           of_columns.Values() + of_columns.MyLength());
    }

    const MPI_Datatype mpi_type = Utilities::MPI::mpi_type_id_for_type<number>;

    /** Shares its data with the matrix. */
    const Epetra_CrsGraph          graph;
    const MPI_Comm                 communicator;
    const bool                     is_root;
    typename Mumps<number>::Struct mumps{};

    /** The positions of the unknowns in the order of elimination, from 1, on
     * the first rank. */
    std::vector<MUMPS_INT> positions;
    std::vector<MUMPS_INT> rows;
    std::vector<MUMPS_INT> columns;
    /** See find_transposed_entries(); empty if it does not matter. */
    std::vector<int>    transposed_entries;
    std::vector<number> values;
    std::vector<double> row_scales;
    std::vector<double> column_scales;
    /** The part of a right hand side or solution on this rank. */
    std::vector<number> own_rows;
    /** The right hand sides, then the solutions, on the first rank. */
    std::vector<number> rhs;
    std::vector<int>    counts;
    std::vector<int>    starts;
  };


  MumpsSolver::MumpsSolver(const MPI_Comm communicator,
                           TimerOutput   &timer,
                           const bool     single_precision)
    : communicator(communicator)
    , timer(timer)
    , single_precision(single_precision)
  {}


  MumpsSolver::~MumpsSolver() = default;


  namespace
  {
    // a value of INFOG(1)
    constexpr int singular = -10;


    LinearSolverResult
    mumps_failure(const std::string &phase, const int status)
    {
      LinearSolverResult result;
      result.message = "MUMPS failed in the " + phase +
                       " with INFOG(1) = " + std::to_string(status);
      if (status == singular)
        result.message += ": the tangent is singular";
      else if (status == -9 || status == -13)
        {
          result.message += ": out of memory";
          result.cause = FailureCause::out_of_memory;
        }
      else
        result.cause = FailureCause::linear_solver;
      return result;
    }


    /** @param status of the phase of solution. */
    LinearSolverResult
    solved(const int status)
    {
      if (status < 0)
        return mumps_failure("solution", status);
      LinearSolverResult result;
      result.success = true;
      return result;
    }
  } // namespace


  LinearSolverResult
  MumpsSolver::factorize(const LA::SparseMatrix &A, const Symmetry symmetry)
  {
    matrix         = &A;
    this->symmetry = symmetry;
    return factorize_anew();
  }


  bool
  MumpsSolver::can_keep_factors() const
  {
    return factors && factors->max_gmres_iterations() > 0;
  }


  LinearSolverResult
  MumpsSolver::keep_factors(const LA::SparseMatrix &A,
                            const Symmetry          symmetry,
                            const Correction       &correction)
  {
    matrix         = &A;
    this->symmetry = symmetry;
    if (factors_of == FactorsOf::nothing || !can_keep_factors() ||
        !factors->is_for(A, wanted_part()))
      return factorize_anew();
    this->correction = correction;
    factors_of       = FactorsOf::similar_matrix;
    return factorized();
  }


  bool
  MumpsSolver::solve_by_factors(std::vector<LA::Vector>       &x,
                                const std::vector<LA::Vector> &b)
  {
    if (factors_of == FactorsOf::nothing || !can_keep_factors())
      return false;
    TimerOutput::Scope scope(timer, "Linear solver: solution");
    return b.empty() ||
           factors->solve(make_array_view(x), make_array_view(b)) >= 0;
  }


  LinearSolverResult
  MumpsSolver::factorize_for_many(const LA::SparseMatrix &A,
                                  const bool              symmetric)
  {
    const bool wanted = single_precision;
    single_precision  = false;
    const LinearSolverResult result =
      factorize(A, symmetric ? Symmetry::full : Symmetry::none);
    single_precision = wanted;
    return result;
  }


  std::optional<unsigned int>
  MumpsSolver::count_negative_pivots(const LA::SparseMatrix &A,
                                     const bool              often)
  {
    const bool release = !often && can_keep_factors();
    if (release)
      {
        factors_of = FactorsOf::nothing;
        correction = {};
        factors.reset();
      }
    if (!counting_factors || !counting_factors->is_for(A, Part::symmetric_part))
      {
        TimerOutput::Scope scope(timer, "Linear solver: analysis");
        counting_factors = std::make_unique<FactorsIn<double>>(
          communicator, A, Part::symmetric_part);
        if (counting_factors->analyze() < 0)
          {
            counting_factors.reset();
            return {};
          }
      }
    std::optional<unsigned int> n;
    {
      TimerOutput::Scope scope(timer, "Linear solver: factorization");
      if (counting_factors->factorize(A) >= 0)
        n = counting_factors->n_negative_pivots();
    }
    if (release)
      counting_factors.reset();
    return n;
  }


  MumpsSolver::Part
  MumpsSolver::wanted_part() const
  {
    // in small problems there is no GMRES
    const bool has_gmres =
      single_precision &&
      (!factors || factors->in_single_precision() || can_keep_factors());
    if (symmetry == Symmetry::nearly && symmetric_part_suffices && has_gmres)
      return Part::symmetric_part;
    return symmetry == Symmetry::full ? Part::half : Part::whole;
  }


  bool
  MumpsSolver::factors_fit() const
  {
    if (!factors || !factors->is_for(*matrix, wanted_part()))
      return false;
    // in small problems single precision saves no time
    return factors->in_single_precision() == single_precision ||
           (single_precision && factors->max_gmres_iterations() == 0);
  }


  LinearSolverResult
  MumpsSolver::factorize_anew()
  {
    factors_of = FactorsOf::nothing;
    correction = {};
    if (!factors_fit())
      if (const int status = analyze(); status < 0)
        {
          factors.reset();
          return mumps_failure("analysis", status);
        }

    {
      TimerOutput::Scope scope(timer, "Linear solver: factorization");
      if (const int status = factors->factorize(*matrix); status < 0)
        {
          // its round-off makes small pivots vanish
          if (status == singular && factors->in_single_precision())
            return factorize_in_double_precision();
          return mumps_failure("factorization", status);
        }
    }
    factors_of = FactorsOf::matrix;
    return factorized();
  }


  int
  MumpsSolver::analyze()
  {
    TimerOutput::Scope scope(timer, "Linear solver: analysis");
    if (single_precision)
      {
        factors = std::make_unique<FactorsIn<float>>(
          communicator, *matrix, wanted_part());
        const int status = factors->analyze();
        if (status < 0 || factors->max_gmres_iterations() > 0)
          return status;
      }
    factors = std::make_unique<FactorsIn<double>>(
      communicator,
      *matrix,
      symmetry == Symmetry::full ? Part::half : Part::whole);
    return factors->analyze();
  }


  LinearSolverResult
  MumpsSolver::factorize_in_double_precision()
  {
    single_precision = false;
    return factorize_anew();
  }


  LinearSolverResult
  MumpsSolver::factorized() const
  {
    LinearSolverResult result;
    result.success = true;
    if (factors->part != Part::whole)
      result.n_negative_pivots = factors->n_negative_pivots();
    result.pivots_are_exact =
      (symmetry == Symmetry::full && factors_of == FactorsOf::matrix &&
       !factors->in_single_precision());
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
  MumpsSolver::solve_with_gmres(LA::Vector       &x,
                                const LA::Vector &b,
                                const double      tolerance)
  {
    // solve_with_refinement() has no doubt here, either
    constexpr double minimum = 1e-10;

    struct Preconditioner
    {
      Factors          &factors;
      const Correction &correction;
      bool             &failed;

      void
      vmult(LA::Vector &x, const LA::Vector &b) const
      {
        if (factors.solve(x, b) < 0)
          {
            failed = true;
            x      = b;
          }
        else if (correction)
          correction(x);
      }
    };

    TimerOutput::Scope scope(timer, "Linear solver: solution");
    const unsigned int max_iterations = factors->max_gmres_iterations();
    bool               failed         = false;
    BoundedEffort      control(max_iterations, std::max(tolerance, minimum));
    // flexible GMRES: corrections and single precision make the preconditioner
    // not quite linear
    x = 0;
    try
      {
        SolverFGMRES<LA::Vector>(
          control, SolverFGMRES<LA::Vector>::AdditionalData(max_iterations + 1))
          .solve(*matrix, x, b, Preconditioner{*factors, correction, failed});
      }
    catch (const SolverControl::NoConvergence &)
      {
        failed = true;
      }
    return !failed;
  }


  LinearSolverResult
  MumpsSolver::solve(LA::Vector &x, const LA::Vector &b, const double tolerance)
  {
    Assert(matrix != nullptr, ExcNotInitialized());
    LinearSolverResult result;
    result.success = true;
    // from the cheapest factors to the most exact ones: each kind that fails is
    // replaced by the next
    if (factors_of != FactorsOf::matrix)
      {
        if (factors_of != FactorsOf::nothing &&
            solve_with_gmres(x, b, tolerance))
          return result;
        result = factorize_anew();
      }
    if (result.success && factors->part == Part::symmetric_part)
      {
        if (solve_with_gmres(x, b, tolerance))
          return result;
        symmetric_part_suffices = false;
        result                  = factorize_anew();
      }
    if (result.success && factors->in_single_precision())
      {
        if (solve_with_gmres(x, b, tolerance))
          return result;
        result = factorize_in_double_precision();
      }
    if (!result.success)
      return result;

    const LinearSolverResult factorization = result;
    TimerOutput::Scope       scope(timer, "Linear solver: solution");
    result = solve_with_refinement({*matrix, LinearSystem::original},
                                   x,
                                   b,
                                   [&](LA::Vector &x, const LA::Vector &b) {
                                     return solved(factors->solve(x, b));
                                   });
    result.n_negative_pivots = factorization.n_negative_pivots;
    result.pivots_are_exact  = factorization.pivots_are_exact;
    return result;
  }


  LinearSolverResult
  MumpsSolver::solve_transposed(LA::Vector       &x,
                                const LA::Vector &b,
                                const double /*tolerance*/)
  {
    Assert(matrix != nullptr, ExcNotInitialized());
    if (factors_of != FactorsOf::matrix || factors->in_single_precision())
      if (const auto result =
            factorize_for_many(*matrix, symmetry == Symmetry::full);
          !result.success)
        return result;

    TimerOutput::Scope scope(timer, "Linear solver: solution");
    return solve_with_refinement(
      {*matrix, LinearSystem::transposed},
      x,
      b,
      [&](LA::Vector &x, const LA::Vector &b) {
        return solved(factors->solve(x, b, LinearSystem::transposed));
      });
  }


  LinearSolverResult
  MumpsSolver::solve_all(std::vector<LA::Vector>       &x,
                         const std::vector<LA::Vector> &b,
                         const double                   tolerance)
  {
    if (b.empty() || factors_of != FactorsOf::matrix ||
        factors->in_single_precision())
      return LinearSolver::solve_all(x, b, tolerance);

    TimerOutput::Scope scope(timer, "Linear solver: solution");
    LinearSolverResult result =
      solved(factors->solve(make_array_view(x), make_array_view(b)));
    for (unsigned int i = 0; i < b.size() && result.success; ++i)
      {
        // the first solution is there already; refinement needs further ones
        bool known = true;
        result     = solve_with_refinement({*matrix, LinearSystem::original},
                                       x[i],
                                       b[i],
                                       [&](LA::Vector &x, const LA::Vector &b) {
                                         const int status =
                                           (known ? 0 : factors->solve(x, b));
                                         known = false;
                                         return solved(status);
                                       });
      }
    return result;
  }
} // namespace Biface
