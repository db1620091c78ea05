// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_surface_intervals_h
#define biface_surface_intervals_h

#include <string>
#include <vector>

namespace Biface
{
  /** Cells between two coordinates, each @p ratio times as long as the one
   * before it. */
  struct Interval
  {
    /** The text of the interval as the user wrote it. */
    std::string  text;
    double       start   = 0;
    double       end     = 0;
    unsigned int n_cells = 0;
    double       ratio   = 1;

    /** The length of the cell number @p i. */
    double
    cell_length(const unsigned int i) const;
  };


  /** Adjoining intervals in rising order. */
  struct IntervalList
  {
    std::string entry;
    std::string text;
    /** The intervals; empty if a coordinate depends on `end`. */
    std::vector<Interval> intervals;

    /** The intervals on a surface whose coordinate has the largest value
     * @p end, infinite for none. Throws InputError like parse_intervals(). */
    IntervalList
    on(const double end) const;

    /** The rising coordinates of all grid lines, times @p unit. Neighboring
     * intervals share a line. The coordinates must not depend on `end`. */
    std::vector<double>
    lines(const double unit = 1) const;
  };


  /**
   * Read a list of intervals, separated by commas, each of one of the forms
   * - `start:end:n`, n equal cells;
   * - `start:end:n:q`, n cells, each q times as long as the one before it;
   * - `start:end:n:smooth`, n cells whose lengths grow (or shrink)
   *   geometrically away from the adjoining interval of one of the forms
   *   above, the first of them already by the common ratio: the lengths
   *   continue those of the neighbor without a jump.
   *
   * If start or end depend on the `end` of the surface, see Coordinate, only
   * their form is checked here, and the rest by IntervalList::on().
   *
   * @param entry the name of the parameter, for error messages.
   *
   * Throws InputError where the list is malformed, an interval is empty,
   * or intervals overlap or leave a gap.
   */
  IntervalList
  parse_intervals(const std::string &entry, const std::string &text);
} // namespace Biface

#endif
