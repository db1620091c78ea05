// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_input_grid_data_h
#define biface_input_grid_data_h

#include <deal.II/base/point.h>

#include <array>
#include <string>
#include <vector>

namespace Biface
{
  /** Numbers at the points of a rectangular grid. */
  struct GridData
  {
    /** Sort points into a grid. Throws InputError if they are not those of a
     * grid of at least two rows in both directions.
     * @param points both coordinates and the number, in any order.
     * @param columns the names of the coordinates and of the number, for error
     * messages.
     * @param name that of the file of the points, likewise. */
    GridData(std::vector<dealii::Point<3>>     points,
             const std::array<std::string, 3> &columns,
             const std::string                &name);

    /** The coordinates of the rows in each direction, in ascending order. */
    std::array<std::vector<double>, 2> rows;
    /** The numbers at the points: that at row i of the first coordinate and row
     * j of the second is at i times the number of rows of the second plus j. */
    std::vector<double> values;
  };
} // namespace Biface

#endif
