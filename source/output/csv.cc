// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>

#include <biface/base/errors.h>
#include <biface/base/gather.h>
#include <biface/output/atomic_file.h>
#include <biface/output/csv.h>

namespace Biface
{
  using namespace dealii;

  std::string
  csv_number(const double value)
  {
    char text[32];
    // zeros without sign, which round-off gives or not
    std::snprintf(text, sizeof(text), "%.12g", value == 0 ? 0. : value);
    return text;
  }


  std::string
  csv_waves(const std::optional<WaveNumbers> &waves)
  {
    if (!waves)
      return "nan,nan";
    return std::to_string(waves->circumferential) + ',' +
           std::to_string(waves->meridional);
  }


  namespace
  {
    /** @return the reason of a failure, after which the file has its previous
     * length. */
    std::string
    append_text(const std::string &path, const std::string &text)
    {
      std::error_code error;
      const auto      size = std::filesystem::file_size(path, error);
      errno                = 0;
      std::ofstream file(path, std::ios::app);
      file << text << std::flush;
      // what is buffered may find the disk full only here
      file.close();
      if (file)
        return "";
      const std::string reason =
        (errno != 0 ? std::strerror(errno) : "unknown reason");
      if (!error)
        std::filesystem::resize_file(path, size, error);
      return reason;
    }
  } // namespace


  void
  write_text(const std::string &path,
             const std::string &text,
             const bool         append,
             const MPI_Comm     communicator)
  {
    std::string reason;
    if (Utilities::MPI::this_mpi_process(communicator) == 0)
      {
        if (append)
          reason = append_text(path, text);
        else
          {
            AtomicFile file(path);
            file.write(text);
            file.commit();
            reason = file.error();
          }
      }
    reason = Utilities::MPI::broadcast(communicator, reason);
    if (!reason.empty())
      throw OutputError(path, reason);
  }


  void
  write_texts_of_ranks(const std::string &path,
                       const std::string &text,
                       const MPI_Comm     communicator)
  {
    // a message is limited to 2^31 - 1 bytes
    constexpr std::uint64_t longest = 1 << 28;
    const unsigned int n_ranks = Utilities::MPI::n_mpi_processes(communicator);

    std::string reason;
    if (Utilities::MPI::this_mpi_process(communicator) == 0)
      {
        AtomicFile file(path);
        file.write(text);
        // piece by piece, so that the first rank never holds the whole file
        std::vector<char> buffer;
        for (unsigned int rank = 1; rank < n_ranks; ++rank)
          {
            std::uint64_t left = 0;
            MPI_Recv(
              &left, 1, MPI_UINT64_T, rank, 0, communicator, MPI_STATUS_IGNORE);
            while (left > 0)
              {
                const std::uint64_t n = std::min(left, longest);
                buffer.resize(n);
                MPI_Recv(buffer.data(),
                         n,
                         MPI_CHAR,
                         rank,
                         0,
                         communicator,
                         MPI_STATUS_IGNORE);
                file.write(buffer.data(), n);
                left -= n;
              }
          }
        file.commit();
        reason = file.error();
      }
    else
      {
        const std::uint64_t size = text.size();
        MPI_Send(&size, 1, MPI_UINT64_T, 0, 0, communicator);
        for (std::uint64_t begin = 0; begin < size; begin += longest)
          MPI_Send(text.data() + begin,
                   std::min(size - begin, longest),
                   MPI_CHAR,
                   0,
                   0,
                   communicator);
      }
    reason = Utilities::MPI::broadcast(communicator, reason);
    if (!reason.empty())
      throw OutputError(path, reason);
  }


  void
  write_csv(const std::string &path,
            const std::string &header,
            const Rows        &rows,
            const MPI_Comm     communicator)
  {
    const std::size_t n_columns =
      std::count(header.begin(), header.end(), ',') + 1;
    std::vector<double> values;
    for (const std::vector<double> &row : rows)
      {
        AssertDimension(row.size(), n_columns);
        values.insert(values.end(), row.begin(), row.end());
      }
    values = gather_numbers(communicator, values);
    Rows all_rows;
    for (auto value = values.begin(); value != values.end(); value += n_columns)
      all_rows.emplace_back(value, value + n_columns);
    // files must not depend on the partition
    std::sort(all_rows.begin(), all_rows.end());

    std::string text = header + "\n";
    for (const auto &row : all_rows)
      {
        for (unsigned int i = 0; i < row.size(); ++i)
          // what means nothing at a place is an empty field
          text += (i > 0 ? "," : "") +
                  (std::isnan(row[i]) ? std::string() : csv_number(row[i]));
        text += "\n";
      }
    write_text(path, text, false, communicator);
  }
} // namespace Biface
