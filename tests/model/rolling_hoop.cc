// SPDX-License-Identifier: LGPL-2.1-or-later

// A hoop that does not stretch rolls with its circumference: pressed flat by 3
// % of its radius, a wheel with a stiff hoop as its outer ply has the rolling
// radius of the undeformed hoop within 0.1 %.

#include <run_analysis.h>
#include <tests.h>

using namespace Biface;

int
main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  const StepReport                         report =
    run_analysis(DATA_DIR "/rolling_hoop.prm", {}).back();
  if (dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) != 0)
    return 0;

  check_small("approach", report.level.travel - 3, 1e-9);
  check_small(
    "rolling radius", report.rolling->rolling_radius - 100, 1e-3, 100);
  std::cout << "rolling radius: " << report.rolling->rolling_radius
            << std::endl;
}
