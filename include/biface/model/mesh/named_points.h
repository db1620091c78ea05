// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_model_mesh_named_points_h
#define biface_model_mesh_named_points_h

#include <deal.II/base/point.h>

#include <optional>
#include <string>
#include <vector>

#include <biface/input/coordinate.h>

namespace Biface
{
  class EntryDeclarations;
  class ReferenceSurface;

  /** A named point of the surface, used to support, load, monitor or control a
   * node. */
  struct NamedPoint
  {
    std::string name;
    /** The coordinates of the point, in the internal unit of the surface or in
     * that of parameter files. */
    dealii::Point<2> alpha;
    /** The first coordinate, if it depends on the `end` of the surface. */
    std::optional<Coordinate> alpha_1 = {};
    /** The position of a point on a surface without coordinates. */
    std::optional<dealii::Point<3>> position = {};
  };

  /** Read a comma-separated list of points, 'name: alpha_1 alpha_2', in the
   * unit of parameter files, or 'name: x y z'. Throws InputError if it is
   * malformed or contains a name twice. */
  std::vector<NamedPoint>
  parse_points(const std::string &entry, const std::string &text);


  /** The position of a named point in a list. Throws InputError that names
   * @p entry if there is no such point. */
  unsigned int
  find_point(const std::vector<NamedPoint> &points,
             const std::string             &entry,
             const std::string             &name);


  /** The named points of a shell. */
  struct NamedPoints
  {
    /** The points as they are given, in the unit of parameter files. */
    std::vector<NamedPoint> list;

    void
    add_parameters(EntryDeclarations &prm);

    /** The points in the internal unit of a surface. Throws InputError if one
     * is given in another way than the surface has coordinates. */
    std::vector<NamedPoint>
    on(const ReferenceSurface &surface) const;
  };
} // namespace Biface

#endif
