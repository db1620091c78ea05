// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_model_heat_heat_of_plies_h
#define biface_model_heat_heat_of_plies_h

#include <deal.II/base/table.h>

namespace Biface
{
  /** The heat source and temperature of each ply of a rolling wheel, by the
   * strips of the wall and the plies of the layup, see RollingHeat. */
  struct HeatOfPlies
  {
    /** The heat source; 0 where a ply does not exist. Unit: power/volume. */
    dealii::Table<2, double> source;
    /** The temperatures; empty if they are not computed; nan where a ply does
     * not exist. */
    dealii::Table<2, double> temperature;
  };
} // namespace Biface

#endif
