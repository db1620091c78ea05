// SPDX-License-Identifier: LGPL-2.1-or-later

// If the latest checkpoint is damaged, a run continues from the one before; if
// there is none, one sentence says so.

#include "../restart.h"
#include "../tests.h"

using namespace dealii;

namespace
{
  const std::string newest   = "cut/checkpoint.bin";
  const std::string previous = "cut/checkpoint-previous.bin";


  /** Change one byte of a file. */
  void
  damage(const std::string &path)
  {
    std::fstream file(path, std::ios::in | std::ios::out | std::ios::binary);
    const auto   place = std::filesystem::file_size(path) / 2;
    file.seekg(place);
    const char c = file.get();
    file.seekp(place);
    file.put(c ^ 1);
  }


  /** Bring a run to its fourth step. */
  void
  begin()
  {
    std::filesystem::remove_all("cut");
    run(with(coarse_tire, {"Checkpoint/Every steps=1"}),
        "cut",
        MPI_COMM_WORLD,
        "Step 5,");
  }


  void
  check_continued(const std::string &what)
  {
    const Ended ended = restart(coarse_tire, "cut", MPI_COMM_WORLD);
    std::cout << what << ": " << ended.code << '\n' << said(ended);
    std::istringstream lines(ended.out);
    std::string        line;
    while (std::getline(lines, line))
      if (line.rfind("The run continues", 0) == 0)
        std::cout << line << '\n';
    if (ended.code == 0)
      check_small("history", difference("history.csv", "whole", "cut"), 1e-9);
  }
} // namespace


int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  run(coarse_tire, "whole", MPI_COMM_WORLD);

  begin();
  damage(newest);
  check_continued("one byte is another");

  begin();
  std::filesystem::resize_file(newest, std::filesystem::file_size(newest) - 9);
  check_continued("cut off");

  begin();
  std::ofstream(newest, std::ios::trunc);
  check_continued("empty");

  begin();
  std::filesystem::remove(newest);
  check_continued("not there");

  begin();
  damage(newest);
  damage(previous);
  check_continued("both are damaged");

  std::filesystem::remove_all("cut");
  check_continued("no run was there");

  begin();
  {
    std::string   kept, line;
    std::ifstream file("cut/history.csv");
    for (unsigned int i = 0; i < 2 && std::getline(file, line); ++i)
      kept += line + '\n';
    std::filesystem::resize_file("cut/history.csv", kept.size());
  }
  check_continued("a history that lacks steps");
}
