// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/mpi.h>

#include <biface/study/sample_queue.h>

namespace Biface
{
  using namespace dealii;

  SampleQueue::SampleQueue(const MPI_Comm all, const MPI_Comm group)
    : group(group), window(MPI_WIN_NULL), counter(nullptr)
  {
    const bool is_first = (Utilities::MPI::this_mpi_process(all) == 0);
    const int  ierr     = MPI_Win_allocate(is_first ? sizeof(long) : 0,
                                      sizeof(long),
                                      MPI_INFO_NULL,
                                      all,
                                      &counter,
                                      &window);
    AssertThrowMPI(ierr);
    if (is_first)
      {
        MPI_Win_lock(MPI_LOCK_EXCLUSIVE, 0, 0, window);
        *counter = 0;
        MPI_Win_unlock(0, window);
      }
    // no group may count before the counter is set
    MPI_Barrier(all);
  }


  SampleQueue::~SampleQueue()
  {
    MPI_Win_free(&window);
  }


  long
  SampleQueue::fetch(const long operand, const MPI_Op operation)
  {
    long before = 0;
    if (Utilities::MPI::this_mpi_process(group) == 0)
      {
        MPI_Win_lock(MPI_LOCK_SHARED, 0, 0, window);
        // one-sided and atomic: no group waits for the first rank, which has
        // samples of its own, and none gets the number of another
        const int ierr = MPI_Fetch_and_op(
          &operand, &before, MPI_LONG, 0, 0, operation, window);
        AssertThrowMPI(ierr);
        MPI_Win_unlock(0, window);
      }
    return Utilities::MPI::broadcast(group, before);
  }


  long
  SampleQueue::next()
  {
    return fetch(1, MPI_SUM);
  }


  void
  SampleQueue::skip_to(const long end)
  {
    fetch(end, MPI_REPLACE);
  }
} // namespace Biface
