// SPDX-License-Identifier: LGPL-2.1-or-later

// Predicted buckling loads do not depend on the number of ranks: of a tire
// under external pressure, whose symmetry gives pairs, pressed on the ground,
// and of an arch whose tangent is not symmetric, since the pressure follows a
// free edge.

#include <deal.II/base/mpi.h>

#include <iomanip>

#include <biface/stepping/buckling.h>

#include <run_analysis.h>
#include <tests.h>

using namespace dealii;
using namespace Biface;

namespace
{
  void
  run(const std::string &file, const std::vector<Override> &overrides)
  {
    for (const StepReport &report : run_analysis(file, overrides))
      {
        if (Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) != 0)
          continue;
        std::cout << report.stage << ":" << std::setprecision(6);
        if (!report.buckling)
          std::cout << " none";
        else
          for (unsigned int i = 0; i < report.buckling->modes.size(); ++i)
            {
              std::cout << ' ' << report.buckling->loads[i].factor;
              if (const auto &waves = report.buckling->modes[i].waves)
                std::cout << " (" << waves->circumferential << ' '
                          << waves->meridional << ')';
            }
        std::cout << std::endl;
      }
  }
} // namespace


int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  run(PRM_DIR "/bias_tire.prm",
      {"Mesh/Intervals alpha_1=-120:120:12",
       "Mesh/Intervals alpha_2=-180:180:24",
       "Stage 1/Pressure=-0.001",
       "Stage 1/Buckling=3",
       "Stage 2/Steps=1",
       "Stage 2/Pressure=0.1",
       "Stage 2/Travel=10",
       "Stage 2/Buckling=2"});
  const std::string tests = PRM_DIR "/../tests/verification";
  run(tests + "/buckling_ring.prm",
      {"Supports/alpha_2 min=fixed",
       "Supports/alpha_2 max=v_3 middle",
       "Stage 1/Buckling=2"});
}
