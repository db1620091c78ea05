// SPDX-License-Identifier: LGPL-2.1-or-later

// The direct solver solves a system whose matrix is similar to the last one
// without a factorization, and factorizes a matrix that only claims to be.

#include <deal.II/base/index_set.h>
#include <deal.II/base/timer.h>
#include <deal.II/lac/dynamic_sparsity_pattern.h>

#include <iostream>

#include <biface/solver/linear/mumps_solver.h>

#include <tests.h>

using namespace dealii;
using namespace Biface;

namespace
{
  constexpr unsigned int side = 18;


  /** The seven-point Laplacian on a cube, whose factors are full enough for
   * their use to pay. */
  class Laplacian
  {
  public:
    LA::SparseMatrix matrix;
    LA::Vector       rhs, solution;

    Laplacian()
    {
      const unsigned int n    = side * side * side;
      const unsigned int rank = Utilities::MPI::this_mpi_process(comm);
      const unsigned int size = Utilities::MPI::n_mpi_processes(comm);
      IndexSet           owned(n);
      owned.add_range(n * rank / size, n * (rank + 1) / size);

      DynamicSparsityPattern pattern(n, n, owned);
      for (const auto i : owned)
        for (const auto j : neighbors(i))
          pattern.add(i, j);
      matrix.reinit(owned, pattern, comm);
      rhs.reinit(owned, comm);
      solution.reinit(owned, comm);
      for (const auto i : owned)
        rhs[i] = 1. + i % 5;
      rhs.compress(VectorOperation::insert);
    }

    /** Add the identity times a factor that depends on the place. */
    void
    set(const double shift)
    {
      for (const auto i : rhs.locally_owned_elements())
        for (const auto j : neighbors(i))
          matrix.set(i, j, i == j ? 6 + shift * (1 + i % 7) : -1);
      matrix.compress(VectorOperation::insert);
    }

    double
    relative_residual() const
    {
      LA::Vector residual(rhs);
      return matrix.residual(residual, solution, rhs) / rhs.l2_norm();
    }

  private:
    static std::vector<types::global_dof_index>
    neighbors(const types::global_dof_index i)
    {
      std::vector<types::global_dof_index> found  = {i};
      unsigned int                         stride = 1;
      for (unsigned int d = 0; d < 3; ++d, stride *= side)
        {
          const unsigned int place = i / stride % side;
          if (place > 0)
            found.push_back(i - stride);
          if (place + 1 < side)
            found.push_back(i + stride);
        }
      return found;
    }

    const MPI_Comm comm = MPI_COMM_WORLD;
  };
} // namespace


int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  const bool root = Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0;
  ConditionalOStream no_output(std::cout, false);
  ConditionalOStream out(std::cout, root);
  TimerOutput timer(no_output, TimerOutput::never, TimerOutput::wall_times);

  Laplacian   system;
  MumpsSolver solver(MPI_COMM_WORLD, timer);

  const auto solve =
    [&](const std::string &name, const double shift, const bool similar) {
      system.set(shift);
      const bool success =
        solver.factorize(system.matrix, true, similar).success &&
        solver.solve(system.solution, system.rhs, 0).success;
      out << name << ": " << (success ? "solved" : "failed") << ", residual "
          << (system.relative_residual() < 1e-8 ? "below" : "above")
          << " 1e-8, factorizations so far "
          << timer.get_summary_data(
               TimerOutput::n_calls)["Linear solver: factorization"]
          << std::endl;
    };

  solve("first", 0.1, false);
  solve("similar", 0.101, true);
  solve("similar", 0.102, true);
  solve("only claims to be similar", -3, true);
  solve("similar to that", -3.001, true);
  solve("not similar", -3.001, false);
}
