// SPDX-License-Identifier: LGPL-2.1-or-later

// The bias tire with 8 mm of rubber outside, as a ply of a single layer and as
// a layer of its own, has the forces and stiffnesses of the independent program
// of doc/bias_tire.md: within 0.1 % with one layer, with two within 0.15 %, the
// fore-and-aft stiffness within 1 %. In series with the carcass the tread
// takes 40 % off the stiffnesses along the tire and in torsion.

#include <map>

#include <biface/stepping/step_report.h>

#include "../tests.h"
#include "bias_tire.h"

using namespace Biface;

namespace
{
  /** By the name of the stage. */
  struct Results
  {
    /** At 4 and 20 mm. */
    std::array<double, 2>         force{};
    std::map<std::string, double> stiffness;
  };


  Results
  run(const std::string &layers)
  {
    std::vector<Override> overrides{
      "Stage 2/Steps=5",
      "Contact/Multiplier mass=lumped",
      "Contact/Tangential regularization=1e4",
      "Loads/Area of face loads=face",
      "Mesh/Intervals alpha_1=-120:-60:9, -60:60:24, 60:120:9",
      "Materials=cord, rubber",
      "Material rubber/Type=isotropic",
      "Material rubber/E=1.8",
      "Material rubber/nu=0.49",
      "Laminate/Plies=2 x (cord: 1.2 @ +-52), rubber: 8 @ 0",
      "Element/Strain sampling=means",
      "Element/Thickness strain=mean director",
      "Laminate/Gradient factor=1",
      "Laminate/Layers=" + layers};
    for (const Override &motion : glued_motions())
      overrides.push_back(motion);
    const auto reports = run_bias_tire(overrides);
    Results    results;
    for (const StepReport &report : reports)
      if (report.stage == "contact")
        for (const unsigned int i : {0, 1})
          if (std::abs(report.level.travel - (i == 0 ? 4. : 20.)) < 1e-6)
            results.force[i] = report.contact.force;
    results.stiffness = secant_stiffnesses(reports);
    return results;
  }
} // namespace


int
main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  const Results one = run("one"), two = run("4, 1");
  check_small("one layer, 4 mm", one.force[0] - 288.84, 1e-3, 288.84);
  check_small("one layer, 20 mm", one.force[1] - 2124.79, 1e-3, 2124.79);
  check_small(
    "one layer, fore-aft", one.stiffness.at("fore-aft") - 624.75, 1e-3, 624.75);
  check_small(
    "one layer, lateral", one.stiffness.at("lateral") - 139.32, 1e-3, 139.32);
  check_small("two layers, 4 mm", two.force[0] - 291.85, 1.5e-3, 291.85);
  check_small("two layers, 20 mm", two.force[1] - 2168.61, 1.5e-3, 2168.61);
  check_small("two layers, fore-aft",
              two.stiffness.at("fore-aft") - 376.18,
              1e-2,
              376.18);
  check_small("two layers, lateral",
              two.stiffness.at("lateral") - 122.80,
              1.5e-3,
              122.80);
  check_range("torsion, two layers over one",
              two.stiffness.at("torsion") / one.stiffness.at("torsion"),
              0.59,
              0.61);
}
