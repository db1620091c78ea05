// SPDX-License-Identifier: LGPL-2.1-or-later

// The direct solver factorizes in single precision, and in double precision
// once a matrix is too ill-conditioned for that.

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

  for (const bool single_precision : {true, false})
    {
      out << (single_precision ? "single" : "double") << " precision first"
          << std::endl;
      TimerOutput timer(no_output, TimerOutput::never, TimerOutput::wall_times);
      Laplacian   system;
      MumpsSolver solver(MPI_COMM_WORLD, timer, single_precision);

      const auto solve = [&](const std::string &name) {
        const bool success =
          solver.factorize(system.matrix, Symmetry::full).success &&
          solver.solve(system.solution, system.rhs, 0).success;
        const auto n_calls = timer.get_summary_data(TimerOutput::n_calls);
        out << "  " << name << ": " << (success ? "solved" : "failed")
            << ", residual "
            << (system.relative_residual() < 1e-9 ? "below" : "above")
            << " 1e-9, so far " << n_calls.at("Linear solver: analysis")
            << " analyses and " << n_calls.at("Linear solver: factorization")
            << " factorizations" << std::endl;
      };

      system.set(0.1);
      solve("condition number 1e2");
      system.set_lines(1e-8);
      solve("condition number 1e9");
      system.set(0.1);
      solve("condition number 1e2");
    }
}
