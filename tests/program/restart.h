// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_tests_program_restart_h
#define biface_tests_program_restart_h

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

/** How a run of the program ended, and what it printed. */
struct Ended
{
  int         code;
  std::string out, err;
};


/** Keeps what is printed, and raises a signal once a text is among it. */
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
 * @param stop_at the text that, once printed, is answered by a signal. */
inline Ended
run(const std::vector<std::string> &words,
    const std::string              &directory,
    const MPI_Comm                  communicator,
    const std::string              &stop_at = "",
    const int                       signal  = SIGTERM)
{
  std::vector<std::string> all{"biface", "--output", directory};
  all.insert(all.end(), words.begin(), words.end());
  std::vector<char *> arguments;
  for (std::string &word : all)
    arguments.push_back(&word[0]);
  arguments.push_back(nullptr);

  SignalAtText       buffer(stop_at, signal);
  std::ostream       out(&buffer);
  std::ostringstream err;
  const int          code =
    Biface::run_program(all.size(), arguments.data(), communicator, out, err);
  return {code, buffer.str(), err.str()};
}


/** What a run said of errors, without the folder of shipped files. */
inline std::string
said(const Ended &ended)
{
  const std::string folder = std::string(PRM_DIR) + "/";
  const auto        at     = ended.err.find(folder);
  return at == std::string::npos
           ? ended.err
           : ended.err.substr(0, at) + ended.err.substr(at + folder.size());
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
 * The greatest difference of two tables, as a fraction of the greatest number
 * of the column, or of all displacements; infinite where they differ in more
 * than numbers. Times do not count.
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

  // distances and sizes by names of columns; displacements are one
  std::map<std::string, std::pair<double, double>> found;
  for (unsigned int row = 0; row < a.size(); ++row)
    for (unsigned int column = 0; column < a[0].size(); ++column)
      {
        const std::string &name = a[0][column];
        const std::string &x = a[row][column], &y = b[row].at(column);
        char              *end    = nullptr;
        const double       number = std::strtod(x.c_str(), &end);
        auto &[distance, size] = found[name.substr(0, 2) == "u_" ? "u" : name];
        if (*end == 0)
          {
            distance = std::max(distance, std::abs(number - std::stod(y)));
            size     = std::max(size, std::abs(number));
          }
        else if (x != y)
          return INFINITY;
      }
  double result = 0;
  for (const auto &[name, values] : found)
    if (name != "seconds" && values.first > 0)
      result = std::max(result, values.first / values.second);
  return result;
}


/** What a file holds. */
inline std::string
text_of(const std::string &path)
{
  std::ifstream      file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}


/** The coarse tire of these tests, of five steps. */
const std::vector<std::string> coarse_tire{
  "--set",
  "Mesh/Intervals alpha_1=-120:120:14",
  "--set",
  "Mesh/Intervals alpha_2=-180:-20:4:smooth,-20:20:6,20:180:4:smooth",
  "--set",
  "Stage 2/Steps=4",
  PRM_DIR "/bias_tire.prm"};


/** More settings, which take precedence. */
inline std::vector<std::string>
with(std::vector<std::string> words, const std::vector<std::string> &settings)
{
  for (const std::string &setting : settings)
    words.insert(words.end() - 1, {"--set", setting});
  return words;
}

#endif
