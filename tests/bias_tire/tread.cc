// SPDX-License-Identifier: LGPL-2.1-or-later

// The bias tire with 8 mm of rubber outside, as a ply of a single layer, is
// pressed by 20 mm with the force of the independent program of
// doc/bias_tire.md, within 0.1 %. As a layer of its own, in series with the
// carcass, the tread takes 31 % off the fore-and-aft stiffness and 32 % off
// that in torsion.

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
    /** At 20 mm. */
    double                        force = 0;
    std::map<std::string, double> stiffness;
  };


  Results
  run(const std::string &layers)
  {
    std::vector<Override> overrides{
      "Stage 2/Steps=5",
      "Contact/Multiplier mass=lumped",
      "Contact/Tangential regularization=1e4",
      "Mesh/Intervals alpha_1=-120:-60:9, -60:60:24, 60:120:9",
      "Materials=cord, rubber",
      "Material rubber/Type=isotropic",
      "Material rubber/E=1.8",
      "Material rubber/nu=0.49",
      "Laminate/Plies=2 x (cord: 1.2 @ +-52), rubber: 8 @ 0",
      "Formulation=standard",
      "Laminate/Gradient factor=1",
      "Laminate/Layers=" + layers};
    for (const Override &motion : glued_motions())
      overrides.push_back(motion);
    const auto reports = run_bias_tire(overrides);
    Results    results;
    for (const StepReport &report : reports)
      if (report.stage == "contact")
        results.force = report.contact.force;
    results.stiffness = secant_stiffnesses(reports);
    return results;
  }
} // namespace


int
main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  const Results one = run("one"), two = run("4, 1");
  check_small("one layer", one.force - 2124.79, 1e-3, 2124.79);
  const auto ratio = [&](const std::string &motion) {
    return two.stiffness.at(motion) / one.stiffness.at(motion);
  };
  check_range("fore-aft, two layers over one", ratio("fore-aft"), 0.68, 0.70);
  check_range("torsion, two layers over one", ratio("torsion"), 0.67, 0.69);
}
