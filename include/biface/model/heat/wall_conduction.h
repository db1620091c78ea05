// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_model_heat_wall_conduction_h
#define biface_model_heat_wall_conduction_h

#include <deal.II/base/point.h>
#include <deal.II/base/table.h>

#include <array>
#include <vector>

namespace Biface
{
  /** A fluid or a solid beside a face, to which heat flows as the film
   * coefficient times the difference of the temperatures. */
  struct HeatFilm
  {
    /** The film coefficient. Unit: power/(area * temperature). */
    double coefficient = 0;
    double temperature = 0;

    /** The mean of two films, each of which acts during a part of the time. */
    static HeatFilm
    mean(const HeatFilm &a, const HeatFilm &b, const double part_of_b);
  };


  /**
   * The section of a wall of revolution through which heat flows:
   * quadrilaterals between lines across the wall and the faces of plies. Both
   * ends of the wall are insulated.
   */
  struct WallSection
  {
    /** The vertices (axial position, radius), by line and by face of the plies,
     * from the inner face. */
    dealii::Table<2, dealii::Point<2>> vertices;
    /** The conductivity and the heat source by the strip between two lines and
     * by ply. Unit: power/(length * temperature), power/volume. */
    dealii::Table<2, double> conductivity, source;
    /** The films on the inner and on the outer face, by strip. */
    std::array<std::vector<HeatFilm>, 2> films;
  };


  /** The mean temperatures of the quadrilaterals, by strip and ply, and of the
   * faces, by strip. */
  struct WallTemperatures
  {
    dealii::Table<2, double>           plies;
    std::array<std::vector<double>, 2> faces;
  };


  /** The steady temperatures of a wall, by axisymmetric quadratic finite
   * elements. */
  WallTemperatures
  steady_temperatures(const WallSection &section);
} // namespace Biface

#endif
