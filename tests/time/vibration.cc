// SPDX-License-Identifier: LGPL-2.1-or-later

// Steps of the time dt turn the frequency f of a small vibration into
// atan(pi f dt)/(pi dt): a free plate whose thickness vibrates,
// f = sqrt(12 E/rho)/(2 pi h). Adaptive steps keep the error that is asked for.

#include <deal.II/base/mpi.h>
#include <deal.II/base/numbers.h>

#include "motion.h"

using namespace dealii;


int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  const double f = std::sqrt(12 * 1000 / 1e-9) / (2 * numbers::PI * 2);
  for (const double dt : {0.1 / f, 0.4 / f})
    {
      const Motion motion =
        move({DATA_DIR "/vibrating_plate.prm",
              "Stage 1/Duration=" + std::to_string(1e9 * 12 * dt) + "e-9",
              "Stage 1/Steps=12",
              "Stage 1/Time error=0"},
             "plate",
             MPI_COMM_SELF);
      // of an oscillation with one frequency, the sum of both neighbors is
      // 2 cos(2 pi f dt) times the value between them
      std::vector<double> u;
      for (const Row &row : motion.probes)
        if (row.at("face") == "outer")
          u.push_back(number(row, "u_z"));
      double products = 0, squares = 0;
      for (unsigned int i = 1; i + 1 < u.size(); ++i)
        {
          products += u[i] * (u[i - 1] + u[i + 1]);
          squares += u[i] * u[i];
        }
      const double found =
                     std::acos(products / squares / 2) / (2 * numbers::PI * dt),
                   expected =
                     std::atan(numbers::PI * f * dt) / (numbers::PI * dt);
      check_small("frequency", found / expected - 1, 1e-7);
    }

  for (const std::string error : {"0.01", "0.001"})
    {
      const Motion motion = move({DATA_DIR "/vibrating_plate.prm",
                                  "Stage 1/Steps=2000",
                                  "Stage 1/Time error=" + error},
                                 "plate",
                                 MPI_COMM_SELF);
      std::cout << "Time error " << error << ": " << motion.history.size()
                << " steps\n";
      check_balance(motion, 1e-9);
    }
}
