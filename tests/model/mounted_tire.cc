// SPDX-License-Identifier: LGPL-2.1-or-later

// A tire whose beads slide on the seats of a rim, with friction, against its
// flanges has the same strain energy all around as twelve times in a cyclic
// sector, wherever the sector is.

#include "../run_analysis.h"
#include "../tests.h"

using namespace Biface;

namespace
{
  /** The strain energy under pressure, on one cell in 30 degrees. */
  double
  energy(const double from, const double to)
  {
    const bool            closed = (to - from == 360);
    const std::string     cells  = std::to_string(int((to - from) / 30));
    std::vector<Override> overrides{
      "Mesh/Intervals alpha_2=" + std::to_string(from) + ":" +
        std::to_string(to) + ":" + cells,
      std::string("Mesh/Closed in alpha_2=") + (closed ? "true" : "false"),
      "Mesh/Intervals alpha_1=0:26:6, 26:50:6, 50:70:3, 70:end-70:14, "
      "end-70:end-50:3, end-50:end-26:6, end-26:end:6",
      "Number of stages=1"};
    if (!closed)
      {
        overrides.push_back("Supports/alpha_2 min=cyclic");
        overrides.push_back("Supports/alpha_2 max=cyclic");
      }
    return energy_at_end(PRM_DIR "/mounted_tire.prm", overrides);
  }
} // namespace


int
main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  const double all = energy(-180, 180), at_0 = energy(-15, 15),
               at_120 = energy(105, 135);
  if (dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) != 0)
    return 0;
  check_true("positive", all > 0);
  check_small("sector", 12 * at_0 - all, 1e-7, all);
  check_small("another one", 12 * at_120 - all, 1e-7, all);
}
