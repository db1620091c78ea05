// SPDX-License-Identifier: LGPL-2.1-or-later

// stiffness.csv has nan, and the run a warning, where forces change at the
// start of a stage though nothing moves: where friction falls and where glue
// ends. Later steps of such a stage have a tangent. Friction that rises, and
// another tangential stiffness, leave the forces as they were.

#include "../read_csv.h"
#include "../restart.h"

using namespace dealii;

int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  const Ended ended = run(with(soft_tire,
                               {no_vtu,
                                "Contact/Tangential regularization=100",
                                "Stage 2/Travel=10",
                                "Number of stages=7",
                                "Stage 3/Name=rough",
                                "Stage 3/Contact=true",
                                "Stage 3/Friction=0.5",
                                "Stage 3/Slide=0, 1, 0",
                                "Stage 4/Name=smoother",
                                "Stage 4/Contact=true",
                                "Stage 4/Friction=0.1",
                                "Stage 4/Slide=0, 2, 0",
                                "Stage 4/Steps=2",
                                "Stage 5/Name=rougher",
                                "Stage 5/Start from=3",
                                "Stage 5/Contact=true",
                                "Stage 5/Friction=0.7",
                                "Stage 5/Tangential regularization=50",
                                "Stage 5/Slide=0, 1.5, 0",
                                "Stage 6/Name=glued",
                                "Stage 6/Start from=2",
                                "Stage 6/Contact=true",
                                "Stage 6/Glued=true",
                                "Stage 6/Slide=0, 1, 0",
                                "Stage 7/Name=glue ends",
                                "Stage 7/Contact=true",
                                "Stage 7/Friction=0.5",
                                "Stage 7/Slide=0, 2, 0",
                                "Stage 7/Steps=2"}),
                          "results",
                          MPI_COMM_WORLD);
  std::cout << ended.code << '\n' << ended.err;
  std::istringstream lines(ended.out);
  for (std::string line; std::getline(lines, line);)
    if (line.find("stiffness.csv has") != std::string::npos)
      std::cout << line << std::endl;

  const auto kind = [](const std::string &value) {
    return value == "nan" ? "nan" : "a number";
  };
  for (const Row &row : read_csv("results/stiffness.csv"))
    std::cout << "step " << row.at("step") << ", " << row.at("stage") << ": "
              << row.at("motion") << ' ' << row.at("amount") << ", secant "
              << kind(row.at("secant")) << ", tangent "
              << kind(row.at("tangent")) << std::endl;
  return 0;
}
