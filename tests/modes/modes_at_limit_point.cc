// SPDX-License-Identifier: LGPL-2.1-or-later

// The square of the lowest frequency of a shallow roof falls on the way to the
// limit point of its path and is negative beyond it, and as many squares are
// negative as the tangent has negative pivots.

#include <algorithm>

#include <biface/solver/modal_analysis.h>

#include <run_analysis.h>
#include <tests.h>

using namespace dealii;
using namespace Biface;

int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  // the force has its maximum at a deflection of 15.2
  double last = 0;
  for (const double deflection : {5., 10., 14., 16., 17.})
    {
      const auto reports =
        run_analysis(PRM_DIR "/snap_through_roof.prm",
                     {"Material ply/Density=1.5e-9",
                      "Stage 1/Control=displacement",
                      "Stage 1/Control point=center",
                      "Stage 1/Control component=x",
                      "Stage 1/Control value=" + std::to_string(-deflection),
                      "Stage 1/Steps=4",
                      "Stage 1/Modes=4"});
      const StepReport &report = reports.back();
      const auto       &modes  = report.modes->modes;
      const double      square = modes[0].square().real();
      std::cout << "deflection " << deflection << std::endl;
      check_true("  the square falls", deflection == 5 || square < last);
      check_true("  positive before the limit point",
                 (square > 0) == (deflection < 15.2));
      check_true("  it grows or vibrates",
                 (modes[0].growth_rate() > 0) != (modes[0].frequency() > 0));
      const unsigned int n_negative =
        std::count_if(modes.begin(), modes.end(), [](const auto &mode) {
          return mode.square().real() < 0;
        });
      check_true("  as many as negative pivots",
                 n_negative == report.n_negative_pivots);
      last = square;
    }
}
