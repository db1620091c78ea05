// SPDX-License-Identifier: LGPL-2.1-or-later

// The symmetric part of a matrix has as many negative pivots as eigenvalues,
// and its factors solve the system of a matrix that is close to it; the whole
// of one that only claims to be is factorized.

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

  const auto solve = [&](const double shift, const double wind) {
    system.set_with_wind(shift, wind);
    const LinearSolverResult factorized =
      solver.factorize(system.matrix, Symmetry::nearly);
    const bool success =
      factorized.success &&
      solver.solve(system.solution, system.rhs, 1e-10).success;
    out << "skew-symmetric part " << wind << ": "
        << (success ? "solved" : "failed") << ", residual "
        << (system.relative_residual() < 1e-9 ? "below" : "above")
        << " 1e-9, pivots ";
    if (factorized.n_negative_pivots)
      out << (*factorized.n_negative_pivots == Laplacian::n_negative(shift)
                ? "as eigenvalues"
                : "wrong");
    else
      out << "not counted";
    out << ", factorizations so far "
        << timer.get_summary_data(
             TimerOutput::n_calls)["Linear solver: factorization"]
        << std::endl;
  };

  solve(0.1, 1e-3);
  solve(-0.5, 1e-3);

  // other factors stay, or are computed anew
  for (const bool often : {true, false})
    {
      for (const double shift : {0.1, -0.5, -1.7})
        {
          Laplacian other;
          other.set_with_wind(shift, 5);
          const auto n = solver.count_negative_pivots(other.matrix, often);
          out << "shift " << shift << ": "
              << (n && *n == Laplacian::n_negative(shift) ? "as eigenvalues"
                                                          : "wrong")
              << std::endl;
        }
      out << "after that: "
          << (solver.solve(system.solution, system.rhs, 1e-10).success &&
                  system.relative_residual() < 1e-9
                ? "solved"
                : "failed")
          << std::endl;
    }

  solve(0.1, 3);
  solve(0.1, 1e-3);
}
