// SPDX-License-Identifier: LGPL-2.1-or-later

// Tables of numbers, plies and samples separated by semicolons, tabs or blanks,
// with decimal commas, comments, names of columns in any order, units and
// quotes are the same as with commas and decimal points; mixtures, other
// columns, and what has two meanings, are refused with a sentence that names
// the separators or the unit.

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
                                   "r z\n60,0 0,0\n66,5 20,0\n-4 1000,0\n",
                                   "z,r\n0,60\n20,66.5\n1e3,-4\n",
                                   "sep=;\n\"z\";\"r\"\n0;\"60\"\n20;66,5\n"
                                   "1000;-4\n;\n",
                                   "r [mm]\tz [mm]\n60\t0\n66.5\t20\n-4\t1e3\n",
                                   "r;z\n[mm];mm\n60;0\n66,500;20\n-4;0,1e4\n"})
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
                                   "60;0\nr;z\n",
                                   "60,125;1,250\n-4;2\n",
                                   "r;z\nmm;Hz\n60;0\n"})
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
  meridians()
  {
    const std::vector<dealii::Point<2>> expected{{60, 0}, {66.5, 20}};
    const auto parse = [](const std::string &header, const bool is_swapped) {
      return parse_pairs(header +
                           (is_swapped ? "0,60\n20,66.5\n" : "60,0\n66.5,20\n"),
                         "meridian.csv",
                         "radius, axial coordinate",
                         "mm");
    };
    for (const std::string header : {"",
                                     "r,z\n",
                                     "x,y\n",
                                     "X [mm],Z [mm]\n",
                                     "radius,width\n",
                                     "P,Q\n",
                                     "r (outer),s\n"})
      if (parse(header, false) != expected)
        std::cout << "not as expected: " << header << std::endl;
    for (const std::string header :
         {"z,r\n", "y,x\n", "x,r\n", "Axial [mm],Radius [mm]\n", "s,R\n"})
      if (parse(header, true) != expected)
        std::cout << "not in order: " << header << std::endl;
    for (const std::string header :
         {"y,z\n", "z,y\n", "r [m],z [m]\n", "r,z\ncm,cm\n"})
      try
        {
          parse(header, false);
          std::cout << "accepted: " << header << std::endl;
        }
      catch (const InputError &error)
        {
          std::cout << error.what() << std::endl;
        }

    const std::vector<std::vector<double>> rows{{1, 2, 3}};
    for (const std::string text : {"u,v,height\n1,2,3\n",
                                   "height,u,v\n3,1,2\n",
                                   "a,b,c\n1,2,3\n",
                                   "x,y,height\n1,2,3\n",
                                   "height,v,x\n3,2,1\n"})
      if (parse_rows(text, "heights.csv", "", 3, 3, {"u", "v", "height"}) !=
          rows)
        std::cout << "not in order: " << text << std::endl;
    try
      {
        parse_rows("height,x,y\n3,1,2\n",
                   "heights.csv",
                   "each line must contain 'u, v, height'",
                   3,
                   3,
                   {"u", "v", "height"});
        std::cout << "accepted" << std::endl;
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
          "Material,Thickness [mm],Angle (deg)\ncord,1.2,max(1, 2)\n"
          "rubber,3,0\n",
          "material;thickness;angle\ncord;1,2;max(1, 2)\nrubber;3;0;;\n",
          "cord;1.2;max(1, 2)\nrubber;3;0\n",
          "cord\t1,2\tmax(1, 2)\nrubber\t3\t0\t\t\n",
          "cord,\t1.2,\tmax(1, 2)\nrubber,\t3,\t0\n"})
      if (plies_of_csv(text, "plies.csv") != expected)
        std::cout << "not as expected: " << plies_of_csv(text, "plies.csv")
                  << std::endl;
    // columns in another order
    for (const std::string text :
         {"material,thickness,from,to,angle\ncord,1.2,0,10,20\n",
          "material,angle,thickness\ncord,20,1.2\n"})
      try
        {
          const std::string plies = plies_of_csv(text, "plies.csv");
          std::cout << "accepted: " << plies << std::endl;
        }
      catch (const InputError &error)
        {
          std::cout << error.what() << std::endl;
        }
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
  meridians();
  plies();
  samples();
  std::cout << "tried" << std::endl;
}
