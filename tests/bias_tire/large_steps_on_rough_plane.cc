// SPDX-License-Identifier: LGPL-2.1-or-later

// A coarse bias tire on a rough plane is pressed, slid until its footprint
// slips, and slid back, in large steps of which none is halved, in few
// iterations.

#include <biface/stepping/step_report.h>

#include "../tests.h"
#include "bias_tire.h"

using namespace Biface;

int
main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  for (const std::string friction : {"0.3", "0.5", "1"})
    {
      std::cout << "coefficient " << friction << std::endl;
      const auto reports = run_bias_tire(
        {"Mesh/Intervals alpha_1=-120:120:14",
         "Mesh/Intervals alpha_2=-180:-20:4:smooth,-20:20:6,20:180:4:smooth",
         "Contact/Multiplier mass=lumped",
         "Contact/Friction=" + friction,
         "Stage 2/Steps=4",
         "Number of stages=4",
         "Stage 3/Contact=true",
         "Stage 3/Slide=0, 15, 0",
         "Stage 3/Steps=2",
         "Stage 4/Contact=true",
         "Stage 4/Slide=0, 0, 0",
         "Stage 4/Steps=2"});
      check_true("  no step halved", reports.size() == 9);
      unsigned int most = 0;
      for (const StepReport &report : reports)
        most = std::max(most, report.iterations);
      check_range("  iterations of a step", most, 1, 15);
      const ContactSummary &slid = reports.at(6).contact;
      check_range(
        "  part that slips", double(slid.n_slipping) / slid.n_nodes, 0.8, 1);
    }
}
