// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_study_sample_queue_h
#define biface_study_sample_queue_h

#include <mpi.h>

namespace Biface
{
  /**
   * Numbers 0, 1, 2, ..., each of which is given to one group of ranks, when
   * the group asks for it. The counter is in the memory of the first rank,
   * which need not answer: the groups use one-sided communication, and no rank
   * waits for the others.
   */
  class SampleQueue
  {
  public:
    /** Create the counter. Must be called on all ranks.
     * @param all all ranks of the study.
     * @param group the ranks of the group of this one. */
    SampleQueue(const MPI_Comm all, const MPI_Comm group);

    /** Free the counter. Must be called on all ranks. */
    ~SampleQueue();

    SampleQueue(const SampleQueue &) = delete;
    SampleQueue &
    operator=(const SampleQueue &) = delete;

    /** The next number. Must be called on all ranks of the group. */
    long
    next();

    /** From now on, all groups receive numbers beyond @p end. Must be called on
     * all ranks of the group. */
    void
    skip_to(const long end);

  private:
    /** Apply an operation to the counter.
     * @return its value before, on all ranks of the group. */
    long
    fetch(const long operand, const MPI_Op operation);

    const MPI_Comm group;
    MPI_Win        window;
    long          *counter;
  };
} // namespace Biface

#endif
