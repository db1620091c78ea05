// SPDX-License-Identifier: LGPL-2.1-or-later

// The lowest frequencies of the bias tire, unloaded and inflated, are those of
// the independent program of doc/bias_tire.md. They, the masses and the shapes
// of its pairs of modes do not depend on the number of ranks, nor do those of
// the pressed tire.

#include <deal.II/base/mpi.h>

#include <cmath>
#include <iomanip>

#include <biface/solver/modal_analysis.h>

#include <run_analysis.h>
#include <tests.h>

using namespace dealii;
using namespace Biface;

namespace
{
  std::vector<StepReport>
  run(const std::vector<Override> &overrides)
  {
    std::vector<Override> all{"Material cord/Density=1.2e-9",
                              "Stage 2/Steps=1"};
    all.insert(all.end(), overrides.begin(), overrides.end());
    return run_analysis(PRM_DIR "/bias_tire.prm", all);
  }


  void
  print(const StepReport &report)
  {
    const bool root = Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0;
    if (!report.modes)
      {
        if (root)
          std::cout << "FAILED: no modes" << std::endl;
        return;
      }
    if (root)
      std::cout << report.stage << std::setprecision(10) << std::endl;
    for (const VibrationMode &mode : report.modes->modes)
      if (root)
        // a participation of zero is round-off
        std::cout << "  " << mode.frequency() << ' ' << 1e3 * mode.mass << ' '
                  << std::round(1e9 * mode.participation.norm()) / 1e9 << ' '
                  << mode.waves->circumferential << ' '
                  << mode.waves->meridional << std::endl;
  }


  void
  compare(const StepReport &report, const std::vector<double> &expected)
  {
    if (Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) != 0)
      return;
    for (unsigned int i = 0; i < expected.size(); ++i)
      check_small("  against " + std::to_string(expected[i]),
                  report.modes->modes[i].frequency() - expected[i],
                  2e-5,
                  expected[i]);
  }
} // namespace


int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  const auto tire = run({"Stage 1/Pressure=0",
                         "Stage 1/Modes=4",
                         "Stage 2/Contact=false",
                         "Stage 2/Travel=0",
                         "Stage 2/Modes=4"});
  print(tire[0]);
  compare(tire[0], {34.218});
  print(tire[1]);
  compare(tire[1], {82.208, 144.821, 144.846});

  // even around the turn, so that there are pairs
  const std::vector<Override> even{"Mesh/Intervals alpha_1=-120:120:12",
                                   "Mesh/Intervals alpha_2=-180:180:24",
                                   "Stage 1/Modes=5",
                                   "Stage 2/Modes=5",
                                   "Stage 2/Travel=10"};
  for (const StepReport &report : run(even))
    print(report);
}
