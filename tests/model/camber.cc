// SPDX-License-Identifier: LGPL-2.1-or-later

// A wheel that rolls with camber, at speed: with plies in mirror symmetry the
// opposite camber mirrors all forces of the ground, which push the wheel to the
// side to which it leans; and the forces of ground, rim and pressure are in
// balance.

#include <iomanip>

#include <biface/model/quantities/rolling_summary.h>
#include <biface/stepping/step_report.h>

#include "forces.h"

using namespace dealii;
using namespace Biface;

namespace
{
  Forces
  roll(const double degrees)
  {
    const double angle = degrees * numbers::PI / 180;
    return Forces(PRM_DIR "/bias_tire.prm",
                  {"Contact/Direction=" + std::to_string(std::cos(angle)) +
                     ", " + std::to_string(std::sin(angle)) + ", 0",
                   "Contact/Multiplier mass=lumped",
                   "Contact/Critical velocity=200",
                   "Laminate/Plies=cord: 4.8 @ 0",
                   "Material cord/Density=1.2e-9",
                   "Mesh/Intervals alpha_1=-120:120:12",
                   "Mesh/Intervals alpha_2=-180:-30:4, -30:30:12, 30:180:4",
                   "Newton/Residual tolerance=1e-11",
                   "Number of stages=3",
                   "Stage 2/Steps=1",
                   "Stage 2/Travel=12",
                   "Stage 3/Contact=true",
                   "Stage 3/Friction=0.5",
                   "Stage 3/Ground velocity=10000",
                   "Stage 3/Control=axle moment",
                   "Stage 3/Steps=3"});
  }
} // namespace


int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  const Forces                     left = roll(4), right = roll(-4);
  if (Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) != 0)
    return 0;

  check_small("balance", left.imbalance, 1e-8);
  check_small("balance with opposite camber", right.imbalance, 1e-8);
  const RollingSummary &a = *left.report.rolling, &b = *right.report.rolling;
  // across the plane of the wheel forces change their sign, along it moments
  for (unsigned int i = 0; i < 3; ++i)
    {
      const double sign = (i == 1 ? -1 : 1);
      check_small(
        "mirrored force", a.force[i] - sign * b.force[i], 1e-6, a.force[2]);
      check_small("mirrored moment",
                  a.moment[i] + sign * b.moment[i],
                  1e-6,
                  250 * a.force[2]);
    }
  // the wheel leans to the left
  check_range("camber thrust", a.force[1] / a.force[2], 0.005, 0.2);
  // more digits than are compared: no rounding of the last one
  std::cout << std::setprecision(9) << "forces: " << a.force[1] << ' '
            << a.force[2] << std::endl;
}
