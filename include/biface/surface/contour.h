// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_surface_contour_h
#define biface_surface_contour_h

#include <deal.II/base/point.h>

#include <string>
#include <vector>

namespace Biface
{
  /**
   * The points of a plane curve without those that only repeat their
   * neighbors, and its kinks. All criteria are ratios and angles, so that they
   * do not depend on the unit of length.
   *
   * Points are one if together they are at most a tenth as long as the
   * distances to their neighbors, and if the curve would turn back and forth to
   * pass through them: then a spline through all of them would swing farther
   * than they are apart. Points that are close but on a smooth curve remain.
   */
  class Contour
  {
  public:
    /** A point at which the curve turns at once, not by and by. */
    struct Kink
    {
      /** The position of the point among the points. */
      unsigned int index;
      /** The angle by which the polygon turns, in radians; not negative. */
      double angle;
    };

    /** @param points all points in order, finite.
     * @param name the name of their file, for remarks. */
    Contour(const std::vector<dealii::Point<2>> &points,
            const std::string                   &name);

    /** Points that differ. */
    std::vector<dealii::Point<2>> points;
    /** The number of each of them among all, from 1. */
    std::vector<unsigned int> numbers;
    /** Points where the polygon turns by more than 15 degrees, and for its
     * length by more than four times as much as at both neighbors; none next to
     * an end of the curve alone. */
    std::vector<Kink> kinks;
    /** A sentence on each group of points that were taken as one. */
    std::vector<std::string> remarks;

    /** A point in messages: its number and coordinates. */
    std::string
    describe(const unsigned int index) const;

  private:
    /** The last of the points that may be one with the point @p first; @p first
     * itself if there are none. */
    unsigned int
    end_of_group(const std::vector<dealii::Point<2>> &all,
                 const unsigned int                   first) const;

    void
    find_kinks();
  };
} // namespace Biface

#endif
