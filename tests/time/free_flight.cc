// SPDX-License-Identifier: LGPL-2.1-or-later

// A free strip under a pulse of forces at three corners tumbles: with steps of
// 0.1 and 0.05 ms, its energy and its position after 50 ms are those of an
// independent program, and energy, momentum and angular momentum are constant.

#include <deal.II/base/mpi.h>

#include <array>

#include "motion.h"

using namespace dealii;

namespace
{
  struct Known
  {
    std::string           time_step;
    double                energy;
    std::array<double, 3> displacement;
  };
} // namespace


int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  for (const Known &known :
       {Known{"1e-4",
              22820.8342486653,
              {{-200.63200861, 72.08451469, 429.03075001}}},
        Known{"5e-5",
              22836.25116867,
              {{-200.11290965, 72.25247413, 429.44037867}}}})
    {
      std::vector<std::string> settings{DATA_DIR "/tumbling_strip.prm"};
      for (const std::string stage : {"1", "2", "3"})
        settings.push_back("Stage " + stage + "/Time step=" + known.time_step);
      const Motion motion =
        move(settings, "step_" + known.time_step, MPI_COMM_WORLD);
      if (Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) != 0)
        continue;
      std::cout << "Steps of " << known.time_step << " s\n";
      check_small(
        "energy", motion.energy.back() - known.energy, 1e-9, known.energy);
      check_constants(motion, "free", 2e-12);
      const Row last = motion.probes.back();
      for (unsigned int i = 0; i < 3; ++i)
        check_small("displacement",
                    number(last, std::string("u_") + "xyz"[i]) -
                      known.displacement[i],
                    1e-7);
    }
}
