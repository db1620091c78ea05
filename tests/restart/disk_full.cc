// SPDX-License-Identifier: LGPL-2.1-or-later

// If a file cannot grow any more, one sentence says so, the last checkpoint
// remains valid, and a restart with more space gives the results of an
// undisturbed run.

#include "../restart.h"
#include "../tests.h"
#include <sys/resource.h>

using namespace dealii;

namespace
{
  /** Let no file of this process be longer. */
  void
  limit_files(const rlim_t size)
  {
    struct rlimit limit;
    getrlimit(RLIMIT_FSIZE, &limit);
    limit.rlim_cur = (size == 0 ? limit.rlim_max : size);
    setrlimit(RLIMIT_FSIZE, &limit);
  }


  void
  check(const std::string              &what,
        const rlim_t                    size,
        const std::vector<std::string> &settings)
  {
    const auto words = with(coarse_tire, settings);
    std::filesystem::remove_all("cut");
    run(words, "whole", MPI_COMM_WORLD);
    run(words, "cut", MPI_COMM_WORLD, "Step 4,");

    limit_files(size);
    const Ended full = restart(words, "cut", MPI_COMM_WORLD);
    limit_files(0);
    std::cout << what << ": " << full.code << '\n' << full.err;

    const Ended continued = restart(words, "cut", MPI_COMM_WORLD);
    std::cout << "with more room: " << continued.code << '\n' << continued.err;
    unsigned int n_temporary = 0;
    for (const auto &file : std::filesystem::directory_iterator("cut"))
      n_temporary += (file.path().extension() == ".tmp");
    check_small("history", difference("history.csv", "whole", "cut"), 1e-9);
    check_true("no temporary file is left", n_temporary == 0);
  }
} // namespace


int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  // checkpoints have about 240000 bytes, the parameters 79000, files of steps
  // of twice as many cells 130000
  check("checkpoint", 100000, {no_vtu});
  check("faces", 100000, {"Mesh/Intervals alpha_1=-120:120:28"});
}
