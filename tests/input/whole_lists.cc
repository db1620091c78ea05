// SPDX-License-Identifier: LGPL-2.1-or-later

// A list is read as a whole, also over lines with comments; one that ends with
// a separator or has an empty item is refused.

#include <deal.II/base/mpi.h>

#include <fstream>
#include <string>
#include <utility>
#include <vector>

#include <biface/base/errors.h>
#include <biface/problem/parameters.h>

#include "../tests.h"

using namespace Biface;

namespace
{
  Parameters
  read(const std::string &text, const std::vector<Override> &settings = {})
  {
    Parameters               parameters;
    dealii::ParameterHandler prm;
    std::ofstream("lists.prm") << "set Named points = P: 0 0\nsubsection Mesh\n"
                                  "  set Closed in alpha_2 = false\nend\n"
                                  "subsection Material cord\n  set E = 1\nend\n"
                               << text;
    read_parameters("lists.prm", settings, MPI_COMM_SELF, parameters, prm);
    return parameters;
  }


  /** Two plies by lines of a file, and an entry behind them. */
  void
  check_plies(const std::string &how, const std::string &plies)
  {
    std::string said;
    bool        whole = false;
    try
      {
        const Parameters parameters =
          read("subsection Laminate\n" + plies +
               "\n  set Reference surface = outer\nend\n");
        const auto &read_plies = parameters.laminate.plies;
        whole = read_plies.size() == 2 && read_plies[1].material == "cord" &&
                parameters.laminate.reference.value == 1;
      }
    catch (const InputError &error)
      {
        said = error.what();
      }
    check_true(how + said, whole);
  }


  bool
  is_refused(const std::string &setting)
  {
    try
      {
        read("", {setting});
        return false;
      }
    catch (const InputError &)
      {
        return true;
      }
  }
} // namespace


int
main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  const std::string first  = "  set Plies = cord: 1 @ 0,",
                    second = "              cord: 2 @ 0";
  check_plies("joined lines", first + " \\\n" + second);
  check_plies("a backslash in a comment", first + "  # inner \\\n" + second);
  check_plies("a backslash before a comment",
              first + " \\ # inner\n" + second + " # outer");
  check_plies("a comment between the lines",
              first + " \\\n  # outer\n" + second);
  check_plies("comments with backslashes",
              first + "# inner \\\n  # outer \\\n" + second);
  check_plies("blanks after a backslash", first + "# inner \\ \t\n" + second);
  check_plies("lines of Windows", first + "  # inner \\\r\n" + second + "\r");
  check_plies("a comment alone with a backslash",
              "  # in C:\\plies\\\n" + first + " cord: 2 @ 0");

  std::ofstream("table.csv") << "0, 1\n1, 1\n";
  const std::vector<std::pair<std::string, std::string>> lists{
    {"Mesh/Intervals alpha_1", "0:1:1"},
    {"Materials", "cord"},
    {"Laminate/Plies", "cord: max(1, 2) @ 0"},
    {"Laminate/Tables", "t: table.csv"},
    {"Laminate/Initial ply stresses", "0 0 0,0 0 0,0 0 0,0 0 0"},
    {"Named points", "P: 0 0"},
    {"Supports/Point supports", "P: fixed"},
    {"Loads/Point forces", "P: 1 2 3"},
    {"Loads/Edge forces", "alpha_1 min: 1 2 3"},
    {"Loads/Edge moments", "alpha_1 min: 1 dead"},
    {"Loads/Area force", "0, 0, 1"},
    {"Supports/alpha_1 min", "v_1 both; v_2 both"},
    {"Loads/Inner traction", "1; 2; 3"}};
  for (const auto &[entry, list] : lists)
    {
      const std::string setting = entry + "=" + list,
                        end = list.find(';') == std::string::npos ? "," : ";";
      check_true(entry, !is_refused(setting));
      check_true(entry + " must not end with a separator",
                 is_refused(setting + end));
      check_true(entry + " must not have an empty item",
                 is_refused(entry + "=" + list + end + end + list));
    }
  return 0;
}
