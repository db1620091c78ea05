// SPDX-License-Identifier: LGPL-2.1-or-later

// The direct solver solves systems with several right hand sides at once as it
// does one by one, with factors in single and in double precision.

#include <deal.II/base/timer.h>

#include <iostream>
#include <vector>

#include <biface/solver/linear/mumps_solver.h>

#include "laplacian.h"
#include <tests.h>

int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  ConditionalOStream               no_output(std::cout, false);
  TimerOutput timer(no_output, TimerOutput::never, TimerOutput::wall_times);

  Laplacian system;
  system.set(0.1);
  std::vector<LA::Vector> rhs(3, system.rhs);
  for (const auto i : system.rhs.locally_owned_elements())
    for (unsigned int r = 1; r < rhs.size(); ++r)
      rhs[r][i] = std::sin(r * i) * std::pow(1e6, r);
  for (LA::Vector &b : rhs)
    b.compress(VectorOperation::insert);

  MumpsSolver solver(MPI_COMM_WORLD, timer);
  for (const bool many : {false, true})
    {
      const bool factorized =
        (many ? solver.factorize_for_many(system.matrix, true)
              : solver.factorize(system.matrix, Symmetry::full))
          .success;
      std::vector<LA::Vector> x(rhs.size(), system.solution);
      const bool              solved  = solver.solve_all(x, rhs, 0).success;
      double                  largest = 0;
      for (unsigned int r = 0; r < rhs.size(); ++r)
        {
          LA::Vector alone(system.solution);
          solver.solve(alone, rhs[r], 0);
          const double size = alone.l2_norm();
          alone -= x[r];
          largest = std::max(largest, alone.l2_norm() / size);
        }
      if (Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
        {
          std::cout << (many ? "double" : "single") << " precision: "
                    << (factorized && solved ? "solved" : "failed")
                    << std::endl;
          check_small("at once against one by one", largest, 1e-10);
        }
    }
}
