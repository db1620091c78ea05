// SPDX-License-Identifier: LGPL-2.1-or-later

// A bar that is given by a formula, or by heights over a grid, presses a plate
// like one given by its radius, while it turns, or on the ground behind a
// tread; in m and Pa as in mm and MPa.

#include <cmath>
#include <filesystem>
#include <iomanip>
#include <sstream>
#include <string>
#include <vector>

#include "forces.h"

using namespace Biface;

namespace
{
  const std::string           file    = DATA_DIR "/plate_and_bodies.prm";
  const std::vector<Override> radius  = {"Body press/Shape=cylinder",
                                         "Body press/Radius=8"},
                              formula = {"Body press/Shape=formula",
                                         "Body press/Formula=x^2 + z^2 - 64",
                                         "Body press/Size=8"};

  /** The bar is pushed down and turns about the vertical. */
  const std::vector<Override> pushed{
    "Supports/alpha_1 min=fixed",
    "Body press/Point=11, 5, 9",
    "Body press/Friction=0.2",
    "Body press/Motions=down: 0 0 -0.3 turn 20 about 0 0 1",
    "Number of stages=1",
    "Stage 1/Bodies=floor, press",
    "Stage 1/Load factors=bodies press: 1",
    "Stage 1/Steps=3"};

  /** The bar is on a plane, both behind a tread. */
  const std::vector<Override> on_ground{"Supports/alpha_1 min=fixed",
                                        "Body press/Point=11, 5, 7.7",
                                        "Body press/Moves with=foundation",
                                        "Contact/Multiplier mass=lumped",
                                        "Contact/Tread/Height=0.5",
                                        "Contact/Tread/Modulus=2",
                                        "Number of stages=1",
                                        "Stage 1/Bodies=floor, press",
                                        "Stage 1/Contact=true",
                                        "Stage 1/Travel=0.1",
                                        "Stage 1/Steps=2"};


  Forces
  run(std::vector<Override> entries, const std::vector<Override> &more)
  {
    entries.insert(entries.end(), more.begin(), more.end());
    return Forces(file, entries);
  }


  /** The lower half of the bar, from its lowest line on. */
  std::vector<Override>
  heights()
  {
    std::ostringstream csv;
    csv << std::setprecision(16) << "u,v,height\n";
    for (int i = -40; i <= 40; ++i)
      for (const double v : {-10, 10})
        {
          const double u = 0.1 * i;
          csv << u << ',' << v << ',' << std::sqrt(64 - u * u) - 8 << '\n';
        }
    return {
      "Body press/Shape=height field",
      "Body press/Direction=0, 0, 1",
      "Body press/Point=11, 5, 1",
      "Body press/Height file=" +
        std::filesystem::absolute(write_prm("bar.csv", csv.str())).string()};
  }
} // namespace


int
main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  const bool                               is_root =
    (dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0);

  const Resultant truth      = run(pushed, radius).of.at("press"),
                  by_formula = run(pushed, formula).of.at("press"),
                  by_heights = run(pushed, heights()).of.at("press");
  Resultant in_m =
    run(pushed,
        {"Mesh/Intervals alpha_1=0:0.02:8",
         "Mesh/Intervals alpha_2=0:0.01:3",
         "Named points=tip: 0.02 0",
         "Material rubber/E=10e6",
         "Laminate/Plies=rubber: 0.002 @ 0",
         "Body floor/Point=0, 0, -0.0009999",
         "Contact/Regularization=1e13",
         "Contact/Point on path=0.01, 0.005, 0",
         "Body press/Shape=formula",
         "Body press/Formula=x^2 + z^2 - 0.008^2",
         "Body press/Size=0.008",
         "Body press/Point=0.011, 0.005, 0.009",
         "Body press/Motions=down: 0 0 -0.0003 turn 20 about 0 0 1"})
      .of.at("press");
  for (unsigned int i = 3; i < 6; ++i)
    in_m[i] *= 1000;
  const Forces behind_tread         = run(on_ground, radius),
               formula_behind_tread = run(on_ground, formula);
  if (!is_root)
    return 0;
  check_true("the bar presses", -truth[2] > 1);
  check_small("formula", difference(by_formula, truth), 1e-9);
  check_small("heights", difference(by_heights, truth), 1e-5);
  check_small("formula in m and Pa", difference(in_m, truth), 1e-6);
  check_true("plane and bar press behind the tread",
             -behind_tread.of.at("foundation")[2] > 0.1 &&
               -behind_tread.of.at("press")[2] > 0.1);
  for (const std::string body : {"foundation", "press"})
    check_small(
      "formula behind a tread, " + body,
      difference(formula_behind_tread.of.at(body), behind_tread.of.at(body)),
      1e-9);
}
