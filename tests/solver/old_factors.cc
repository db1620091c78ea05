// SPDX-License-Identifier: LGPL-2.1-or-later

// The direct solver solves a system whose matrix is similar to the last one
// without a factorization, and factorizes a matrix that only claims to be.

#include <deal.II/base/timer.h>

#include <iostream>

#include <biface/solver/linear/mumps_solver.h>

#include "laplacian.h"
#include <tests.h>

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
        (similar ? solver.keep_factors(system.matrix, Symmetry::full)
                 : solver.factorize(system.matrix, Symmetry::full))
          .success &&
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
