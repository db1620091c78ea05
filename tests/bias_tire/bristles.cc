// SPDX-License-Identifier: LGPL-2.1-or-later

// The bias tire that rolls on bristles of a tread of 8 mm with a shear modulus
// of 0.6 MPa has the figures of the independent program of doc/bias_tire.md: of
// standing and free rolling, at one degree of slip angle, and braked by 1 %.
// Each is one step of at most seven iterations from free rolling.

#include <biface/model/quantities/rolling_summary.h>

#include "../tests.h"
#include "bias_tire.h"

using namespace Biface;

int
main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  const auto reports = run_bias_tire({"Contact/Multiplier mass=lumped",
                                      "Contact/Rolling friction=bristles",
                                      "Contact/Tread/Height=8",
                                      "Contact/Tread/Modulus=1.8",
                                      "Number of stages=5",
                                      "Stage 2/Steps=2",
                                      "Stage 3/Contact=true",
                                      "Stage 3/Friction=0.5",
                                      "Stage 3/Ground velocity=1",
                                      "Stage 3/Control=axle moment",
                                      "Stage 4/Contact=true",
                                      "Stage 4/Friction=0.5",
                                      "Stage 4/Slip angle=1",
                                      "Stage 4/Control=axle moment",
                                      "Stage 5/Start from=3",
                                      "Stage 5/Contact=true",
                                      "Stage 5/Friction=0.5",
                                      "Stage 5/Slip ratio=-0.01"});
  const auto check   = [&](const std::string &what,
                         const double       value,
                         const double       expected,
                         const double       bound = 2e-5) {
    check_small(what, value - expected, bound, expected);
  };
  check_true("one step each", reports.size() == 6);
  check("standing force", reports[2].contact.force, 1884.758);
  const RollingSummary free = *reports[3].rolling;
  check("rolling radius", free.rolling_radius, 239.749);
  check("vertical force", free.force[2], 1874.54);
  check("ply steer", -free.force[1], 60.22, 1e-4);
  const RollingSummary turned = *reports[4].rolling;
  check("side force at 1 degree", -turned.force[1], 512.54);
  check("aligning moment", turned.moment[2], 11220.6);
  check_true("nodes that slide", reports[4].contact.n_slipping == 110);
  check("braking force", -reports[5].rolling->force[0], 259.85);
  // the power of the axle is zero
  check_range("sliding and release over the power of the ground at 1 degree",
              (turned.sliding_power + turned.release_power) /
                turned.ground_power,
              0.95,
              1.05);
  check_range("  of which release",
              turned.release_power / turned.ground_power,
              0.001,
              0.2);
  for (unsigned int i = 3; i < 6; ++i)
    check_range("iterations", reports[i].iterations, 1, 7);
}
