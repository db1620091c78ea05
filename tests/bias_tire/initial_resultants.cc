// SPDX-License-Identifier: LGPL-2.1-or-later

// With the inflated state as initial resultants of the undeformed tire, the
// force at 20 mm is 2036 N, that of the independent program of
// doc/bias_tire.md.

#include "../tests.h"
#include "bias_tire.h"

int
main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  const auto reports =
    run_bias_tire({"Stage 2/Steps=2", "Stage 2/Start from prestress=true"});
  check_range("force", reports.back().contact.force, 2035.5, 2036.5);
}
