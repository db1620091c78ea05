// SPDX-License-Identifier: LGPL-2.1-or-later

#include <cmath>

#include <biface/base/errors.h>
#include <biface/input/entry_declarations.h>
#include <biface/input/parameter_tools.h>
#include <biface/surface/grid_parameters.h>
#include <biface/surface/reference_surface.h>

namespace Biface
{
  using namespace dealii;

  namespace
  {
    const std::array<std::string, 2> entry_names{
      {"Mesh/Intervals alpha_1", "Mesh/Intervals alpha_2"}};
  }


  void
  ChartGrid::Parameters::add_parameters(EntryDeclarations &prm)
  {
    // the default grid is that of the bias tire of the paper
    const std::string form =
      " A comma-separated list of adjoining intervals: 'start:end:n' is n "
      "equal cells, 'start:end:n:q' is n cells each q times as long as the "
      "previous one, 'start:end:n:smooth' is n cells whose lengths continue "
      "those of the adjoining interval geometrically. Start and end may be "
      "formulas, such as 360/7.";
    const Unit        unit("degrees for an angle, length otherwise");
    const std::string with_end =
      " The formulas may contain 'end', the largest alpha_1 of the surface, "
      "such as 0.3*end.";
    add_parsed(prm,
               "Intervals alpha_1",
               intervals[0].text,
               intervals[0],
               parse_intervals,
               "Cells along the first coordinate (the meridian)." + form +
                 with_end,
               unit);
    add_parsed(prm,
               "Intervals alpha_2",
               intervals[1].text,
               intervals[1],
               parse_intervals,
               "Cells along the second coordinate (around the axis)." + form,
               unit);
    prm.add_parameter("Closed in alpha_2",
                      closed,
                      "Whether the second coordinate is closed, that is, "
                      "spans a full turn and has no edges.",
                      Patterns::Bool());
    add_choice(prm,
               "Distribution",
               distribution,
               {"shared", "distributed"},
               "Distribution of the cells over the ranks: 'shared' (every "
               "rank stores all cells) or 'distributed' (every rank stores "
               "its own cells and their neighbors, for meshes too large for "
               "one rank). Results are the same.",
               EntryKind::solution);
    prm.add_parameter("Coarse meshes",
                      n_coarse,
                      "Number of coarser meshes, each with half as many cells "
                      "in both directions as the next, on which the analysis "
                      "is run first. Steps on the finer mesh then start from "
                      "the solution on the coarser one, which takes far fewer "
                      "iterations on fine meshes in contact. Results on "
                      "coarser meshes are not written.",
                      Patterns::Integer(0, 10));
  }


  ChartGrid::ChartGrid(const Parameters       &parameters,
                       const ReferenceSurface &surface)
    : closed(parameters.closed && surface.has_chart())
    , distribution(parameters.distribution)
  {
    if (!surface.has_chart())
      return;
    for (unsigned int a = 0; a < 2; ++a)
      lines[a] = parameters.intervals[a]
                   .on(surface.end(a))
                   .lines(surface.coordinate_unit(a));
    // the line at 0 lies there exactly, for formulas and messages
    for (std::vector<double> &coordinates : lines)
      for (double &line : coordinates)
        if (std::abs(line) < 1e-12 * (coordinates.back() - coordinates.front()))
          line = 0;

    const std::pair<double, double> range = surface.range();
    const double tolerance = 1e-9 * (lines[0].back() - lines[0].front());
    if (lines[0].front() < range.first - tolerance ||
        lines[0].back() > range.second + tolerance)
      throw InputError(
        entry_names[0],
        parameters.intervals[0].text,
        "alpha_1 of the surface runs from " +
          number_to_string(range.first / surface.coordinate_unit(0)) + " to " +
          number_to_string(range.second / surface.coordinate_unit(0)));

    const double period = surface.get_periodicity()[1];
    if (period > 0)
      {
        if (lines[1].back() - lines[1].front() > period * (1 + 1e-12))
          throw InputError(entry_names[1],
                           parameters.intervals[1].text,
                           "it must not span more than 360 degrees");
        for (unsigned int j = 1; j < lines[1].size(); ++j)
          // between two points half a turn apart, the manifold does not know
          // which way around the cell lies
          if (!(lines[1][j] - lines[1][j - 1] < 0.49 * period))
            throw InputError(entry_names[1],
                             parameters.intervals[1].text,
                             "each cell must span less than 176 degrees");
      }
    if (static_cast<double>(lines[0].size()) * lines[1].size() > 3e8)
      throw InputError(entry_names[0],
                       parameters.intervals[0].text,
                       "the mesh must have fewer than 300 million nodes");

    if (closed)
      {
        const double turn = surface.get_periodicity()[1];
        const double span = lines[1].back() - lines[1].front();
        if (turn == 0 || std::abs(span - turn) > 1e-12 * turn)
          throw InputError(entry_names[1],
                           parameters.intervals[1].text,
                           "a closed coordinate must span 360 degrees");
        // with two cells, a cell would be the neighbor of the other on both
        // sides
        if (lines[1].size() < 4)
          throw InputError(entry_names[1],
                           parameters.intervals[1].text,
                           "a closed coordinate needs at least 3 cells");
      }
  }
} // namespace Biface
