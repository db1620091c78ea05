// SPDX-License-Identifier: LGPL-2.1-or-later

// Adaptive load steps reach the same end as equal ones, in fewer steps.

#include <biface/model/state/loads.h>
#include <biface/stepping/step_report.h>

#include "../run_analysis.h"
#include "../tests.h"

using namespace Biface;

int
main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  // the cantilever bends until its end points along the force
  const std::string file = DATA_DIR "/../verification/cantilever_end_shear.prm";
  State             fixed_end, adaptive_end;
  const auto        fixed = run_analysis(
    file,
    {"Mesh/Intervals alpha_1=0:10:8"},
    [&](const auto &, const auto &, const State &state) { fixed_end = state; });
  const auto adaptive =
    run_analysis(file,
                 {"Mesh/Intervals alpha_1=0:10:8",
                  "Stage 1/Adaptive steps=true",
                  "Step control/Maximum growth=4"},
                 [&](const auto &, const auto &, const State &state) {
                   adaptive_end = state;
                 });

  check_true("twenty equal steps", fixed.size() == 20);
  // with steps that are four times as large at the most
  check_range("steps that adapt", adaptive.size(), 6, 15);
  double growth = 0, previous = 0;
  for (const StepReport &report : adaptive)
    {
      growth   = std::max(growth, report.loads->factors[0] - previous);
      previous = report.loads->factors[0];
    }
  check_range("largest step", growth, 0.06, 0.2 + 1e-12);
  check_small("end of the loads", adaptive.back().loads->factors[0] - 1, 0);

  const double size = fixed_end.displacement.linfty_norm();
  fixed_end.displacement -= adaptive_end.displacement;
  check_small(
    "displacements", fixed_end.displacement.linfty_norm(), 1e-6, size);
}
