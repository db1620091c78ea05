// SPDX-License-Identifier: LGPL-2.1-or-later

// Under true pressure, the force on the bias tire with the standard formulation
// has the limit of that of the paper, 2175 N, within 2 N.

#include "../tests.h"
#include "bias_tire.h"

using namespace Biface;

namespace
{
  double
  force(std::vector<Override> overrides)
  {
    overrides.insert(overrides.end(),
                     {"Stage 2/Steps=4",
                      "Contact/Multiplier mass=lumped",
                      "Loads/Pressure type=follower",
                      "Formulation=standard"});
    return run_bias_tire(overrides).back().contact.force;
  }
} // namespace


int
main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  const double coarse = force({});
  const double fine =
    force({"Mesh/Coarse meshes=1",
           "Mesh/Intervals alpha_1=-120:-45:24, -45:45:36, 45:120:24",
           "Mesh/Intervals alpha_2=-180:-15:22:0.8615898602201, -15:15:36, "
           "15:180:22:1.1606450425781"});
  check_range("extrapolated force", fine + (fine - coarse) / 3, 2173, 2177);
}
