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
    std::vector<Override> overrides = glued_motions();
    for (const std::string entry :
         {"Stage 2/Steps=5", "Contact/Multiplier mass=lumped"})
      overrides.push_back(entry);
    overrides.insert(overrides.end(), springs.begin(), springs.end());
    return secant_stiffnesses(run_bias_tire(overrides));
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
