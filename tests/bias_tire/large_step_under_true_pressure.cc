// SPDX-License-Identifier: LGPL-2.1-or-later

// Under true pressure the mixed iteration presses the bias tire by 20 mm in one
// step of at most 12 iterations, with either mortar matrix.

#include "../tests.h"
#include "bias_tire.h"

int
main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  for (const std::string mass : {"lumped", "consistent"})
    {
      // the iterations of failed attempts count
      const auto reports = run_bias_tire({"Stage 2/Steps=1",
                                          "Loads/Pressure type=follower",
                                          "Contact/Multiplier mass=" + mass});
      check_range("iterations of the contact step, " + mass + " mortar matrix",
                  reports.back().iterations,
                  1,
                  12);
    }
}
