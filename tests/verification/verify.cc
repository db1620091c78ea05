// SPDX-License-Identifier: LGPL-2.1-or-later

// Runs the program on a parameter file and compares results with published
// values, given in comments of the file:
//   # expect: NAME FACE COLUMN at WHEN is VALUE within FRACTION
//   # expect: history COLUMN at WHEN is VALUE within FRACTION
//   # expect: plies NAME PLY PLACE COLUMN at WHEN is VALUE within FRACTION
//   # expect: modes MODE COLUMN at WHEN is VALUE within FRACTION
//   # expect: buckling MODE COLUMN at WHEN is VALUE within FRACTION
//   # expect: critical_points KIND COLUMN at WHEN is VALUE within FRACTION
// for a column of probes.csv, history.csv, plies-NNNN.csv (PLACE is its column
// 'fraction'), modes.csv, buckling.csv or critical_points.csv (the first limit
// point or bifurcation of the stage), where WHEN is a load factor or 'end
// of STAGE';
//   # expect: maximum load factor is VALUE within FRACTION
//   # expect: minimum load factor is VALUE within FRACTION
// for the first maximum of a path, and the minimum after it;
//   # expect: at most N iterations
// summed over all steps;
//   # file: a parameter file to run instead of this one
// where {PRM} is the folder of the shipped files.

#include <deal.II/base/mpi.h>
#include <deal.II/base/utilities.h>

#include <fstream>
#include <iostream>
#include <optional>
#include <regex>
#include <sstream>
#include <vector>

#include <biface/program/program.h>

#include "../read_csv.h"
#include "../tests.h"

using namespace dealii;

namespace
{
  /** The last row of history.csv of a stage ('end of STAGE') or with a given
   * load factor; null if there is none. */
  const Row *
  find_step(const std::vector<Row> &history, const std::string &when)
  {
    const std::string end_of = "end of ";
    const Row        *found  = nullptr;
    for (const Row &row : history)
      if (when.rfind(end_of, 0) == 0
            ? row.at("stage") == when.substr(end_of.size())
            : std::abs(std::stod(row.at("load_factor")) - std::stod(when)) <
                1e-9)
        found = &row;
    return found;
  }


  /** The value of a column at a step, as named by the words; empty if it does
   * not exist. */
  std::optional<double>
  find_value(const Row &step, const std::vector<std::string> &words)
  {
    if (words[0] == "history")
      return std::stod(step.at(words[1]));

    if (words[0] == "modes" || words[0] == "buckling")
      {
        for (const Row &row : read_csv("results/" + words[0] + ".csv"))
          if (row.at("step") == step.at("step") && row.at("mode") == words[1])
            return std::stod(row.at(words[2]));
        return {};
      }

    if (words[0] == "critical_points")
      {
        for (const Row &row : read_csv("results/critical_points.csv"))
          if (row.at("stage") == step.at("stage") &&
              row.at("kind").substr(0, words[1].size()) == words[1])
            return std::stod(row.at(words[2]));
        return {};
      }

    const bool of_plies = (words[0] == "plies");
    const auto number   = std::stoul(step.at("step"));
    const auto rows     = read_csv(
      of_plies ? "results/plies-" + Utilities::int_to_string(number, 4) + ".csv"
               : "results/probes.csv");
    for (const Row &row : rows)
      if (of_plies ? row.at("name") == words[1] && row.at("ply") == words[2] &&
                       row.at("fraction") == words[3]
                   : row.at("step") == step.at("step") &&
                       row.at("name") == words[0] && row.at("face") == words[1])
        return std::stod(row.at(words[of_plies ? 4 : 2]));
    return {};
  }


  /** The extremum of the parabola through the three values of y around i. */
  double
  turning_value(const std::vector<double> &y, const unsigned int i)
  {
    const double slope     = (y[i + 1] - y[i - 1]) / 2;
    const double curvature = y[i + 1] - 2 * y[i] + y[i - 1];
    return y[i] - slope * slope / (2 * curvature);
  }


  void
  compare(const std::string &what,
          const double       value,
          const double       reference,
          const double       fraction)
  {
    std::ostringstream text;
    text << what << " against " << reference;
    check_small(text.str(), value - reference, fraction, std::abs(reference));
  }
} // namespace


int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  std::string   parameter_file = argv[1];
  std::ifstream file(argv[1]);
  std::string   line;
  while (std::getline(file, line))
    if (line.rfind("# file: {PRM}", 0) == 0)
      parameter_file = PRM_DIR + line.substr(13);
  file.clear();
  file.seekg(0);

  std::ostringstream out;
  const int          code = Biface::run_program(
    {"--output", "results", parameter_file}, MPI_COMM_WORLD, out, std::cout);
  if (Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) != 0)
    return 0;
  std::cout << "exit code: " << code << std::endl;

  const auto          history = read_csv("results/history.csv");
  std::vector<double> factors(1, 0.);
  unsigned int        n_iterations = 0;
  for (const Row &row : history)
    {
      factors.push_back(std::stod(row.at("load_factor")));
      n_iterations += std::stoi(row.at("iterations"));
    }

  while (std::getline(file, line))
    {
      if (line.rfind("# expect: ", 0) != 0)
        continue;
      const std::string        text = line.substr(10);
      std::istringstream       stream(text);
      std::vector<std::string> w;
      for (std::string word; stream >> word;)
        w.push_back(word);

      if (w[0] == "at")
        check_true("iterations " + w[0] + " " + w[1] + " " + w[2],
                   n_iterations <= std::stoul(w[2]));
      else if (w[1] == "load")
        {
          const double sign  = (w[0] == "maximum" ? 1 : -1);
          bool         found = false;
          for (unsigned int i = 1; i + 1 < factors.size() && !found; ++i)
            if (sign * factors[i] > sign * factors[i - 1] &&
                sign * factors[i] >= sign * factors[i + 1])
              {
                compare(w[0] + " load factor",
                        turning_value(factors, i),
                        std::stod(w[4]),
                        std::stod(w[6]));
                found = true;
              }
          check_true("a turning point", found);
        }
      else
        {
          std::smatch match;
          if (!std::regex_match(
                text, match, std::regex("(.*) at (.*) is (.*) within (.*)")))
            {
              check_true("understood: " + text, false);
              continue;
            }
          const Row            *step = find_step(history, match[2]);
          std::optional<double> value;
          if (step != nullptr)
            value = find_value(*step, w);
          if (value)
            compare(match[1].str() + " at " + match[2].str(),
                    *value,
                    std::stod(match[3]),
                    std::stod(match[4]));
          const std::string file_name =
            (w[0] == "history" || w[0] == "plies" || w[0] == "modes" ||
                 w[0] == "buckling" || w[0] == "critical_points"
               ? w[0]
               : "probes");
          check_true("found in " + file_name + ".csv", value.has_value());
        }
    }
}
