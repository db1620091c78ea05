// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_problem_expected_cost_h
#define biface_problem_expected_cost_h

#include <mpi.h>

#include <string>

#include <biface/problem/parameters.h>
#include <biface/surface/chart_grid.h>

namespace Biface
{
  /** What an analysis takes, from runs of the bias tire (doc/performance.md):
   * the memory within a third, the time within its order of magnitude. */
  struct ExpectedCost
  {
    /** The memory of all ranks, in bytes. */
    double memory = 0;
    /** The time of all stages, in seconds. */
    double seconds = 0;

    ExpectedCost(const Parameters &parameters,
                 const ChartGrid  &grid,
                 const MPI_Comm    communicator);

    /** A text such as "about 0.4 GiB of memory and a time of seconds". */
    std::string
    text() const;
  };


  /** Refuse an analysis that cannot fit into the memory of the machines, or
   * into what the ranks may have of it, before the system ends the program.
   * Throws InputError. Must be called on all ranks. */
  void
  check_memory(const Parameters &parameters,
               const ChartGrid  &grid,
               const MPI_Comm    communicator);
} // namespace Biface

#endif
