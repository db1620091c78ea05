// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_restart_checkpoint_file_h
#define biface_restart_checkpoint_file_h

#include <mpi.h>

#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include <biface/restart/numbered_rows.h>

namespace Biface
{
  /**
   * The format of checkpoints: a binary file with an arbitrary header, tables
   * with rows by node or cell number, and a checksum (CRC-64) of the whole
   * file. It does not depend on the number of ranks. The first rank writes and
   * reads it in pieces, so that it never stores a whole table. A table of zeros
   * has no rows in the file.
   *
   * Numbers are binary; machines with another byte order refuse the file.
   */
  namespace CheckpointFile
  {
    /** Version of the format; files of other versions are refused. */
    constexpr std::uint32_t format = 18;

    using Table = std::pair<std::string, NumberedRows>;

    /** Write the file completely or not at all, and flush it to the disk. An
     * existing file of the same name becomes @p previous. Must be called on all
     * ranks. Throws OutputError. */
    void
    write(const std::string        &path,
          const std::string        &previous,
          const std::string        &header,
          const std::vector<Table> &tables,
          const MPI_Comm            communicator);

    /** Reads a file whose checksum is correct. */
    class Reader
    {
    public:
      /** Check the file and read its header. Throws InputError if it cannot be
       * used. All functions must be called on all ranks. */
      Reader(const std::string &path, const MPI_Comm communicator);

      const std::string &
      get_header() const
      {
        return header;
      }

      bool
      has(const std::string &table) const
      {
        return tables.count(table) > 0;
      }

      /** The rows of a table with the given numbers, in their order, row after
       * row. */
      std::vector<double>
      rows(const std::string                &table,
           const std::vector<std::uint64_t> &numbers) const;

      const MPI_Comm communicator;

    private:
      struct Entry
      {
        std::uint64_t width, n_rows, offset;
      };

      const std::string            path;
      std::string                  header;
      std::map<std::string, Entry> tables;
    };
  } // namespace CheckpointFile
} // namespace Biface

#endif
