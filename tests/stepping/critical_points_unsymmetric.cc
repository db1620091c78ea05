// SPDX-License-Identifier: LGPL-2.1-or-later

// Where the tangent of a shell is not symmetric by its material law, the
// program says that it cannot locate critical points; where the pressure
// follows a free edge and only the symmetric part is singular, that this is
// none.

#include "../restart.h"

int
main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  const std::vector<std::string> cylinder =
    with({DATA_DIR "/cylinder_under_pressure.prm"},
         {"Loads/Pressure type=dead",
          "Stage 1/Pressure=-0.1",
          "Mesh/Intervals alpha_1=0:200:6",
          "Mesh/Intervals alpha_2=0:10:2"});
  const std::vector<std::string> arch =
    with({DATA_DIR "/../verification/buckling_ring.prm"},
         {"Supports/alpha_2 min=fixed",
          "Supports/alpha_2 max=free",
          "Stage 1/Critical points=locate",
          "Stage 1/Pressure=-0.65",
          "Stage 1/Steps=13",
          "Stage 1/Buckling=0"});
  const std::vector<std::pair<std::string, std::vector<std::string>>> cases{
    {"asymmetric law",
     with(cylinder,
          {"Formulation=paper", "Laminate/Thickness law=asymmetric"})},
    {"symmetric law", cylinder},
    {"free edge", arch}};
  for (const auto &[name, arguments] : cases)
    {
      const Ended ended = run(arguments, "results", MPI_COMM_SELF);
      std::cout << name << ": exit code " << ended.code << said(ended)
                << std::endl;
      std::istringstream lines(ended.out);
      for (std::string line; std::getline(lines, line);)
        if (line.find("Warning") != std::string::npos ||
            line.find("negative pivots:") != std::string::npos)
          std::cout << line << std::endl;
    }
}
