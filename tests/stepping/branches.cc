// SPDX-License-Identifier: LGPL-2.1-or-later

// A stage that starts from the end of an earlier one has the same steps as if
// it followed that stage, whatever was between: the history of friction, the
// content of the gas, a prestress, a linear theory.

#include "../restart.h"

using namespace dealii;

namespace
{
  /** The lines of a stage in a table, without the number of the step and the
   * time. */
  std::vector<std::vector<double>>
  lines_of(const std::string &path, const std::string &stage)
  {
    const auto                       rows = read_table(path);
    std::vector<std::vector<double>> lines;
    for (const auto &row : rows)
      if (row[1] == stage)
        {
          lines.emplace_back();
          for (unsigned int i = 2; i < row.size(); ++i)
            if (rows[0][i] != "seconds" && rows[0][i] != "body" &&
                rows[0][i] != "motion")
              lines.back().push_back(std::stod(row[i]));
        }
    return lines;
  }


  /** Run the stage 'last' after stage 2, and in another run, after the stage
   * 'between', from the end of stage 2.
   * @param between, last the settings of the two, without "Stage N/". */
  void
  check(const std::string              &name,
        const std::vector<std::string> &words,
        const std::vector<std::string> &between,
        const std::vector<std::string> &last)
  {
    const auto with_stage = [](const std::vector<std::string> &words,
                               const unsigned int              number,
                               std::vector<std::string>        settings) {
      for (std::string &setting : settings)
        setting = "Stage " + std::to_string(number) + "/" + setting;
      return with(words, settings);
    };
    const auto follows =
      with_stage(with(words, {"Number of stages=3", no_vtu}), 3, last);
    const auto branches = with_stage(
      with_stage(with(words, {"Number of stages=4", no_vtu}), 3, between),
      4,
      last);
    const Ended one = run(follows, "follows", MPI_COMM_WORLD);
    const Ended other =
      run(with(branches, {"Stage 4/Start from=2"}), "branches", MPI_COMM_WORLD);
    std::cout << name << ": " << one.code << ", " << other.code << '\n'
              << one.err << other.err;
    check_true("  said",
               other.out.find("Start of last from the end of stage 2, ") !=
                 std::string::npos);
    for (const std::string file : {"history.csv", "forces.csv"})
      {
        const auto a        = lines_of("follows/" + file, "last");
        const auto b        = lines_of("branches/" + file, "last");
        double     distance = 0, size = 0;
        bool       alike = !a.empty() && a.size() == b.size();
        for (unsigned int i = 0; alike && i < a.size(); ++i)
          for (unsigned int j = 0; j < a[i].size(); ++j)
            {
              distance = std::max(distance, std::abs(a[i][j] - b[i].at(j)));
              size     = std::max(size, std::abs(a[i][j]));
            }
        check_true("  as many lines in " + file, alike);
        check_small("  " + file, distance, 1e-10, size);
      }
  }
} // namespace


int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  const auto rough = with(coarse_tire,
                          {"Contact/Friction=0.5",
                           "Contact/Tangential regularization=100",
                           "Stage 2/Travel=10",
                           "Stage 2/Steps=2"});
  check("friction",
        rough,
        {"Contact=true", "Slide=0, -3, 0", "Turn=2", "Steps=2"},
        {"Name=last", "Contact=true", "Slide=0, 2, 0", "Steps=2"});
  check("friction, after a prestress",
        rough,
        {"Start from prestress=true", "Strain theory=linear", "Pressure=0.1"},
        {"Name=last", "Contact=true", "Travel=12", "Steps=2"});
  check("prestress, after a stage from the deformed shape",
        rough,
        {"Contact=true", "Pressure=0.1"},
        {"Name=last", "Start from prestress=true", "Contact=true", "Travel=2"});
  check("linear, after another linear stage",
        rough,
        {"Contact=true", "Strain theory=linear", "Travel=11"},
        {"Name=last", "Contact=true", "Strain theory=linear", "Pressure=0.16"});
  check("prediction from a coarser mesh",
        with(coarse_tire,
             {"Mesh/Coarse meshes=1", "Stage 2/Travel=10", "Stage 2/Steps=2"}),
        {"Contact=true", "Pressure=0.1"},
        {"Name=last", "Contact=true", "Travel=12", "Steps=2"});
  check("sealed gas",
        {DATA_DIR "/gas_tube.prm"},
        {"Pressure=0.2", "Load factor=0.5"},
        {"Name=last", "Gas=sealed", "Load factor=2", "Steps=2"});
}
