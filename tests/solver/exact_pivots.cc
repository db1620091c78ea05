// SPDX-License-Identifier: LGPL-2.1-or-later

// The negative pivots of factors in single precision and of factors of a
// similar matrix are not exact; those of factors of the matrix in double
// precision are.

#include <deal.II/base/timer.h>

#include <iostream>

#include <biface/solver/linear/mumps_solver.h>

#include "laplacian.h"
#include <tests.h>

int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  ConditionalOStream               out(std::cout, false);
  TimerOutput timer(out, TimerOutput::never, TimerOutput::wall_times);
  Laplacian   system;

  const auto print = [](const std::string        &name,
                        const LinearSolverResult &result) {
    std::cout << name << ": "
              << (result.n_negative_pivots == 0u ? "no" : "some")
              << " negative pivots, "
              << (result.pivots_are_exact ? "exact" : "not exact") << std::endl;
  };

  MumpsSolver single(MPI_COMM_WORLD, timer, true);
  system.set(0.1);
  print("single precision", single.factorize(system.matrix, Symmetry::full));
  print("for many systems", single.factorize_for_many(system.matrix, true));

  MumpsSolver precise(MPI_COMM_WORLD, timer, false);
  print("double precision", precise.factorize(system.matrix, Symmetry::full));
  system.set(-3);
  print("factors of a positive definite one",
        precise.keep_factors(system.matrix, Symmetry::full));
  print("after GMRES failed", precise.solve(system.solution, system.rhs, 0));
}
