// SPDX-License-Identifier: LGPL-2.1-or-later

// The reported number of negative pivots is odd where the load falls along the
// path of a roof that snaps through, and even where it rises.

#include "../restart.h"

int
main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  const std::string directory = "results";
  const Ended       ended     = run({"--set",
                                     "Mesh/Intervals alpha_1=0:254:4",
                                     "--set",
                                     "Mesh/Intervals alpha_2=0:5.729577951308232:4",
                                     PRM_DIR "/snap_through_roof.prm"},
                          directory,
                          MPI_COMM_WORLD);

  std::vector<unsigned int> pivots;
  std::istringstream        lines(ended.out);
  std::string               line;
  while (std::getline(lines, line))
    if (line.rfind("  step ", 0) == 0)
      {
        const auto end = line.find(" negative pivot");
        pivots.push_back(end == std::string::npos
                           ? 0
                           : std::stoi(line.substr(line.rfind(", ", end) + 2)));
      }

  const auto history = read_table(directory + "/history.csv");
  const auto column =
    std::find(history[0].begin(), history[0].end(), "load_factor") -
    history[0].begin();
  const auto factor = [&](const unsigned int step) {
    return std::stod(history[step].at(column));
  };
  unsigned int rising = 0, falling = 0, wrong = 0;
  // a step across a limit point tells of both sides
  for (unsigned int i = 2; i + 1 < history.size(); ++i)
    {
      const bool rises = factor(i) > factor(i - 1);
      if (rises != (factor(i + 1) > factor(i)))
        continue;
      ++(rises ? rising : falling);
      wrong += (pivots[i - 1] % 2 == (rises ? 1 : 0));
    }
  std::cout << "steps with rising load: " << (rising > 5 ? "some" : "none")
            << ", with falling load: " << (falling > 5 ? "some" : "none")
            << ", with the wrong sign: " << wrong << std::endl;
}
