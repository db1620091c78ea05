// SPDX-License-Identifier: LGPL-2.1-or-later

// Files far larger than any sensible input are refused with one short sentence.

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <fstream>
#include <sstream>
#include <string>

#include <biface/program/program.h>

#include "../tests.h"

using namespace dealii;

namespace
{
  std::string
  repeated(const std::string &text, const unsigned int n)
  {
    std::string result;
    for (unsigned int i = 0; i < n; ++i)
      result += text;
    return result;
  }


  void
  try_file(const std::string &what,
           const std::string &text,
           const std::string &csv = "")
  {
    std::ofstream("huge.prm") << text;
    std::ofstream("huge.csv") << csv;
    std::ostringstream out, err;
    const int          code =
      Biface::run_program({"--check", "huge.prm"}, MPI_COMM_WORLD, out, err);
    const std::string said = err.str();
    check_true(what,
               code == Biface::wrong_input && said.size() < 1500 &&
                 std::count(said.begin(), said.end(), '\n') == 1);
  }
} // namespace


int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  const unsigned int n = 5000000;
  try_file("a line of 5 MB", std::string(n, 'x'));
  try_file("a value of 5 MB",
           "subsection Stage 1\nset Pressure = " + std::string(n, '1') +
             "x\nend");
  try_file("the name of an entry of 5 MB",
           "set " + std::string(n, 'x') + " = 1");
  try_file("the name of a section of 5 MB, with many lines",
           "subsection " + std::string(n, 'x') + "\n" +
             repeated("set a = 1\n", 10000));
  try_file("100000 entries that do not exist", [] {
    std::string text;
    for (unsigned int i = 0; i < 100000; ++i)
      text += "set entry " + std::to_string(i) + " = 1\n";
    return text;
  }());
  try_file("100000 sections within each other",
           repeated("subsection a\n", 100000));
  try_file("a million materials", "set Materials = " + repeated("a,", 1000000));
  try_file("a million plies",
           "subsection Laminate\nset Plies = " +
             repeated("cord: 1 @ 0, ", 1000000) + "cord: 1 @ 0\nend");
  const std::string material =
    "subsection Material cord\nset Type = isotropic\nset E = 1\nend\n";
  try_file("a million points",
           material + "set Named points = " + repeated("A: 0 0, ", 1000000));
  try_file("a million intervals",
           "subsection Mesh\nset Intervals alpha_1 = " +
             repeated("0:1:9, ", 1000000) + "\nend");
  const std::string points =
    "subsection Surface\nset Meridian = spline\nsubsection Spline\n"
    "set File = huge.csv\nend\nend\n";
  try_file(
    "a meridian of a million points", points, repeated("1, 2\n", 1000000));
  try_file("a million columns in a table", points, repeated("1,", 1000000));
  try_file("a line of 5 MB in a table", points, std::string(n, '1'));
  return 0;
}
