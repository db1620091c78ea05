// SPDX-License-Identifier: LGPL-2.1-or-later

// Step 3 of the tutorial: the stresses of the plies at the equator add up to
// the force p (r_0^2 - r_w^2)/(2 r_0) that balances the part up to the widest
// point of the inflated section, except for the small part carried by bending.

#include <deal.II/base/mpi.h>
#include <deal.II/base/numbers.h>

#include <sstream>

#include <biface/program/program.h>

#include "../read_csv.h"
#include "../tests.h"

int
main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  std::ostringstream out;
  std::cout << "exit code: "
            << Biface::run_program(
                 {"--output", "results", PRM_DIR "/tutorial/3_torus.prm"},
                 MPI_COMM_WORLD,
                 out,
                 std::cout)
            << std::endl;

  // the widest place of the middle of the wall, by a parabola through three
  // nodes
  const auto profile = read_csv("results/profile-0001.csv");
  const auto height  = [&](const unsigned int i) {
    return (std::stod(profile[i].at("inner_y")) +
            std::stod(profile[i].at("outer_y"))) /
           2;
  };
  unsigned int widest = 1;
  for (unsigned int i = 1; i + 1 < profile.size(); ++i)
    if (height(i) > height(widest))
      widest = i;
  const double slope = (height(widest + 1) - height(widest - 1)) / 2;
  const double curvature =
    height(widest + 1) - 2 * height(widest) + height(widest - 1);
  const double step = std::stod(profile[widest + 1].at("alpha_1")) -
                      std::stod(profile[widest].at("alpha_1"));
  const double psi =
    std::stod(profile[widest].at("alpha_1")) - step * slope / curvature;
  check_range("the widest place (degrees)", psi, 85, 95);

  // dead pressure is per area of the undeformed middle surface
  const double pressure = 0.15, r_0 = 200 + 52.4;
  const double r_w   = 200 + 52.4 * std::cos(psi * dealii::numbers::PI / 180);
  const double force = pressure * (r_0 * r_0 - r_w * r_w) / (2 * r_0);

  // second stresses of Piola and Kirchhoff, times the stretch
  double sum = 0;
  for (const Row &row : read_csv("results/plies-0001.csv"))
    if (row.at("name") == "equator")
      sum += 1.2 * std::stod(row.at("s_11")) *
             std::sqrt(1 + 2 * std::stod(row.at("e_11")));
  check_small("force at the equator", sum - force, 0.03, force);
}
