// SPDX-License-Identifier: LGPL-2.1-or-later

// GMRES with multigrid gives the forces of the direct solver, with a symmetric
// tangent and with an unsymmetric one.


#include "../bias_tire/bias_tire.h"
#include <tests.h>

using namespace dealii;
using namespace Biface;

int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  for (const std::string mass : {"lumped", "consistent"})
    {
      std::vector<Override> coarse{
        "Mesh/Intervals alpha_1=-120:-45:3, -45:45:8, 45:120:3",
        "Mesh/Intervals alpha_2=-180:-15:4:smooth, -15:15:6, 15:180:4:smooth",
        "Stage 2/Travel=10",
        "Stage 2/Steps=1",
        "Contact/Multiplier mass=" + mass};
      const auto direct = run_bias_tire(coarse);
      coarse.push_back("Linear solver/Type=iterative");
      const auto iterative = run_bias_tire(coarse);
      if (Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
        check_small(mass + ": force",
                    direct.back().contact.force -
                      iterative.back().contact.force,
                    1e-6,
                    direct.back().contact.force);
    }
}
