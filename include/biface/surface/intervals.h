// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_surface_intervals_h
#define biface_surface_intervals_h

#include <string>
#include <vector>

namespace Biface
{
  /**
   * The grid lines that an interval list describes.
   *
   * The list is a comma-separated sequence of adjoining intervals in rising
   * order, each of one of the forms
   * - `begin:end:n`, n equal cells;
   * - `begin:end:n:q`, n cells, each q times as long as the one before it;
   * - `begin:end:n:smooth`, n cells whose lengths grow (or shrink)
   *   geometrically away from the adjoining interval of one of the forms
   *   above, the first of them already by the common ratio: the lengths
   *   continue those of the neighbor without a jump.
   *
   * @param entry the name of the parameter, for error messages.
   * @param list the text.
   * @param unit what one unit of the numbers in the list is in the result.
   *
   * @return rising coordinates of all grid lines, times @p unit. Neighboring
   * intervals share a line.
   *
   * Throws InputError where the list is malformed, an interval is empty,
   * or intervals overlap or leave a gap.
   */
  std::vector<double>
  parse_intervals(const std::string &entry,
                  const std::string &list,
                  const double       unit);
} // namespace Biface

#endif
