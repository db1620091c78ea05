// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_input_pairs_file_h
#define biface_input_pairs_file_h

#include <deal.II/base/point.h>

#include <mpi.h>

#include <map>
#include <string>
#include <vector>

namespace Biface
{
  /** A file of pairs of numbers named by an entry. */
  struct PairsFile
  {
    /** The name of the file; empty for none. */
    std::string                   name;
    std::vector<dealii::Point<2>> pairs;

    /** Read the pairs, see read_file() and parse_pairs(). */
    void
    read(const std::string &meaning,
         const MPI_Comm     communicator,
         const std::string &unit_of_length = "");
  };


  /** The contents of files of pairs, by entry. */
  using PairsByEntry = std::map<std::string, std::vector<dealii::Point<2>>>;
} // namespace Biface

#endif
