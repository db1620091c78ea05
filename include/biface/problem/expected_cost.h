// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_problem_expected_cost_h
#define biface_problem_expected_cost_h

#include <mpi.h>

#include <string>

#include <biface/problem/parameters.h>
#include <biface/surface/chart_grid.h>

namespace Biface
{
  /** What a step of a stage takes, in iterations of a shell that does not roll:
   * also the derivatives of its results, the rounds of the temperatures, and
   * what relaxation adds to an iteration of a wheel that rolls. */
  double
  expected_iterations(const Parameters &parameters, const Stage &stage);


  /** What an analysis takes, from runs of the bias tire (doc/performance.md):
   * the memory within a third, the time within its order of magnitude. */
  struct ExpectedCost
  {
    /** The memory of all ranks, in bytes. */
    double memory = 0;
    /** The time in seconds of all stages, those of a tire test included, with
     * modes and buckling loads at their ends. */
    double seconds = 0;
    /** The steps planned. */
    double n_steps = 0;

    ExpectedCost(const Parameters &parameters,
                 const ChartGrid  &grid,
                 const MPI_Comm    communicator);

    /** A text such as "about 0.4 GiB of memory and a time of seconds for 21
     * steps". */
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
