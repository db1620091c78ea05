// SPDX-License-Identifier: LGPL-2.1-or-later

// The stiffnesses of the standing bias tire, glued to the ground by springs
// of 0.075 MPa/mm along it, are those of the independent program of
// doc/bias_tire.md; with a tread of 8 mm and E = 1.8 MPa, which has the same
// springs and four times as stiff ones across, the fore-and-aft stiffness is.

#include <map>

#include "../tests.h"
#include "bias_tire.h"

using namespace Biface;

namespace
{
  /** By the name of the stage. */
  std::map<std::string, double>
  stiffnesses(const std::vector<Override> &springs)
  {
    std::vector<Override> overrides{"Stage 2/Steps=5",
                                    "Contact/Multiplier mass=lumped",
                                    "Number of stages=5",
                                    "Stage 3/Name=fore-aft",
                                    "Stage 3/Start from=2",
                                    "Stage 3/Contact=true",
                                    "Stage 3/Glued=true",
                                    "Stage 3/Slide=0, 0, 0.02",
                                    "Stage 4/Name=lateral",
                                    "Stage 4/Start from=2",
                                    "Stage 4/Contact=true",
                                    "Stage 4/Glued=true",
                                    "Stage 4/Slide=0, 0.02, 0",
                                    "Stage 5/Name=torsion",
                                    "Stage 5/Start from=2",
                                    "Stage 5/Contact=true",
                                    "Stage 5/Glued=true",
                                    "Stage 5/Turn=0.02"};
    overrides.insert(overrides.end(), springs.begin(), springs.end());
    std::map<std::string, double> result;
    for (const StepReport &report : run_bias_tire(overrides))
      if (report.stiffness)
        result[report.stage] = report.stiffness->secant.along();
    return result;
  }
} // namespace


int
main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  const auto springs = stiffnesses({"Contact/Tangential regularization=0.075"});
  check_small("fore-aft", springs.at("fore-aft") - 390.45, 2e-5, 390.45);
  check_small("lateral", springs.at("lateral") - 118.36, 5e-5, 118.36);
  check_small("torsion", springs.at("torsion") - 17164.7, 2e-5, 17164.7);

  const auto tread =
    stiffnesses({"Contact/Tread/Height=8", "Contact/Tread/Modulus=1.8"});
  check_small(
    "fore-aft with a tread", tread.at("fore-aft") - 415.1, 2e-4, 415.1);
  const auto grooved = stiffnesses({"Contact/Tread/Height=4",
                                    "Contact/Tread/Modulus=1.8",
                                    "Contact/Tread/Void ratio=0.5"});
  check_small("half as high, half of it void",
              grooved.at("fore-aft") - tread.at("fore-aft"),
              1e-8,
              tread.at("fore-aft"));
}
