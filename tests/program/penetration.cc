// SPDX-License-Identifier: LGPL-2.1-or-later

// A shell that penetrates the ground by more than 1 % of its thickness is
// warned of once a stage, with the penetration that belongs to the pressure.
// With the default penalty stiffness there is none.

#include <deal.II/base/mpi.h>

#include <sstream>
#include <string>
#include <vector>

#include <biface/program/program.h>

#include <read_csv.h>
#include <tests.h>

using namespace dealii;

namespace
{
  /** What the program prints about a strip that is pressed twice. */
  std::string
  printed(const std::string &penalty_stiffness)
  {
    std::ostringstream out, err;
    Biface::run_program({"--output",
                         "results",
                         "--set",
                         "Contact/Regularization=" + penalty_stiffness,
                         "--set",
                         "Number of stages=3",
                         "--set",
                         "Stage 3/Contact=true",
                         "--set",
                         "Stage 3/Travel=0.1",
                         "--set",
                         "Stage 3/Steps=2",
                         DATA_DIR "/sagging_strip.prm"},
                        MPI_COMM_WORLD,
                        out,
                        err);
    return out.str() + err.str();
  }
} // namespace


int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  const std::string        what = "penetrates the ground by ";
  const std::string        text = printed("100");
  const auto               rows = read_csv("results/history.csv");
  std::vector<std::string> warnings;
  for (auto at = text.find(what); at != std::string::npos;
       at      = text.find(what, at + 1))
    warnings.push_back(
      text.substr(at + what.size(), text.find('\n', at) - at - what.size()));
  std::cout << warnings.size() << " warnings" << std::endl;
  // the first steps of the stages with contact
  for (const unsigned int stage : {0, 1})
    check_small(
      "penetration",
      std::stod(warnings.at(stage)) /
          (std::stod(rows.at(1 + 2 * stage).at("max_pressure")) / 100) -
        1,
      1e-3);
  std::cout << warnings[0] << std::endl;
  check_true("none by default",
             printed("automatic").find(what) == std::string::npos);
}
