// SPDX-License-Identifier: LGPL-2.1-or-later

// Runs the program on a parameter file and compares displacements with
// published values, which stand in comments of the file:
//   # expect: NAME FACE COLUMN at LOAD_FACTOR is VALUE within FRACTION
// for a point and a column of probes.csv;
//   # expect: greatest load factor is VALUE within FRACTION
//   # expect: least load factor is VALUE within FRACTION
// for the first maximum of a path, and the minimum after it;
//   # expect: at most N iterations
// for all steps together.

#include <deal.II/base/mpi.h>
#include <deal.II/base/utilities.h>

#include <fstream>
#include <iostream>
#include <map>
#include <sstream>
#include <vector>

#include <biface/program/program.h>

#include "../tests.h"

using namespace dealii;

namespace
{
  using Row = std::map<std::string, std::string>;

  std::vector<Row>
  read_csv(const std::string &name)
  {
    std::vector<Row>         rows;
    std::vector<std::string> header;
    std::ifstream            file(name);
    std::string              line;
    while (std::getline(file, line))
      {
        const auto cells = Utilities::split_string_list(line, ',');
        if (header.empty())
          header = cells;
        else
          {
            Row row;
            for (unsigned int i = 0; i < header.size(); ++i)
              row[header[i]] = cells[i];
            rows.push_back(row);
          }
      }
    return rows;
  }


  /** The turning point of y over the index, by a parabola through the three
   * values around i. */
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

  std::vector<std::string> words{"biface", "--output", "results", argv[1]};
  std::vector<char *>      arguments;
  for (std::string &word : words)
    arguments.push_back(&word[0]);
  arguments.push_back(nullptr);
  std::ostringstream out;
  const int          code = Biface::run_program(
    words.size(), arguments.data(), MPI_COMM_WORLD, out, std::cout);
  if (Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) != 0)
    return 0;
  std::cout << "exit code: " << code << std::endl;

  const auto          probes  = read_csv("results/probes.csv");
  const auto          history = read_csv("results/history.csv");
  std::vector<double> factors(1, 0.);
  unsigned int        n_iterations = 0;
  for (const Row &row : history)
    {
      factors.push_back(std::stod(row.at("load_factor")));
      n_iterations += std::stoi(row.at("iterations"));
    }

  std::ifstream file(argv[1]);
  std::string   line;
  while (std::getline(file, line))
    {
      if (line.rfind("# expect: ", 0) != 0)
        continue;
      std::istringstream       stream(line.substr(10));
      std::vector<std::string> w;
      for (std::string word; stream >> word;)
        w.push_back(word);

      if (w[0] == "at")
        check_true("iterations " + w[0] + " " + w[1] + " " + w[2],
                   n_iterations <= std::stoul(w[2]));
      else if (w[1] == "load")
        {
          const double sign  = (w[0] == "greatest" ? 1 : -1);
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
          bool found = false;
          for (const Row &row : probes)
            if (row.at("name") == w[0] && row.at("face") == w[1] &&
                std::abs(std::stod(row.at("load_factor")) - std::stod(w[4])) <
                  1e-9)
              {
                compare(w[0] + " " + w[1] + " " + w[2] + " at " + w[4],
                        std::stod(row.at(w[2])),
                        std::stod(w[6]),
                        std::stod(w[8]));
                found = true;
              }
          check_true("found in probes.csv", found);
        }
    }
}
