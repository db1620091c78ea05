// SPDX-License-Identifier: LGPL-2.1-or-later

// Each name of an entry, of a section and of a choice that was in use before
// gives the same parameters as its new one, in a file and with --set, and is
// answered once.

#include <deal.II/base/mpi.h>

#include <fstream>
#include <string>
#include <vector>

#include <biface/problem/parameters.h>

#include "../tests.h"

using namespace Biface;

namespace
{
  std::string
  file(const bool old)
  {
    const auto name = [&](const std::string &before, const std::string &now) {
      return old ? before : now;
    };
    return "set Number of stages = 2\n"
           "subsection Surface\n  set Meridian = " +
           name("points", "spline") + "\n  subsection " +
           name("Points", "Spline") +
           "\n    set File = meridian.csv\n  end\nend\nset " +
           name("Points", "Named \\\npoints") +
           " = mean: 0 0, \\\n  middle: 0 90\n"
           "subsection Supports\n  set alpha_1 min = v_1 both; v_3 " +
           name("mean", "middle") + " = 0.5\n  set " +
           name("Points", "Point supports") + " = mean: v_1 " +
           name("mean", "middle") +
           "\nend\nsubsection Loads\n  set Pressure face = outer\n  set " +
           name("Pressure", "Pressure type") +
           " = follower\n  set Area of face loads = " +
           name("midway", "middle") + "\nend\nsubsection Contact\n  set " +
           name("Plane normal", "Direction") +
           " = 0, 0, 1\nend\nsubsection Stage 1\n  set Load factor = 1\nend\n"
           "subsection Stage 2\n  set " +
           name("Begin", "Start") +
           " from prestress = true\nend\nsubsection Step control\n  set " +
           name("Greatest", "Maximum") + " growth = 3\nend\n";
  }


  std::vector<std::string>
  read(const bool                   old,
       const std::vector<Override> &overrides,
       std::string                 &printed)
  {
    std::ofstream("old_names.prm") << file(old);
    Parameters                     parameters;
    dealii::ParameterHandler       prm;
    const std::vector<std::string> sentences = parse_parameters(
      "old_names.prm", overrides, MPI_COMM_SELF, parameters, prm);
    printed = print_parameters(prm);
    return sentences;
  }
} // namespace


int
main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  std::ofstream("meridian.csv") << "10, 0\n12, 5\n10, 10\n";

  std::string with_old, with_new;
  const auto  sentences =
    read(true, {"Stage 1/Begin from prestress=false"}, with_old);
  check_true("new names are not answered", read(false, {}, with_new).empty());
  check_true("the parameters are the same", with_old == with_new);
  check_true("they are printed with the new names",
             with_new.find("Plane normal") == std::string::npos &&
               with_new.find("set Direction") != std::string::npos);
  for (const std::string &sentence : sentences)
    std::cout << sentence << std::endl;

  check_true("--set knows old names",
             read(false, {"Contact/Plane normal=0,0,1"}, with_old).size() == 1);
  return 0;
}
