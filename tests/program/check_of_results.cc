// SPDX-License-Identifier: LGPL-2.1-or-later

// The check at the end of a run on a tube whose wall is a membrane: the
// pressure on the footprint carries the force, the wall nothing; the cells are
// those in contact, the penetration is that of the pressure, and the forces are
// in balance. Loads that balance themselves are the scale of round-off.

#include <deal.II/base/mpi.h>

#include <regex>
#include <sstream>
#include <string>

#include <biface/program/program.h>

#include <read_csv.h>
#include <tests.h>

using namespace dealii;

int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  std::ostringstream out, err;
  Biface::run_program({"--output",
                       "results",
                       "--set",
                       "Contact/Regularization=1e4",
                       "--set",
                       "Stage 2/Travel=10",
                       "--set",
                       "Stage 2/Steps=8",
                       DATA_DIR "/tube_on_plane.prm"},
                      MPI_COMM_WORLD,
                      out,
                      err);
  const std::string text = out.str() + err.str();
  const std::string number("([-+.e0-9]+)");
  std::smatch       at;
  const bool        found = std::regex_search(
    text,
    at,
    std::regex("Check: force " + number + " = pressure times footprint " +
               number + " \\+ wall " + number + "; footprint of " + number +
               " x " + number + " cells along alpha_1 and alpha_2\n +" +
               "penetration " + number + " % of the thickness, forces and " +
               "moments balance to " + number + ", interpolation " + number +
               " or " + number + " % of the largest reaction\n"));
  check_true("two lines", found);
  if (!found)
    {
      std::cout << text << std::endl;
      return 0;
    }
  const auto value = [&](const unsigned int i) { return std::stod(at[i]); };
  const Row  last  = read_csv("results/history.csv").back();
  const auto of    = [&](const char *column) {
    return std::stod(last.at(column));
  };
  check_small("force", value(1) - of("force"), 1e-3, value(1));
  check_small("pressure times footprint",
              value(2) - of("pressure") * of("footprint_area"),
              1e-3,
              value(2));
  check_small("the rest", value(3) - (value(1) - value(2)), 1e-3, value(1));
  check_small("carried by the wall", value(3), 0.02, value(1));
  check_small("cells in contact", value(4) * value(5) - of("contact_nodes"), 0);
  // 1e4 is the penalty stiffness, 0.01 the thickness
  check_small("penetration",
              value(6) - 100 * of("max_pressure") / 1e4 / 0.01,
              0.06,
              value(6));
  check_small("balance", value(7), 1e-6);

  std::ostringstream out_of_closed, err_of_closed;
  Biface::run_program({"--output",
                       "results",
                       "--set",
                       "Loads/End plates=alpha_1 min, alpha_1 max",
                       "--set",
                       "Supports/alpha_1 max=radial both; circumferential both",
                       "--set",
                       "Mesh/Intervals alpha_2=-180:180:12",
                       "--set",
                       "Mesh/Closed in alpha_2=true",
                       "--set",
                       "Supports/alpha_2 min=free",
                       "--set",
                       "Supports/alpha_2 max=free",
                       "--set",
                       "Stage 1/Pressure=0.1",
                       "--set",
                       "Stage 1/Critical points=ignore",
                       DATA_DIR "/cylinder_under_pressure.prm"},
                      MPI_COMM_WORLD,
                      out_of_closed,
                      err_of_closed);
  const std::string closed   = out_of_closed.str() + err_of_closed.str();
  const bool        balanced = std::regex_search(
    closed,
    at,
    std::regex("moments balance to " + number + ", interpolation " + number +
               " or " + number + " % of the nodal loads\n"));
  check_true("closed tube", balanced);
  if (!balanced)
    {
      std::cout << closed << std::endl;
      return 0;
    }
  check_small("balance", value(1), 1e-6);
  check_small("interpolation in percent", value(3), 1e-4);
}
