// SPDX-License-Identifier: LGPL-2.1-or-later

// The table of a study has the results of single runs, in groups of any number
// of ranks; a sample that fails is a line that says so; a restart runs only the
// samples that are missing.

#include "../read_csv.h"
#include "../restart.h"

using namespace dealii;

namespace
{
  const std::string coarse =
    "Mesh/Intervals alpha_1=-120:120:12; "
    "Mesh/Intervals alpha_2=-180:-20:3:smooth,-20:20:4,20:180:3:smooth; "
    "Contact/Multiplier mass=lumped; Contact/Regularization=1e3; "
    "Stage 2/Travel=10; Stage 2/Steps=1; Newton/Residual tolerance=1e-11; "
    "Output/Write VTU=false";

  /** Write a study file with further entries. */
  void
  write_study(const std::string &name, const std::string &entries)
  {
    if (is_root())
      std::ofstream(name) << "subsection Study\n"
                          << "set Base file = " << PRM_DIR << "/bias_tire.prm\n"
                          << entries << "end\n";
    MPI_Barrier(MPI_COMM_WORLD);
  }


  /** Run a study and print how it ended. */
  void
  study(const std::string              &file,
        const std::string              &directory,
        const std::vector<std::string> &more    = {},
        const std::string              &stop_at = "")
  {
    std::vector<std::string> words{"--study"};
    words.insert(words.end(), more.begin(), more.end());
    words.push_back(file);
    const Ended ended = run(words, directory, MPI_COMM_WORLD, stop_at);
    if (!is_root())
      return;
    // a signal may come when no sample is left to be started
    std::cout << directory << ": ";
    if (stop_at.empty())
      std::cout << ended.code << '\n';
    else
      std::cout << (ended.code == 0 || ended.code == 128 + SIGTERM ? "stopped"
                                                                   : "FAILED")
                << '\n';
    std::cout << said(ended);
    std::istringstream lines(ended.out);
    for (std::string line; std::getline(lines, line);)
      // how many are done when a signal comes depends on the groups
      if (stop_at.empty() && line.find(" samples done, ") != std::string::npos)
        std::cout << line.substr(0, line.find(';')) << std::endl;
  }


  /** The cells of a table. A quoted one contains no comma here. */
  std::vector<std::vector<std::string>>
  table(const std::string &directory)
  {
    std::vector<std::vector<std::string>> result;
    std::ifstream                         file(directory + "/study.csv");
    for (std::string line; std::getline(file, line);)
      result.push_back(Utilities::split_string_list(line, ','));
    return result;
  }


  /** Print a table without steps, iterations and seconds. */
  void
  print(const std::string &directory)
  {
    for (const auto &line : table(directory))
      {
        for (unsigned int i = 0; i + 3 < line.size(); ++i)
          {
            const auto at = line[i].find(PRM_DIR "/");
            std::cout << (i ? " " : "")
                      << (at == std::string::npos
                            ? line[i]
                            : line[i].substr(0, at) +
                                line[i].substr(at + sizeof(PRM_DIR)));
          }
        std::cout << std::endl;
      }
  }


  /** The largest difference of two outputs in two tables, relative. */
  double
  largest_difference(const std::string &a, const std::string &b)
  {
    const auto first = table(a), second = table(b);
    if (first.size() != second.size())
      return 1;
    double result = 0;
    for (unsigned int l = 1; l < first.size(); ++l)
      for (const unsigned int column : {3, 4})
        result = std::max(
          result,
          std::abs(std::stod(first[l][column]) / std::stod(second[l][column]) -
                   1));
    return result;
  }
} // namespace


int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  if (is_root())
    for (const std::string directory :
         {"grid", "pairs", "cold", "stopped", "failing"})
      std::filesystem::remove_all(directory);
  MPI_Barrier(MPI_COMM_WORLD);

  const std::string grid =
    "set Settings = " + coarse +
    "\nset Variables = p: Stage 1/Pressure, Stage 2/Pressure; "
    "angle: Laminate/Plies[2], -Laminate/Plies[4], Laminate/Plies[6], "
    "-Laminate/Plies[8]\n"
    "set Values = p: 0.12, 0.15; angle: 50:54:3\n"
    "set Outputs = force, strain_energy @ inflation\n";
  write_study("grid.prm", grid);
  write_study("pairs.prm", grid + "set Group size = 2\n");
  write_study("cold.prm", grid + "set Warm start = false\n");
  study("grid.prm", "grid");
  if (is_root())
    print("grid");

  // a single run of one of the samples
  std::vector<std::string> words;
  for (const std::string &setting : Utilities::split_string_list(coarse, ';'))
    {
      words.push_back("--set");
      words.push_back(setting);
    }
  for (const std::string setting :
       {"Stage 1/Pressure=0.15",
        "Laminate/Plies=cord:1.2@50,cord:1.2@-50,cord:1.2@50,cord:1.2@-50"})
    {
      words.push_back("--set");
      words.push_back(setting);
    }
  words.push_back(PRM_DIR "/bias_tire.prm");
  run(words, "single", MPI_COMM_WORLD);
  if (is_root())
    {
      const auto history = read_csv("single/history.csv");
      check_small("force of a single run",
                  std::stod(history.back().at("force")) /
                      std::stod(table("grid")[4][3]) -
                    1,
                  1e-8);
      check_small("its energy at the end of the inflation",
                  std::stod(history.front().at("strain_energy")) /
                      std::stod(table("grid")[4][4]) -
                    1,
                  1e-8);
    }

  study("pairs.prm", "pairs");
  study("cold.prm", "cold");
  if (is_root())
    {
      check_small(
        "in groups of two", largest_difference("grid", "pairs"), 1e-8);
      check_small("without the states of neighbors",
                  largest_difference("grid", "cold"),
                  1e-8);
    }

  // stopped by a signal, and two more samples lost
  study("grid.prm", "stopped", {}, "  2 of 6");
  study("grid.prm", "stopped", {"--restart"});
  if (is_root())
    check_small(
      "stopped and continued", largest_difference("grid", "stopped"), 1e-8);
  const auto before = table("stopped");
  MPI_Barrier(MPI_COMM_WORLD);
  if (is_root())
    {
      std::filesystem::remove("stopped/sample-0002/sample.csv");
      std::filesystem::remove_all("stopped/sample-0005");
    }
  study("grid.prm", "stopped", {"--restart"});
  if (is_root())
    {
      const auto after = table("stopped");
      // the times tell
      for (unsigned int l = 1; l < after.size(); ++l)
        std::cout << "sample " << l
                  << (after[l] == before[l] ? " was kept" : " was run again")
                  << std::endl;
    }
  study("grid.prm", "stopped", {"--restart", "--set", "Stage 2/Travel=9"});
  study("grid.prm", "nowhere", {"--restart"});
  const Ended checked = run({"--study",
                             "--check",
                             "grid.prm",
                             "--set",
                             "Study/Values=p: 0.12, 0.15, 0.16; angle: 50",
                             "--set",
                             "Stage 2/Travel=9"},
                            "nowhere",
                            MPI_COMM_WORLD);
  if (is_root())
    std::cout << "other values: " << checked.err << checked.out;

  write_study("failing.prm",
              "set Settings = " + coarse +
                "; Step control/Maximum cuts=0\n"
                "set Variables = Newton/Maximum iterations; "
                "E: Material cord/E_L\n"
                "set Sampling = list\n"
                "set Values = Newton/Maximum iterations: 25, 1, 25, 25; "
                "E: 500, 500, -1, 520\n"
                "set Outputs = force\nset Warm start = false\n");
  study("failing.prm", "failing");
  if (is_root())
    print("failing");
}
