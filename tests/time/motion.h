// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_tests_motion_h
#define biface_tests_motion_h

#include <algorithm>
#include <cstdlib>
#include <string>
#include <vector>

#include "../read_csv.h"
#include "../restart.h"

/** The tables of a run with inertia. */
struct Motion
{
  std::vector<Row> history, probes;
  /** The sum of the energies at the end of each step. */
  std::vector<double> energy;
};


inline double
number(const Row &row, const std::string &column)
{
  return std::strtod(row.at(column).c_str(), nullptr);
}


/** Run a parameter file with settings, without output for figures.
 * @param words the file, then settings. */
inline Motion
move(std::vector<std::string> words,
     const std::string       &directory,
     const MPI_Comm           communicator)
{
  std::vector<std::string> settings(words.begin() + 1, words.end());
  settings.emplace_back("Output/Write VTU=false");
  const Ended ended = run(with({words[0]}, settings), directory, communicator);
  Motion      motion;
  if (dealii::Utilities::MPI::this_mpi_process(communicator) != 0)
    return motion;
  if (ended.code != 0)
    std::cout << directory << ": " << ended.code << '\n' << said(ended);
  motion.history = read_csv(directory + "/history.csv");
  motion.probes  = read_csv(directory + "/probes.csv");
  for (const Row &row : motion.history)
    motion.energy.push_back(number(row, "kinetic_energy") +
                            number(row, "strain_energy") +
                            number(row, "contact_energy"));
  return motion;
}


/** The largest energy of a motion. */
inline double
largest_energy(const Motion &motion)
{
  return *std::max_element(motion.energy.begin(), motion.energy.end());
}


/** Check that energy and work balance in all steps. */
inline void
check_balance(const Motion &motion, const double bound)
{
  double error = 0;
  for (const Row &row : motion.history)
    error = std::max(error, std::abs(number(row, "energy_error")));
  check_small("balance of energy", error, bound, largest_energy(motion));
}


/** Check that both momenta are constant in a stage. */
inline void
check_momenta(const Motion      &motion,
              const std::string &stage,
              const double       bound)
{
  for (const std::string name : {"momentum_", "angular_momentum_"})
    {
      double change = 0, scale = 0;
      for (const char axis : {'x', 'y', 'z'})
        {
          double low = INFINITY, high = -INFINITY;
          for (const Row &row : motion.history)
            if (row.at("stage") == stage)
              {
                const double value = number(row, name + axis);
                low                = std::min(low, value);
                high               = std::max(high, value);
              }
          change = std::max(change, high - low);
          scale  = std::max({scale, std::abs(low), std::abs(high)});
        }
      check_small(
        "change of " + name.substr(0, name.size() - 1), change, bound, scale);
    }
}


/** Check that energy and both momenta are constant in a stage. */
inline void
check_constants(const Motion      &motion,
                const std::string &stage,
                const double       bound)
{
  double low = INFINITY, high = -INFINITY;
  for (unsigned int i = 0; i < motion.history.size(); ++i)
    if (motion.history[i].at("stage") == stage)
      {
        low  = std::min(low, motion.energy[i]);
        high = std::max(high, motion.energy[i]);
      }
  check_small("change of energy", high - low, bound, high);
  check_momenta(motion, stage, bound);
}

#endif
