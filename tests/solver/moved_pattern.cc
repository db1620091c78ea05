// SPDX-License-Identifier: LGPL-2.1-or-later

// The direct solver solves systems one after the other whose matrices have as
// many entries, but in other places.

#include <deal.II/base/index_set.h>
#include <deal.II/base/mpi.h>
#include <deal.II/base/timer.h>
#include <deal.II/lac/trilinos_sparsity_pattern.h>

#include <iostream>

#include <biface/solver/linear/mumps_solver.h>

#include <tests.h>

using namespace dealii;
using namespace Biface;

int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  const unsigned int rank = Utilities::MPI::this_mpi_process(MPI_COMM_WORLD);
  const unsigned int size = Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD);
  ConditionalOStream no_output(std::cout, false);
  ConditionalOStream out(std::cout, rank == 0);
  TimerOutput timer(no_output, TimerOutput::never, TimerOutput::wall_times);

  constexpr unsigned int n = 2000;
  IndexSet               owned(n);
  owned.add_range(n * rank / size, n * (rank + 1) / size);

  MumpsSolver solver(MPI_COMM_WORLD, timer);
  for (const unsigned int distance : {7, 40, 41, 600})
    {
      const auto other = [&](const unsigned int i) {
        return (i + distance) % n;
      };
      TrilinosWrappers::SparsityPattern pattern(owned, MPI_COMM_WORLD, 2);
      for (const auto i : owned)
        {
          pattern.add(i, i);
          pattern.add(i, other(i));
        }
      pattern.compress();
      LA::SparseMatrix matrix;
      matrix.reinit(pattern);
      LA::Vector rhs(owned, MPI_COMM_WORLD), solution(owned, MPI_COMM_WORLD),
        residual(owned, MPI_COMM_WORLD);
      for (const auto i : owned)
        {
          matrix.set(i, i, 2 + i % 3);
          matrix.set(i, other(i), -1.5);
          rhs[i] = 1. + i % 5;
        }
      matrix.compress(VectorOperation::insert);
      rhs.compress(VectorOperation::insert);
      const bool success = solver.factorize(matrix, Symmetry::none).success &&
                           solver.solve(solution, rhs, 0).success;
      matrix.residual(residual, solution, rhs);
      out << "distance " << distance << ": " << (success ? "solved" : "failed")
          << ", residual "
          << (residual.l2_norm() < 1e-8 * rhs.l2_norm() ? "below" : "above")
          << " 1e-8" << std::endl;
    }
}
