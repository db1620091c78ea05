// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_tests_program_restart_h
#define biface_tests_program_restart_h

#include <deal.II/base/mpi.h>
#include <deal.II/base/utilities.h>

#include <algorithm>
#include <cmath>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
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


/** The same, continued. */
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
 * of the column; infinite where they differ in more than numbers. Times do not
 * count.
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
  double result = 0;
  for (unsigned int column = 0; column < a[0].size(); ++column)
    {
      if (a[0][column] == "seconds")
        continue;
      double size = 1e-300, distance = 0;
      for (unsigned int row = 0; row < a.size(); ++row)
        if (a[row][column] != b[row].at(column))
          try
            {
              const double x = std::stod(a[row][column]);
              const double y = std::stod(b[row][column]);
              distance       = std::max(distance, std::abs(x - y));
            }
          catch (const std::invalid_argument &)
            {
              return INFINITY;
            }
      for (unsigned int row = 1; row < a.size(); ++row)
        size = std::max(size,
                        std::abs(std::strtod(a[row][column].c_str(), nullptr)));
      result = std::max(result, distance / size);
    }
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
