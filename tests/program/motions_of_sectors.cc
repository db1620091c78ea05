// SPDX-License-Identifier: LGPL-2.1-or-later

// Whether a support that moves is translated or turned, and its force, do not
// depend on the number of cells of the sector that is modeled: a sector of one
// cell, whose nodes a translation fits anyway, has the columns of the full
// turn.

#include <cmath>

#include "../read_csv.h"
#include "../restart.h"
#include "tube.h"

using namespace dealii;

namespace
{
  const std::string supported =
    "subsection Supports\nset alpha_1 min = fixed\nend\n"
    "subsection Stage 1\nset Strain theory = linear\n"
    "set Load factor = 1\nend\n";


  /** The last line of history.csv with a support and further options. */
  Row
  history(const std::string &support, const std::vector<std::string> &options)
  {
    std::vector<std::string> words{"tube.prm",
                                   "--set",
                                   "Mesh/Intervals alpha_1=0:60:3",
                                   "--set",
                                   "Supports/alpha_1 max=" + support};
    for (const std::string &option : options)
      {
        words.emplace_back("--set");
        words.push_back(option);
      }
    const Ended ended = run(words, "results", MPI_COMM_WORLD);
    if (ended.code != 0)
      std::cout << ended.err;
    return read_csv("results/history.csv").back();
  }
} // namespace


int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  std::ofstream("tube.prm") << tube("0.3") << supported;

  const std::vector<std::string> full{"Mesh/Intervals alpha_2=0:360:12"},
    cyclic{"Mesh/Intervals alpha_2=0:30:1",
           "Mesh/Closed in alpha_2=false",
           "Supports/alpha_2 min=cyclic",
           "Supports/alpha_2 max=cyclic"},
    symmetric{"Mesh/Intervals alpha_2=0:30:1",
              "Mesh/Closed in alpha_2=false",
              "Supports/alpha_2 min=symmetry",
              "Supports/alpha_2 max=symmetry"};
  const auto compare = [&](const std::string              &name,
                           const std::string              &support,
                           const std::vector<std::string> &sector,
                           const std::string              &moved,
                           const std::string              &force) {
    const Row whole = history(support, full), part = history(support, sector);
    for (const std::string &column :
         {"alpha_1_max_" + moved, "alpha_1_max_" + force})
      check_small(name + ", " + column,
                  std::stod(part.at(column)) / std::stod(whole.at(column)) - 1,
                  1e-9);
  };
  const std::string wide  = "radial both = 0.3; axial both = 0.4",
                    twist = "circumferential middle = 0.1; axial both",
                    screw = "circumferential middle = 0.1; axial both = 0.05";
  compare("cyclic, widened", wide, cyclic, "displacement", "force");
  compare("symmetric, widened", wide, symmetric, "displacement", "force");
  compare("cyclic, turned", twist, cyclic, "angle", "moment");
  // whose moment would not be that about the axis
  compare("cyclic, screwed", screw, cyclic, "displacement", "force");
  return 0;
}
