// SPDX-License-Identifier: LGPL-2.1-or-later

// A design variable changes the numbers that it names and nothing else, and a
// number that does not exist is refused.

#include <deal.II/base/mpi.h>

#include <iostream>
#include <sstream>

#include <biface/base/errors.h>
#include <biface/problem/design_variable.h>
#include <biface/problem/parameters.h>

using namespace dealii;
using namespace Biface;

namespace
{
  void
  change(const std::string              &variables,
         const std::vector<double>      &values,
         const std::vector<std::string> &base = {})
  {
    std::cout << variables << std::endl;
    try
      {
        const auto parsed = parse_design_variables("Variables", variables);
        const std::vector<Override> overrides(base.begin(), base.end());
        Parameters                  parameters;
        ParameterHandler            prm;
        read_parameters(
          PRM_DIR "/bias_tire.prm", overrides, MPI_COMM_SELF, parameters, prm);
        std::ostringstream from;
        for (const DesignVariable &variable : parsed)
          from << ' ' << variable.get_name() << ' ' << variable.value(prm);
        std::cout << "  from" << from.str() << std::endl;

        std::vector<Override> all = overrides;
        for (const Override &setting : settings(parsed, values, prm, "sample"))
          {
            std::cout << "  " << setting.setting << std::endl;
            all.push_back(setting);
          }
        Parameters       changed;
        ParameterHandler changed_prm;
        read_parameters(
          PRM_DIR "/bias_tire.prm", all, MPI_COMM_SELF, changed, changed_prm);
        std::cout << "  to  ";
        for (const DesignVariable &variable : parsed)
          std::cout << ' ' << variable.get_name() << ' '
                    << variable.value(changed_prm);
        std::cout << std::endl;
        if (changed.laminate.plies.size() != parameters.laminate.plies.size())
          std::cout << "  FAILED: another number of plies" << std::endl;
      }
    catch (const InputError &error)
      {
        std::cout << "  " << error.what() << std::endl;
      }
  }
} // namespace


int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  change("Stage 1/Pressure", {0.1});
  change(
    "p: Stage 1/Pressure, Stage 2/Pressure; R: Surface/Circular arc/Radius",
    {0.1, 48});
  change("angle: Laminate/Plies[2], -Laminate/Plies[4], Laminate/Plies[6], "
         "-Laminate/Plies[8]; inner: Laminate/Plies[1]",
         {50, 1e-3});
  change("stiff: factor of Stage 1/Pressure, Material cord/E_L; "
         "E: Material cord/E_L",
         {0.5, 400});
  change("outer: Mesh/Intervals alpha_1[1]", {-110});

  // the numbers of formulas, and what is none
  change("Laminate/Plies[3]",
         {7},
         {"Laminate/Plies=cord: 1.2 - 0.1 * sin(alpha_1) @ 2*alpha_1-3"});
  change("Contact/Direction[2]", {-1e-20});
  change("Laminate/Plies[3]", {45}, {"Laminate/Plies=2 x (cord: 1.2 @ +-52)"});
  change("Laminate/Plies[2]",
         {-45},
         {"Laminate/Plies=cord: 1.2 @ -+52, cord: 1.2 @ 2 - -10*alpha_1"});
  change("Loads/Point forces[3]",
         {-2},
         {"Named points=P: 0 0", "Loads/Point forces=P: 5 0 -1.5"});

  // what is refused
  change("Stage 1/Presure", {1});
  change("Stage 1/Pressure[2]", {1});
  change("Laminate/Plies", {1});
  change("Laminate/Plies[9]", {1});
  change("Laminate/Plies[0]", {1});
  change("Laminate/Plies[", {1});
  change("Laminate/Plies[1]]", {1});
  change("Surface/Type", {1});
  change("Laminate/Plies[2], Laminate/Plies[4]", {1});
  change("angle: Laminate/Plies[2], Laminate/Plies[4]", {1});
  change("a: factor of -Stage 1/Pressure", {1});
  change("a: Stage 1/Pressure; b: Stage 1/Pressure", {1, 2});
  change("a: Stage 1/Pressure; a: Stage 2/Pressure", {1, 2});
  change(": Stage 1/Pressure", {1});
  change("a:", {1});
  change("-", {1});
  change("Stage 1//Pressure", {1});
  change("Stage 1/Steps", {1.5});
}
