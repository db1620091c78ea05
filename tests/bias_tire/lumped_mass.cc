// SPDX-License-Identifier: LGPL-2.1-or-later

// With the lumped mortar matrix, the force on the bias tire at 20 mm is
// within 2 % of that with the consistent mortar matrix, and the maximum
// pressure, which is at the edge of contact, is smaller.

#include "../tests.h"
#include "bias_tire.h"

int
main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  const auto consistent = run_bias_tire({"Stage 2/Steps=1"}).back().contact;
  const auto lumped =
    run_bias_tire({"Stage 2/Steps=1", "Contact/Multiplier mass=lumped"})
      .back()
      .contact;
  check_small("force", lumped.force - consistent.force, 0.02, consistent.force);
  check_true("smaller maximum pressure",
             lumped.max_pressure < consistent.max_pressure);
}
