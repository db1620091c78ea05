// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_laminate_surface_of_plies_h
#define biface_laminate_surface_of_plies_h

#include <deal.II/base/point.h>

#include <array>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace Biface
{
  /** A place on the surface, as formulas of plies know it. */
  struct PlyPlace
  {
    /** A place on a surface with coordinates.
     * @param alpha_1 in the unit of parameter files. */
    PlyPlace(const double alpha_1) : alpha_1(alpha_1)
    {}

    /** A place on a mesh from a file. Unit: length. */
    PlyPlace(const dealii::Point<3> &position) : position(position)
    {}

    /** What messages call it: 'alpha_1 = ...' or the position. */
    std::string
    in_words() const;

    double                          alpha_1 = 0;
    std::optional<dealii::Point<3>> position;
  };


  /** The surface as plies know it, by functions of @f$\alpha_1@f$, which is in
   * the unit of parameter files. */
  struct SurfaceOfPlies
  {
    /** The distance from the axis of revolution; empty if there is none. Unit:
     * length. */
    std::function<double(const double)> radius;

    /** The curvatures @f$k_1,k_2@f$; empty if they are not given. Unit:
     * 1/length. */
    std::function<std::array<double, 2>(const double)> curvature;

    /** The coordinate @f$\alpha_1@f$ of the crown, where the radius is
     * largest. */
    double crown = 0;

    /** The angle of the cords from the circumference at the crown, in degrees,
     * of a surface that is in equilibrium with their tension; none for other
     * surfaces. */
    std::optional<double> crown_cord_angle;

    /** The value of `end` in entries, infinite if the surface has no end. */
    double end = std::numeric_limits<double>::infinity();

    /** The names of the groups of cells, if the surface is a mesh. */
    std::optional<std::vector<std::string>> groups;
  };


  /** The coordinate line from which the angles of plies in entries are
   * counted. */
  enum class AngleReference
  {
    /** Angles are counted from @f$\mathbf e_1@f$ toward @f$\mathbf e_2@f$. */
    meridian,
    /** Angles are counted from @f$\mathbf e_2@f$ toward @f$\mathbf e_1@f$. */
    circumference
  };

  /**
   * The angle at the radius @p ratio, relative to that of the crown, of cords
   * with the angle @p crown_angle at the crown: when a flat ply is shaped to a
   * tire, cords of constant length that are joined where they cross turn like
   * the bars of a pantograph, and the cosine of the angle from the
   * circumference grows with the radius @cite Purdy1963.
   *
   * Both angles are in degrees, in the sense of @p reference, between -90 and
   * 90. NaN if no angle is possible.
   */
  double
  lift(const double         crown_angle,
       const double         ratio,
       const AngleReference reference);
} // namespace Biface

#endif
