// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/mpi.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>

#include <biface/base/input_error.h>
#include <biface/base/read_file.h>

namespace Biface
{
  using namespace dealii;

  std::string
  read_file(const std::string &file_name, const MPI_Comm communicator)
  {
    std::string text, reason;
    if (Utilities::MPI::this_mpi_process(communicator) == 0)
      {
        std::error_code error;
        errno = 0;
        std::ifstream file(file_name);
        if (std::filesystem::is_directory(file_name, error))
          reason = "it is a directory";
        else if (!file)
          reason = (errno != 0 ? std::strerror(errno) : "unknown reason");
        else
          text.assign(std::istreambuf_iterator<char>(file), {});
      }
    reason = Utilities::MPI::broadcast(communicator, reason);
    if (!reason.empty())
      throw InputError("the file '" + file_name + "' cannot be read (" +
                       reason + "), but it must exist and be readable.");
    return Utilities::MPI::broadcast(communicator, text);
  }
} // namespace Biface
