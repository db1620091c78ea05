// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_surface_intervals_h
#define biface_surface_intervals_h

#include <string>
#include <vector>

namespace Biface
{
  /**
   * The grid lines given by an interval list.
   *
   * The list is a comma-separated sequence of adjoining intervals in ascending
   * order, each in one of the forms
   * - `begin:end:n`, n equal cells;
   * - `begin:end:n:q`, n cells, each q times as long as the previous one;
   * - `begin:end:n:smooth`, n cells whose lengths grow (or shrink)
   *   geometrically away from an adjoining interval in one of the forms above.
   *   The common ratio also holds between the two intervals, so that lengths do
   *   not jump.
   *
   * @param entry the name of the parameter, for error messages.
   * @param list the text.
   * @param unit the factor from the numbers in the list to the result.
   *
   * @return the coordinates of all grid lines in ascending order, times
   * @p unit. Neighboring intervals share a line.
   *
   * Throws InputError if the list is malformed, an interval is empty, or
   * intervals overlap or leave a gap.
   */
  std::vector<double>
  parse_intervals(const std::string &entry,
                  const std::string &list,
                  const double       unit);
} // namespace Biface

#endif
