// SPDX-License-Identifier: LGPL-2.1-or-later

// The footprint of a tube under pressure is pi times the travel long, its area
// carries the pressure in the tube, and its edges pass through the nodes
// without jumps, on three meshes.

#include <biface/stepping/step_report.h>

#include "../run_analysis.h"
#include "../tests.h"

using namespace dealii;
using namespace Biface;


int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  const double                     radius = 100, width = 10, pressure = 0.1;
  for (const unsigned int n_cells : {60, 120, 240})
    {
      const double cell    = numbers::PI * radius / n_cells;
      const auto   reports = run_analysis(
        DATA_DIR "/tube_on_plane.prm",
        {"Mesh/Intervals alpha_2=-90:90:" + std::to_string(n_cells)});

      double error = 0, jump = 0, other_width = 0, area = 0, force = 0;
      double last = 0, last_length = 0;
      for (const StepReport &report : reports)
        {
          const double     length    = numbers::PI * report.level.travel;
          const Footprint &footprint = report.footprint;
          error = std::max(error, std::abs(footprint.length - length));
          jump  = std::max(
            jump, std::abs(footprint.length - last - (length - last_length)));
          last        = footprint.length;
          last_length = length;
          if (!report.in_contact)
            continue;
          other_width =
            std::max(other_width, std::abs(footprint.width - width));
          area =
            std::max(area, std::abs(footprint.area - footprint.length * width));
          force = std::max(
            force, std::abs(report.contact.force - pressure * width * length));
        }
      const double whole = numbers::PI * reports.back().level.travel;
      std::cout << n_cells << " cells" << std::endl;
      check_true("  steps", reports.size() == 81);
      check_small("  length", error, 0.5, cell);
      // a node that enters on either side would add two cells
      check_small("  change of length in a step", jump, 0.5, cell);
      check_small("  width", other_width, 1e-9, width);
      check_small("  area", area, 1e-4, whole * width);
      check_small("  force", force, 0.003, whole * width * pressure);
      if (n_cells == 240)
        check_small("  final length", last - whole, 0.01, whole);
    }
}
