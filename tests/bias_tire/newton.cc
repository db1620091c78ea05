// SPDX-License-Identifier: LGPL-2.1-or-later

// The mixed iteration inflates the bias tire in one step of at most 8
// iterations, presses it by 20 mm in one step of at most 15, and converges
// quadratically.

#include <biface/stepping/step_report.h>

#include "../tests.h"
#include "bias_tire.h"

namespace
{
  /** The residuals of the last Newton iterations while the contact zone is at
   * rest shrink like their squares. */
  void
  check_order(const std::vector<double> &residuals)
  {
    // the last three above round-off, which leaves 3e-12
    unsigned int n = residuals.size();
    while (residuals[n - 1] < 1e-11)
      --n;
    const double order = std::log(residuals[n - 1] / residuals[n - 2]) /
                         std::log(residuals[n - 2] / residuals[n - 3]);
    check_range("order of convergence", order, 1.5, 10);
  }
} // namespace

int
main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  const auto mixed = run_bias_tire({"Stage 2/Steps=1"});
  check_range("iterations of the inflation", mixed[0].iterations, 1, 8);
  check_range("iterations of the contact step", mixed[1].iterations, 1, 15);
  for (const auto &report : mixed)
    check_order(report.residuals);
}
