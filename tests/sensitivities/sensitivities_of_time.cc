// SPDX-License-Identifier: LGPL-2.1-or-later

// Derivatives by the duration and the temperature of stages, and by numbers of
// materials that relax: those of the closed form of a strip that is stretched
// and held, and those of whole runs of a tire under a given force, in a stage
// that starts from an earlier one, and of a sealed gas.

#include <array>
#include <cmath>
#include <string>
#include <vector>

#include <biface/problem/parameters.h>

#include "sensitivities.h"
#include <tests.h>


namespace
{
  /** The force on the strip of relaxation_ramp.prm at the end of the last
   * stage, over that of its modulus.
   * @param times those of the stages 1, 2 and 4.
   * @param temperatures those at the ends of the stages 1, 3 and 4. */
  double
  force(const std::array<double, 3> &times,
        const std::array<double, 3> &temperatures)
  {
    const std::array<double, 2> parts{{0.3, 0.2}}, taus{{1, 10}};
    // how much faster it relaxes
    const auto faster = [](const double temperature) {
      const double above = temperature - 20;
      return std::pow(10., 10 * above / (100 + above));
    };
    const double ramp = times[0] * faster(temperatures[0]);
    const double since =
      times[1] * faster(temperatures[0]) +
      times[2] * faster((temperatures[1] + temperatures[2]) / 2);
    double sum = 1;
    for (unsigned int i = 0; i < 2; ++i)
      sum -= parts[i] * (1 - taus[i] / ramp * (1 - std::exp(-ramp / taus[i])) *
                               std::exp(-since / taus[i]));
    return sum;
  }


  void
  check_strip()
  {
    const SensitivityTable table = table_of(
      DATA_DIR "/../verification/relaxation_ramp.prm",
      {"Stage 4/Temperature=30",
       "Newton/Residual tolerance=1e-11",
       "Sensitivities/Outputs=alpha_1 max F_x",
       "Sensitivities/Entries=Stage 1/Duration; Stage 2/Duration; Stage "
       "4/Duration; Stage 1/Temperature; Stage 3/Temperature; Stage "
       "4/Temperature"});
    if (Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) != 0)
      return;
    for (unsigned int e = 0; e < 6; ++e)
      {
        constexpr double      step = 1e-4;
        std::array<double, 2> logarithms{};
        for (unsigned int side = 0; side < 2; ++side)
          {
            std::array<double, 3> times{{2, 3, 1}}, temperatures{{20, 30, 30}};
            (e < 3 ? times : temperatures)[e % 3] *=
              std::exp(side == 0 ? -step : step);
            logarithms[side] = std::log(force(times, temperatures));
          }
        check_small("strip by " + table.entries[e].name,
                    table.logarithmic(e, 0) -
                      (logarithms[1] - logarithms[0]) / (2 * step),
                    1e-5);
      }
  }
} // namespace


int
main(int argc, char **argv)
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  check_strip();

  const std::vector<Override> relaxing{
    "Mesh/Intervals alpha_1=-120:120:8",
    "Mesh/Intervals alpha_2=-180:-20:3:smooth, -20:20:4, 20:180:3:smooth",
    "Contact/Multiplier mass=lumped",
    "Contact/Regularization=1e3",
    "Named points=side: 0 -180",
    "Material cord/Relaxation times=1, 20",
    "Material cord/Relaxation moduli=0.2, 0.3",
    "Material cord/Temperature shift=WLF",
    "Material cord/Reference temperature=25",
    "Material cord/WLF C1=8.86",
    "Material cord/WLF C2=101.6",
    "Stage 1/Temperature=25",
    "Stage 1/Duration=0.5",
    "Stage 2/Temperature=30",
    "Stage 2/Duration=2",
    "Stage 2/Travel=10",
    "Stage 2/Steps=2",
    "Sensitivities/Relative step=3e-5"};
  const auto with = [&](const std::vector<Override> &more) {
    std::vector<Override> all = relaxing;
    all.insert(all.end(), more.begin(), more.end());
    return all;
  };
  const std::string tire    = PRM_DIR "/bias_tire.prm";
  const std::string entries = "Stage 1/Duration; Stage 2/Duration; Stage "
                              "1/Temperature; Stage 2/Temperature; ";
  check_sensitivities("force",
                      tire,
                      with({"Stage 2/Travel=unchanged",
                            "Stage 2/Control=foundation force",
                            "Stage 2/Force=500"}),
                      entries + "Stage 2/Force; Material cord/Relaxation "
                                "times[1]; Material cord/WLF C1",
                      "approach, side u_x");
  // whole runs have kinks where nodes enter
  check_sensitivities("branch",
                      tire,
                      with({"Number of stages=4",
                            "Stage 3/Pressure=0.2",
                            "Stage 3/Duration=10",
                            "Stage 4/Start from=2",
                            "Stage 4/Contact=true",
                            "Stage 4/Duration=3"}),
                      entries + "Stage 4/Duration",
                      "force, side u_x",
                      1e-3);
  check_sensitivities("gas",
                      DATA_DIR "/gas_tube.prm",
                      {"Named points=middle: 25 0",
                       "Mesh/Intervals alpha_1=0:25:2, 25:50:2",
                       "Material wall/Relaxation times=1",
                       "Material wall/Relaxation moduli=0.4",
                       "Stage 1/Duration=0.5",
                       "Stage 2/Duration=2",
                       "Sensitivities/Relative step=3e-5"},
                      "Stage 1/Duration; Stage 2/Duration",
                      "pressure, volume, middle u_x");
}
