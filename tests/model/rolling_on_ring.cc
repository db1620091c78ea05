// SPDX-License-Identifier: LGPL-2.1-or-later

// A wheel with a support ring inside, on which its crown rests, rolls: slowly
// and without friction with the forces of the wheel that stands; freely with
// friction without a moment of the axle, and the powers balance.

#include <cmath>

#include <biface/stepping/step_report.h>

#include "forces.h"
#include "rolling_wheel.h"

using namespace Biface;

namespace
{
  /** The last step, and the forces. */
  Forces
  run(const std::vector<Override> &changes)
  {
    std::vector<Override> all{"Number of stages=3",
                              "Stage 2/Travel=15",
                              "Bodies=ring",
                              "Body ring/Shape=torus",
                              "Body ring/Radius=200",
                              "Body ring/Tube radius=44",
                              "Body ring/Face=inner",
                              "Stage 2/Bodies=ring",
                              "Stage 3/Bodies=ring"};
    all.insert(all.end(), changes.begin(), changes.end());
    return Forces(PRM_DIR "/bias_tire.prm", rolling_overrides(all));
  }
} // namespace


int
main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  const std::vector<Override> without_friction{
    "Stage 3/Friction=0", "Stage 3/Control=load", "Stage 3/Ground velocity=0"};
  std::vector<Override> slowly(without_friction);
  slowly.emplace_back("Stage 3/Angular velocity=1e-3");
  const Forces stands = run(without_friction), spins = run(slowly),
               rolls = run({});
  if (dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) != 0)
    return 0;
  const double force = stands.of.at("foundation")[0],
               ring  = stands.of.at("ring")[0];
  check_true("the ring carries", std::abs(ring) > 0.05 * std::abs(force));
  check_small(
    "spinning: force", spins.of.at("foundation")[0] - force, 1e-6, force);
  check_small("ring", spins.of.at("ring")[0] - ring, 1e-6, ring);
  check_small("rolling: moment of the axle",
              rolls.report.rolling->axle_moment,
              1e-6,
              250 * force);
  check_small(
    "moment of the ring about it", rolls.of.at("ring")[4], 1e-10, 250 * force);
  check_small("balance of forces", rolls.imbalance, 1e-7);
  check_powers("balance of powers", *rolls.report.rolling);
}
