// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_base_gather_h
#define biface_base_gather_h

#include <deal.II/base/mpi.h>
#include <deal.II/base/utilities.h>

#include <numeric>
#include <vector>

namespace Biface
{
  /**
   * The numbers of all ranks in their order, on the first rank; empty on the
   * others. Their total number must fit into an int.
   *
   * deal.II's gather() compresses the data, which takes longer than sending
   * them.
   */
  template <typename Number>
  std::vector<Number>
  gather_numbers(const MPI_Comm communicator, const std::vector<Number> &mine)
  {
    namespace MPI      = dealii::Utilities::MPI;
    const bool is_root = (MPI::this_mpi_process(communicator) == 0);

    const int        n_mine = mine.size();
    std::vector<int> counts(is_root ? MPI::n_mpi_processes(communicator) : 0);
    MPI_Gather(&n_mine, 1, MPI_INT, counts.data(), 1, MPI_INT, 0, communicator);

    std::vector<int> begins(counts.size());
    std::exclusive_scan(counts.begin(), counts.end(), begins.begin(), 0);
    std::vector<Number> all(is_root ? begins.back() + counts.back() : 0);
    const MPI_Datatype  type = MPI::mpi_type_id_for_type<Number>;
    MPI_Gatherv(mine.data(),
                n_mine,
                type,
                all.data(),
                counts.data(),
                begins.data(),
                type,
                0,
                communicator);
    return all;
  }


  /** The objects of all ranks in their order, on all of them, without
   * compression, see gather_numbers(). */
  template <typename Object>
  std::vector<Object>
  gather_on_all(const MPI_Comm communicator, const Object &mine)
  {
    const int n_ranks = dealii::Utilities::MPI::n_mpi_processes(communicator);
    if (n_ranks == 1)
      return {mine};
    const std::vector<char> packed = dealii::Utilities::pack(mine, false);
    const int               n_mine = packed.size();
    std::vector<int>        counts(n_ranks), begins(n_ranks);
    MPI_Allgather(&n_mine, 1, MPI_INT, counts.data(), 1, MPI_INT, communicator);
    std::exclusive_scan(counts.begin(), counts.end(), begins.begin(), 0);
    std::vector<char> all(begins.back() + counts.back());
    MPI_Allgatherv(packed.data(),
                   n_mine,
                   MPI_CHAR,
                   all.data(),
                   counts.data(),
                   begins.data(),
                   MPI_CHAR,
                   communicator);
    std::vector<Object> result;
    for (int rank = 0; rank < n_ranks; ++rank)
      result.push_back(dealii::Utilities::unpack<Object>(
        all.cbegin() + begins[rank],
        all.cbegin() + begins[rank] + counts[rank],
        false));
    return result;
  }
} // namespace Biface

#endif
