// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fstream>

#include <biface/base/input_error.h>
#include <biface/output/csv.h>

namespace Biface
{
  using namespace dealii;

  std::string
  csv_number(const double value)
  {
    char text[32];
    std::snprintf(text, sizeof(text), "%.12g", value == 0 ? 0. : value);
    return text;
  }


  void
  write_text(const std::string &path,
             const std::string &text,
             const bool         append,
             const MPI_Comm     communicator)
  {
    std::string reason;
    if (Utilities::MPI::this_mpi_process(communicator) == 0)
      {
        errno = 0;
        std::ofstream file(path, append ? std::ios::app : std::ios::trunc);
        file << text << std::flush;
        if (!file)
          reason = (errno != 0 ? std::strerror(errno) : "unknown reason");
      }
    reason = Utilities::MPI::broadcast(communicator, reason);
    if (!reason.empty())
      throw InputError("the file '" + path + "' cannot be written (" + reason +
                       "), but results must go somewhere.");
  }


  void
  write_csv(const std::string &path,
            const std::string &header,
            const Rows        &rows,
            const MPI_Comm     communicator)
  {
    Rows all_rows;
    for (const Rows &part : Utilities::MPI::gather(communicator, rows))
      all_rows.insert(all_rows.end(), part.begin(), part.end());
    std::sort(all_rows.begin(), all_rows.end());

    std::string text = header + "\n";
    for (const auto &row : all_rows)
      {
        for (unsigned int i = 0; i < row.size(); ++i)
          text += (i > 0 ? "," : "") + csv_number(row[i]);
        text += "\n";
      }
    write_text(path, text, false, communicator);
  }
} // namespace Biface
