// SPDX-License-Identifier: LGPL-2.1-or-later

// Tables of numbers, plies and samples separated by semicolons, tabs or blanks,
// with decimal commas, comments and names of columns are the same as with
// commas and decimal points; mixtures and other columns are refused with a
// sentence that names the separators.

#include <deal.II/base/mpi.h>

#include <fstream>
#include <string>
#include <vector>

#include <biface/base/errors.h>
#include <biface/input/read_file.h>
#include <biface/laminate/layup.h>
#include <biface/study/sampling.h>

#include "../tests.h"

using namespace Biface;

namespace
{
  void
  tables_of_numbers()
  {
    const std::vector<dealii::Point<2>> expected{
      {60, 0}, {66.5, 20}, {-4, 1e3}};
    for (const std::string text : {"60,0\n66.5,20\n-4,1e3\n",
                                   "r,z\n60, 0\n66.5, 20\n-4, 1e3\n",
                                   "60;0\n66.5;20\n-4;1e3\n",
                                   "% measured\nr;z\n60;0\n66,5;20\n-4;1e3\n",
                                   "60,0;0,0\n66,5;20,0\n-4,0;1,0e3\n",
                                   "r\tz\n60\t0\n66.5\t20\n-4\t1e3\n",
                                   "# measured\n60,0\t0,0\n66,5\t20\n-4\t1e3\n",
                                   "60 0\n66.5   20\n -4 \t1e3\n",
                                   "r z\n60,0 0,0\n66,5 20,0\n-4 1000,0\n"})
      if (parse_pairs(text, "points.csv", "r, z") != expected)
        std::cout << "not as expected: " << text << std::endl;

    for (const std::string text : {"60,0,0\n",
                                   "60\n",
                                   "60;0\n66,5;20\n67.5;20\n",
                                   "60;0\n66,;20\n",
                                   "60;0\n66,5,1;20\n",
                                   "60;0\n61 1\n",
                                   "60|0\n",
                                   "r;z\n60;0\n61;0;0\n",
                                   "60;0\nr;z\n"})
      try
        {
          parse_pairs(text, "points.csv", "r, z");
          std::cout << "accepted: " << text << std::endl;
        }
      catch (const InputError &error)
        {
          std::cout << error.what() << std::endl;
        }
  }


  void
  plies()
  {
    const std::string expected = "cord: 1.2 @ max(1, 2), rubber: 3 @ 0";
    for (const std::string text :
         {"material,thickness,angle\ncord,1.2,max(1, 2)\nrubber,3,0,,\n",
          "material;thickness;angle\ncord;1,2;max(1, 2)\nrubber;3;0;;\n",
          "cord;1.2;max(1, 2)\nrubber;3;0\n",
          "cord\t1,2\tmax(1, 2)\nrubber\t3\t0\t\t\n",
          "cord,\t1.2,\tmax(1, 2)\nrubber,\t3,\t0\n"})
      if (plies_of_csv(text, "plies.csv") != expected)
        std::cout << "not as expected: " << plies_of_csv(text, "plies.csv")
                  << std::endl;
  }


  void
  samples()
  {
    Sampling sampling;
    sampling.type = Sampling::Type::file;
    for (const std::string name : {"p: Stage 1/Pressure", "E: Material cord/E"})
      sampling.variables.emplace_back("Study/Variables", name);
    sampling.file_name = "samples.csv";
    const std::vector<std::vector<double>> expected{{0.1, 5}, {0.25, 6}};
    for (const std::string text : {"E,p\n5,0.1\n6,0.25\n",
                                   "E;p\n5;0,1\n6;0,25\n",
                                   "E;p\n5;0.1\n6;0.25\n",
                                   "E\tp\n5,0\t0,1\n6\t0,25\n"})
      {
        std::ofstream(sampling.file_name) << text;
        if (sampling.samples(".", MPI_COMM_SELF) != expected)
          std::cout << "not as expected: " << text << std::endl;
      }
  }
} // namespace


int
main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  tables_of_numbers();
  plies();
  samples();
  std::cout << "tried" << std::endl;
}
