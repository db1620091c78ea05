// SPDX-License-Identifier: LGPL-2.1-or-later

// A free plate has exactly six frequencies that are zero, with the mass and the
// moments of inertia of the rigid motions, and a free tire has six that are
// small.

#include <biface/solver/modal_analysis.h>

#include <run_analysis.h>
#include <tests.h>

using namespace dealii;
using namespace Biface;

namespace
{
  std::vector<VibrationMode>
  modes(const std::string &file, const std::vector<Override> &overrides)
  {
    return run_analysis(file, overrides).back().modes->modes;
  }
} // namespace


int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  const auto plate = modes(DATA_DIR "/../verification/modes_fv52.prm",
                           {"Supports/alpha_1 min=free",
                            "Supports/alpha_1 max=free",
                            "Supports/alpha_2 min=free",
                            "Supports/alpha_2 max=free",
                            "Mesh/Intervals alpha_1=0:10:16",
                            "Mesh/Intervals alpha_2=0:10:16",
                            "Laminate/Plies=wall: 0.1 @ 0",
                            "Stage 1/Modes=8"});
  for (unsigned int i = 0; i < plate.size(); ++i)
    check_true("plate, mode " + std::to_string(i + 1) +
                 (i < 6 ? " is rigid" : " is elastic"),
               (plate[i].frequency() == 0) == (i < 6));
  // 8000 * 10 * 10 * 0.1
  const double mass = 80000;
  for (unsigned int d = 0; d < 3; ++d)
    check_small("effective mass of a translation",
                plate[d].effective_mass(d) - mass,
                1e-8,
                mass);
  // Leissa (1973): omega a^2 sqrt(rho h/D) = 13.489
  const double D = 2e11 * 1e-3 / 12 / (1 - 0.09);
  check_small(
    "first elastic mode",
    2 * numbers::PI * plate[6].frequency() * 100 * std::sqrt(800 / D) - 13.489,
    0.01,
    13.489);

  const auto tire = modes(PRM_DIR "/bias_tire.prm",
                          {"Material cord/Density=1.2e-9",
                           "Supports/alpha_1 min=free",
                           "Supports/alpha_1 max=free",
                           "Mesh/Intervals alpha_1=-120:120:24",
                           "Mesh/Intervals alpha_2=-180:180:40",
                           "Stage 1/Pressure=0",
                           "Stage 2/Pressure=0",
                           "Stage 2/Contact=false",
                           "Stage 2/Travel=0",
                           "Stage 2/Steps=1",
                           "Stage 2/Modes=7"});
  check_true("free tire: six small frequencies",
             tire[5].frequency() < 0.01 * tire[6].frequency());
}
