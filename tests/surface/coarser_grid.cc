// SPDX-License-Identifier: LGPL-2.1-or-later

// A coarser grid has every second line, and those that must be kept.

#include <biface/surface/chart_grid.h>
#include <biface/surface/grid_parameters.h>
#include <biface/surface/intervals.h>
#include <biface/surface/plane.h>

#include <tests.h>

using namespace dealii;
using namespace Biface;

int
main()
{
  const Plane           plane;
  ChartGrid::Parameters parameters;
  parameters.intervals = {{parse_intervals("intervals", "0:8:8"),
                           parse_intervals("intervals", "0:3:3")}};
  parameters.closed    = false;
  const ChartGrid grid(parameters, plane);

  const auto lines = [&](const std::vector<double> &kept) {
    return grid.coarsened({{kept, {}}}).lines;
  };
  check_true("every second line",
             lines({})[0] == std::vector<double>({0, 2, 4, 6, 8}));
  check_true("and one at 3",
             lines({3})[0] == std::vector<double>({0, 2, 3, 5, 7, 8}));
  check_true("too few to be fewer", lines({})[1] == grid.lines[1]);
  check_true("of which there is a coarser one in turn",
             grid.coarsened({}).coarsened({}).lines[0] ==
               std::vector<double>({0, 4, 8}));
}
