// SPDX-License-Identifier: LGPL-2.1-or-later

// Where vectors are interpolated, the force on the bias tire has the limit of
// interpolated components, 1878 N, within 2 N.

#include "../tests.h"
#include "bias_tire.h"

using namespace Biface;

namespace
{
  double
  force(std::vector<Override> overrides)
  {
    overrides.insert(overrides.end(),
                     {"Stage 2/Steps=1",
                      "Contact/Multiplier mass=lumped",
                      "Element/Interpolation=Cartesian"});
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
  check_range("extrapolated force", fine + (fine - coarse) / 3, 1876, 1880);
}
