// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_surface_grid_parameters_h
#define biface_surface_grid_parameters_h

#include <array>

#include <biface/surface/chart_grid.h>
#include <biface/surface/intervals.h>

namespace Biface
{
  class EntryDeclarations;


  /** The entries of a grid. */
  struct ChartGrid::Parameters
  {
    /** The intervals of both coordinates, in the units of parameter files. */
    std::array<IntervalList, 2> intervals{
      {parse_intervals("Mesh/Intervals alpha_1",
                       "-120:-45:12, -45:45:18, 45:120:12"),
       parse_intervals("Mesh/Intervals alpha_2",
                       "-180:-15:11:smooth, -15:15:18, 15:180:11:smooth")}};
    bool             closed       = true;
    MeshDistribution distribution = MeshDistribution::shared;
    /** The number of coarser meshes to start with, see coarsened(). */
    unsigned int n_coarse = 0;

    void
    add_parameters(EntryDeclarations &prm);
  };
} // namespace Biface

#endif
