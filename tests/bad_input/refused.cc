// SPDX-License-Identifier: LGPL-2.1-or-later

// Each file NAME.prm of this folder is refused with the exit code and the
// sentence in NAME.expected, on any number of ranks; one process tries all.

#include <algorithm>

#include "../run_file.h"

using namespace dealii;

int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  const bool first_rank = Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0;

  std::vector<std::filesystem::path> files;
  for (const auto &entry : std::filesystem::directory_iterator(BAD_INPUT_DIR))
    if (entry.path().extension() == ".prm")
      files.push_back(entry.path());
  std::sort(files.begin(), files.end());

  unsigned int n_different = 0;
  for (std::filesystem::path file : files)
    {
      const auto [code, message] = run_file(file.string(), MPI_COMM_WORLD);
      const std::string answer =
        "exit code: " + std::to_string(code) + '\n' + message;
      std::ostringstream expected;
      expected << std::ifstream(file.replace_extension("expected")).rdbuf();
      if (first_rank && answer != expected.str())
        {
          std::cout << file.stem().string() << ": " << answer;
          ++n_different;
        }
    }
  if (first_rank)
    std::cout << "files: " << (files.empty() ? "none" : "found")
              << "\nanswered otherwise: " << n_different << std::endl;
}
