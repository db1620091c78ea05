// SPDX-License-Identifier: LGPL-2.1-or-later

// A study of groups of ranks ends with a message on all ranks if its table
// cannot be written any more.

#include <atomic>
#include <chrono>
#include <thread>

#include "../restart.h"
#include "../tests.h"

using namespace dealii;

int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  if (is_root())
    {
      std::filesystem::remove_all("study");
      std::ofstream("study.prm") << "subsection Study\n"
                                    "  set Base file = " DATA_DIR
                                    "/../stepping/displacement_control.prm\n"
                                    "  set Variables = E: Material roof/E\n"
                                    "  set Values = E: 3000, 3100, 3200\n"
                                    "  set Outputs = load_factor\n"
                                    "  set Group size = 2\n"
                                    "end\n";
    }
  MPI_Barrier(MPI_COMM_WORLD);

  // after the table was written for the first time
  std::atomic<bool> done{false};
  std::thread       full_disk([&]() {
    while (is_root() && !done)
      {
        std::error_code error;
        if (std::filesystem::exists("study/sample-0001"))
          {
            std::filesystem::create_symlink(
              "/dev/full", "study/study.csv.tmp", error);
            if (!error)
              return;
          }
        std::this_thread::sleep_for(std::chrono::microseconds(200));
      }
  });
  const Ended ended = run({"--study", "study.prm"}, "study", MPI_COMM_WORLD);
  done              = true;
  full_disk.join();
  const auto codes = Utilities::MPI::min_max_avg(ended.code, MPI_COMM_WORLD);
  if (is_root())
    {
      std::cout << ended.err;
      std::cout << "exit codes: " << codes.min << ' ' << codes.max << std::endl;
    }
}
