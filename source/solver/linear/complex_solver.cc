// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <exception>
#include <numeric>

#include <biface/solver/linear/complex_solver.h>

#include <zmumps_c.h>

namespace Biface
{
  using namespace dealii;

  static_assert(sizeof(ZMUMPS_COMPLEX) == sizeof(ComplexSolver::Number));

  namespace
  {
    enum Job
    {
      initialize    = -1,
      terminate     = -2,
      analysis      = 1,
      factorization = 2,
      solution      = 3
    };


    ZMUMPS_COMPLEX *
    raw(std::vector<ComplexSolver::Number> &numbers)
    {
      return reinterpret_cast<ZMUMPS_COMPLEX *>(numbers.data());
    }
  } // namespace


  struct ComplexSolver::Mumps
  {
    ZMUMPS_STRUC_C         data{};
    std::vector<MUMPS_INT> rows, columns;
    /** The numbers of rows of all ranks, and of those before. */
    std::vector<int> counts, starts;
    /** The right-hand sides, then the solutions, on the first rank. */
    std::vector<Number> rhs;

    /** @return INFOG(1), negative if it failed. */
    int
    call(const Job job)
    {
      data.job = job;
      zmumps_c(&data);
      return data.infog[0];
    }

    /** ICNTL with the numbering of the manual. */
    MUMPS_INT &
    icntl(const int i)
    {
      return data.icntl[i - 1];
    }
  };


  ComplexSolver::ComplexSolver(const MPI_Comm            communicator,
                               const unsigned int        n_rows,
                               const std::vector<Place> &places,
                               const bool                symmetric)
    : communicator(communicator), mumps(std::make_unique<Mumps>())
  {
    mumps->counts = Utilities::MPI::all_gather(communicator, int(n_rows));
    mumps->starts.resize(mumps->counts.size());
    std::exclusive_scan(
      mumps->counts.begin(), mumps->counts.end(), mumps->starts.begin(), 0);
    for (const Place &place : places)
      {
        mumps->rows.push_back(place.row + 1);
        mumps->columns.push_back(place.column + 1);
      }

    mumps->data.comm_fortran = MPI_Comm_c2f(communicator);
    mumps->data.par          = 1;
    mumps->data.sym          = (symmetric ? 2 : 0);
    mumps->call(initialize);
    // no output by MUMPS
    for (const int i : {1, 2, 3})
      mumps->icntl(i) = -1;
    mumps->icntl(4)     = 0;
    mumps->icntl(14)    = 40; // per cent of workspace beyond the estimate
    mumps->icntl(18)    = 3;  // each rank passes its own entries
    mumps->data.n       = mumps->starts.back() + mumps->counts.back();
    mumps->data.nnz_loc = places.size();
    mumps->data.irn_loc = mumps->rows.data();
    mumps->data.jcn_loc = mumps->columns.data();
    mumps->data.lrhs    = mumps->data.n;
  }


  ComplexSolver::~ComplexSolver()
  {
    // collective: not called if a single rank unwinds
    if (std::uncaught_exceptions() == 0)
      mumps->call(terminate);
  }


  std::string
  ComplexSolver::factorize(std::vector<Number> &entries)
  {
    AssertDimension(entries.size(), mumps->rows.size());
    mumps->data.a_loc = raw(entries);
    int status        = 0;
    if (!is_analyzed)
      status = mumps->call(analysis);
    is_analyzed = (status >= 0);
    if (status >= 0)
      status = mumps->call(factorization);
    // more fill-in than estimated, due to pivoting: increase the workspace
    while ((status == -8 || status == -9) && mumps->icntl(14) < 1000)
      {
        mumps->icntl(14) *= 2;
        status = mumps->call(factorization);
      }
    if (status >= 0)
      return {};
    return status == -10 ? "the matrix is singular"
           : status == -13
             ? "there is not enough memory"
             : "MUMPS failed (INFOG(1) = " + std::to_string(status) + ")";
  }


  bool
  ComplexSolver::solve(std::vector<Vector> &x)
  {
    const bool is_root = Utilities::MPI::this_mpi_process(communicator) == 0;
    const int  n       = mumps->data.n;
    if (is_root)
      mumps->rhs.resize(x.size() * n);
    // MUMPS expects right-hand sides, and leaves solutions, on the root alone
    const auto on_root = [&](const unsigned int i) {
      return is_root ? mumps->rhs.data() + i * n : nullptr;
    };
    for (unsigned int i = 0; i < x.size(); ++i)
      MPI_Gatherv(x[i].data(),
                  x[i].size(),
                  MPI_C_DOUBLE_COMPLEX,
                  on_root(i),
                  mumps->counts.data(),
                  mumps->starts.data(),
                  MPI_C_DOUBLE_COMPLEX,
                  0,
                  communicator);
    mumps->data.nrhs = x.size();
    mumps->data.rhs  = raw(mumps->rhs);
    const int status = mumps->call(solution);
    for (unsigned int i = 0; i < x.size(); ++i)
      MPI_Scatterv(on_root(i),
                   mumps->counts.data(),
                   mumps->starts.data(),
                   MPI_C_DOUBLE_COMPLEX,
                   x[i].data(),
                   x[i].size(),
                   MPI_C_DOUBLE_COMPLEX,
                   0,
                   communicator);
    return status >= 0;
  }
} // namespace Biface
