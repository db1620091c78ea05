// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_tests_restart_h
#define biface_tests_restart_h

#include <deal.II/base/mpi.h>
#include <deal.II/base/utilities.h>

#include <algorithm>
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include <biface/program/program.h>

#include "tests.h"

/** The exit code of a run of the program, and its output. */
struct Ended
{
  int         code;
  std::string out, err;
};


/** Keeps the output, and raises a signal once it contains a text. */
class SignalAtText : public std::stringbuf
{
public:
  SignalAtText(const std::string &text, const int signal)
    : text(text), signal(signal)
  {}

protected:
  int
  sync() override
  {
    if (!text.empty() && str().find(text) != std::string::npos)
      {
        text.clear();
        std::raise(signal);
      }
    return std::stringbuf::sync();
  }

private:
  std::string text;
  const int   signal;
};


/** Run the program with results in a directory.
 * @param stop_at the text that triggers the signal. */
inline Ended
run(const std::vector<std::string> &words,
    const std::string              &directory,
    const MPI_Comm                  communicator,
    const std::string              &stop_at = "",
    const int                       signal  = SIGTERM)
{
  std::vector<std::string> arguments{"--output", directory};
  arguments.insert(arguments.end(), words.begin(), words.end());

  SignalAtText       buffer(stop_at, signal);
  std::ostream       out(&buffer);
  std::ostringstream err;
  const int code = Biface::run_program(arguments, communicator, out, err);
  return {code, buffer.str(), err.str()};
}


/** The error messages of a run, without the folders of shipped files. */
inline std::string
said(const Ended &ended)
{
  std::string text = ended.err;
  for (const std::string folder : {PRM_DIR "/", DATA_DIR "/"})
    {
      const auto at = text.find(folder);
      if (at != std::string::npos)
        text.erase(at, folder.size());
    }
  return text;
}


/** Continue a run, see run(). */
inline Ended
restart(std::vector<std::string> words,
        const std::string       &directory,
        const MPI_Comm           communicator)
{
  words.insert(words.begin(), "--restart");
  return run(words, directory, communicator);
}


inline std::vector<std::vector<std::string>>
read_table(const std::string &path)
{
  std::vector<std::vector<std::string>> rows;
  std::ifstream                         file(path);
  std::string                           line;
  while (std::getline(file, line))
    rows.push_back(dealii::Utilities::split_string_list(line, ','));
  return rows;
}


/**
 * The maximum difference of two tables, relative to the maximum of the column
 * or of all components; infinite if they differ in more than numbers. Times
 * are ignored.
 */
inline double
difference(const std::string &file,
           const std::string &directory,
           const std::string &other)
{
  const auto a = read_table(directory + "/" + file);
  const auto b = read_table(other + "/" + file);
  if (a.size() != b.size() || a.size() < 2)
    return INFINITY;

  // distances and sizes by column name; displacements are one column
  std::map<std::string, std::pair<double, double>> found;
  for (unsigned int row = 0; row < a.size(); ++row)
    for (unsigned int column = 0; column < a[0].size(); ++column)
      {
        const std::string &name = a[0][column];
        const std::string &x = a[row][column], &y = b[row].at(column);
        char              *end    = nullptr;
        const double       number = std::strtod(x.c_str(), &end);
        // components of displacements, forces and moments
        auto &[distance, size] =
          found[name.size() == 3 && name[1] == '_' ? name.substr(0, 1) : name];
        // fields may be empty
        if (*end == 0 && !x.empty() && !y.empty())
          {
            distance = std::max(distance, std::abs(number - std::stod(y)));
            size     = std::max(size, std::abs(number));
          }
        else if (x != y)
          return INFINITY;
      }
  double result = 0;
  for (const auto &[name, values] : found)
    // on other ranks round-off decides about the last iteration, and is what
    // differences of works consist of
    if (name != "seconds" && name != "iterations" && name != "energy_error" &&
        name != "contact_work" && values.first > 0)
      result = std::max(result, values.first / values.second);
  return result;
}


/** The contents of a file. */
inline std::string
text_of(const std::string &path)
{
  std::ifstream      file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}


/** The coarse tire of these tests, with five steps. */
inline const std::vector<std::string> coarse_tire{
  "--set",
  "Mesh/Intervals alpha_1=-120:120:14",
  "--set",
  "Mesh/Intervals alpha_2=-180:-20:4:smooth,-20:20:6,20:180:4:smooth",
  "--set",
  "Stage 2/Steps=4",
  PRM_DIR "/bias_tire.prm"};


/** Add settings, which take precedence. */
inline std::vector<std::string>
with(std::vector<std::string> words, const std::vector<std::string> &settings)
{
  for (const std::string &setting : settings)
    words.insert(words.end() - 1, {"--set", setting});
  return words;
}


inline const std::string no_vtu = "Output/Write VTU=false";

/** coarse_tire on ground softer than the default: round-off in clearances
 * affects the forces less, and ranks agree in more digits. */
inline const std::vector<std::string> soft_tire =
  with(coarse_tire, {"Contact/Regularization=1e3"});


inline bool
is_root()
{
  return dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0;
}


/** Run on the first rank alone or on all ranks. */
template <typename Function>
int
on(const bool all, const Function &function)
{
  int code = 0;
  if (all)
    code = function(MPI_COMM_WORLD).code;
  else if (is_root())
    code = function(MPI_COMM_SELF).code;
  MPI_Barrier(MPI_COMM_WORLD);
  return code;
}


/** Stop before a step on one rank and continue on all, then the other way
 * round. */
inline void
check_restart(const std::string              &name,
              const std::vector<std::string> &words,
              const unsigned int              step)
{
  const std::string whole = "whole", cut = "cut";
  const std::string stop_at = "Step " + std::to_string(step) + ",";
  on(false, [&](const MPI_Comm communicator) {
    std::filesystem::remove_all(whole);
    return run(words, whole, communicator);
  });
  for (const bool all_ranks : {false, true})
    {
      if (is_root())
        std::filesystem::remove_all(cut);
      MPI_Barrier(MPI_COMM_WORLD);
      const int stopped = on(all_ranks, [&](const MPI_Comm communicator) {
        return run(words, cut, communicator, stop_at);
      });
      const unsigned int n_before = read_table(cut + "/history.csv").size();
      MPI_Barrier(MPI_COMM_WORLD);
      const int continued = on(!all_ranks, [&](const MPI_Comm communicator) {
        return restart(words, cut, communicator);
      });
      if (!is_root())
        continue;
      std::cout << name
                << (all_ranks ? ", 2 ranks, then 1" : ", 1 rank, then 2")
                << ": " << stopped << ", " << n_before - 1 << " steps, "
                << continued << '\n';
      check_small("  history", difference("history.csv", whole, cut), 1e-9);
      check_small("  forces", difference("forces.csv", whole, cut), 1e-8);
      if (std::filesystem::exists(whole + "/probes.csv"))
        check_small("  probes", difference("probes.csv", whole, cut), 1e-9);
      // those of forces agree in as many digits as forces
      if (std::filesystem::exists(whole + "/sensitivities.csv"))
        check_small(
          "  derivatives", difference("sensitivities.csv", whole, cut), 1e-8);
    }
}

#endif
