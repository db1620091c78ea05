// SPDX-License-Identifier: LGPL-2.1-or-later

// A mesh that needs more memory than the process may have is refused; one that
// fits is not.

#include "../restart.h"
#include "../tests.h"
#include <sys/resource.h>

using namespace dealii;

int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  double                           pages = 0;
  std::ifstream("/proc/self/statm") >> pages;
  rlimit limit;
  getrlimit(RLIMIT_AS, &limit);
  // one gigabyte more than now
  limit.rlim_cur = pages * sysconf(_SC_PAGESIZE) + 1e9;
  setrlimit(RLIMIT_AS, &limit);
  for (const std::string n : {"20", "400"})
    {
      const Ended ended = run({PRM_DIR "/bias_tire.prm",
                               "--check",
                               "--set",
                               "Mesh/Intervals alpha_1=-120:120:" + n,
                               "--set",
                               "Mesh/Intervals alpha_2=-180:180:" + n},
                              "none",
                              MPI_COMM_WORLD);
      std::cout << n << " x " << n << " cells: " << ended.code << std::endl;
      const bool is_big = (n == "400");
      check_true("a sentence on memory",
                 is_big ==
                   (ended.err.find("GiB of memory, but there are only") !=
                    std::string::npos));
      check_true("expected cost",
                 is_big == (ended.out.find("GiB of memory and a time of") ==
                            std::string::npos));
    }
}
