// SPDX-License-Identifier: LGPL-2.1-or-later

// A strip between clamps that is compressed first and then pushed sideways,
// with a factor for each displacement of the clamp, has the lateral stiffness
// of a beam under axial force; a given displacement, a controlled one and a
// single stage give the same force.

#include <deal.II/base/mpi.h>

#include <cmath>
#include <string>
#include <vector>

#include "../restart.h"

using namespace dealii;

namespace
{
  /** The last value of a column of a table, or that in lines with a word. */
  double
  last(const std::string &directory,
       const std::string &file,
       const std::string &column,
       const std::string &word = "")
  {
    const auto         table = read_table(directory + "/" + file);
    const unsigned int at =
      std::find(table[0].begin(), table[0].end(), column) - table[0].begin();
    double value = NAN;
    for (const auto &row : table)
      if (word.empty() || std::count(row.begin(), row.end(), word) > 0)
        value = std::strtod(row.at(at).c_str(), nullptr);
    return value;
  }


  void
  run_strip(const std::string              &directory,
            const std::vector<std::string> &settings)
  {
    const Ended ended = run(with({DATA_DIR "/compressed_strip.prm"}, settings),
                            directory,
                            MPI_COMM_SELF);
    std::cout << directory << ": " << ended.code << '\n' << ended.err;
  }


  double
  force(const std::string &directory, const std::string &body, const char axis)
  {
    return last(directory, "forces.csv", std::string("F_") + axis, body);
  }
} // namespace


int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  run_strip("two_stages", {});
  const double lateral = force("two_stages", "alpha_1 max", 'z');
  const double axial   = -force("two_stages", "alpha_1 max", 'x');

  // two cantilevers of half the length, under the axial force P
  const double EI = 1e5 * 10 / 12, P = 1e5 * 10 * 0.005 / 100, half = 50;
  const double kappa = std::sqrt(P / EI);
  const double stiffness =
    kappa * P / (2 * (std::tan(kappa * half) - kappa * half));
  check_small("axial force", axial / P - 1, 1e-3);
  check_small("lateral stiffness", lateral / 0.01 / stiffness - 1, 5e-3);
  // as without the first stage
  check_small("it is lower than 12 E I/L^3 by",
              lateral / 0.01 / (12 * EI / 1e6) - 0.395,
              5e-3);

  check_small("balance of forces along z",
              force("two_stages", "alpha_1 min", 'z') + lateral,
              1e-8,
              lateral);
  // in the second stage
  const auto change = [](const std::string &column) {
    return last("two_stages", "history.csv", column, "push") -
           last("two_stages", "history.csv", column, "compress");
  };
  check_small("work of the lateral support",
              change("load_work") / change("strain_energy") - 1,
              1e-4);

  run_strip("controlled",
            {"Supports/alpha_1 max=v_1 both = -0.005; v_2 both",
             "Loads/Edge forces=alpha_1 max: 0 0 1",
             "Stage 1/Load factors=supports: 1",
             "Stage 2/Control=displacement",
             "Stage 2/Control point=end",
             "Stage 2/Control component=z",
             "Stage 2/Control value=0.01",
             "Stage 2/Load factor=1",
             "Stage 2/Load factors=supports: unchanged"});
  check_small("lateral force under a controlled displacement",
              10 * last("controlled", "history.csv", "load_factor") - lateral,
              1e-6,
              lateral);

  run_strip(
    "one_stage",
    {"Number of stages=1", "Stage 1/Load factors=", "Stage 1/Load factor=1"});
  check_small("lateral force in one stage",
              force("one_stage", "alpha_1 max", 'z') - lateral,
              1e-8,
              lateral);

  run_strip("from_prestress", {"Stage 2/Start from prestress=true"});
  check_small("lateral force from the prestress",
              force("from_prestress", "alpha_1 max", 'z') - lateral,
              1e-3,
              lateral);
}
