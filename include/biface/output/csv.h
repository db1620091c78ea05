// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_output_csv_h
#define biface_output_csv_h

#include <mpi.h>

#include <optional>
#include <string>
#include <vector>

#include <biface/model/mesh/wave_numbers.h>

namespace Biface
{
  /** A table of numbers, distributed over the ranks by rows. */
  using Rows = std::vector<std::vector<double>>;

  /**
   * Write the rows of all ranks, sorted by their leading columns, below a line
   * of column names.
   *
   * Must be called on all ranks; the first one writes. Throws OutputError on
   * all ranks if the file cannot be written.
   *
   * @param header column names, separated by commas.
   */
  void
  write_csv(const std::string &path,
            const std::string &header,
            const Rows        &rows,
            const MPI_Comm     communicator);

  /** A number with the 12 digits of files of results. */
  std::string
  csv_number(const double value);

  /** The columns circumferential_waves and meridional_half_waves, with nan
   * where there are no waves. */
  std::string
  csv_waves(const std::optional<WaveNumbers> &waves);

  /**
   * Append a text to a file, or replace the contents, on the first rank. On
   * failure the file is unchanged. Must be called on all ranks. Throws
   * OutputError on all ranks if the file cannot be written.
   */
  void
  write_text(const std::string &path,
             const std::string &text,
             const bool         append,
             const MPI_Comm     communicator);

  /**
   * Write the texts of all ranks, in the order of the ranks, to one file. On
   * failure the file is unchanged. Must be called on all ranks; the first one
   * writes, and stores the text of one rank at a time. Throws OutputError on
   * all ranks if the file cannot be written.
   */
  void
  write_texts_of_ranks(const std::string &path,
                       const std::string &text,
                       const MPI_Comm     communicator);
} // namespace Biface

#endif
