// SPDX-License-Identifier: LGPL-2.1-or-later

// A run into a directory where another one is writing is refused on all ranks
// and leaves its results as they are; when the other one has ended, it is not.

#include <biface/output/result_file.h>

#include "../restart.h"

using namespace dealii;

int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  std::filesystem::create_directory("used");
  const auto history = [](const std::string &directory) {
    std::ifstream file(directory + "/history.csv");
    std::string   line;
    std::getline(file, line);
    return line;
  };
  const auto attempt = [&](const std::string &name) {
    const Ended ended =
      run({DATA_DIR "/strip_of_fibers.prm"}, "used", MPI_COMM_WORLD);
    const auto codes = Utilities::MPI::min_max_avg(ended.code, MPI_COMM_WORLD);
    if (!is_root())
      return;
    std::cout << name << ": exit codes " << codes.min << ' ' << codes.max
              << std::endl;
    const auto reason = ended.err.find("the entry");
    if (reason != std::string::npos)
      std::cout << ended.err.substr(reason);
    check_true("its own results",
               (history("used") == "of another run") == (ended.code != 0));
  };

  {
    const Biface::ResultsDirectory other("used", MPI_COMM_WORLD);
    if (is_root())
      std::ofstream("used/history.csv") << "of another run\n";
    attempt("while it runs");
  }
  attempt("later");
}
