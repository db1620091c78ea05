// SPDX-License-Identifier: LGPL-2.1-or-later

// A separator may follow the last item of any list, but items must not be
// empty.

#include <deal.II/base/mpi.h>

#include <fstream>
#include <string>
#include <utility>
#include <vector>

#include <biface/base/errors.h>
#include <biface/problem/parameters.h>

#include "../tests.h"

using namespace Biface;

int
main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  std::ofstream("table.csv") << "0, 1\n1, 1\n";
  const auto read = [](const std::string &setting) {
    Parameters               parameters;
    dealii::ParameterHandler prm;
    std::ofstream("trailing_commas.prm")
      << "set Named points = P: 0 0\nsubsection Mesh\n"
         "  set Closed in alpha_2 = false\nend\n"
         "subsection Material cord\n  set E = 1\nend\n";
    read_parameters(
      "trailing_commas.prm", {setting}, MPI_COMM_SELF, parameters, prm);
  };

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
    {"Loads/Area force", "0, 0, 1"}};
  for (const auto &list : lists)
    {
      std::string said;
      try
        {
          read(list.first + "=" + list.second + ",");
        }
      catch (const InputError &error)
        {
          said = error.what();
        }
      check_true(list.first + " may end with a comma" + said, said.empty());
      bool refused = false;
      try
        {
          read(list.first + "=" + list.second + ",,");
        }
      catch (const InputError &)
        {
          refused = true;
        }
      check_true(list.first + " must not have an empty item", refused);
    }
  return 0;
}
