// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_model_mesh_named_points_h
#define biface_model_mesh_named_points_h

#include <deal.II/base/parameter_handler.h>

#include <optional>
#include <string>
#include <vector>

#include <biface/base/linear_algebra.h>
#include <biface/input/coordinate.h>
#include <biface/model/mesh/component.h>
#include <biface/surface/reference_surface.h>

namespace Biface
{
  class ShellMesh;

  /** A named point of the surface, used to support, load, monitor or control a
   * node. */
  struct NamedPoint
  {
    std::string name;
    /** In the internal unit of the surface or in that of parameter files. */
    dealii::Point<2> alpha;
    /** The first coordinate, if it depends on the `end` of the surface. */
    std::optional<Coordinate> alpha_1 = {};
  };

  /** Read a comma-separated list of points, 'name: alpha_1 alpha_2', in the
   * unit of parameter files. Throws InputError if it is malformed or contains a
   * name twice. */
  std::vector<NamedPoint>
  parse_points(const std::string &entry, const std::string &text);


  /** The points of a shell. */
  struct NamedPoints
  {
    /** In the unit of parameter files. */
    std::vector<NamedPoint> list;

    void
    add_parameters(dealii::ParameterHandler &prm);

    /** Throw InputError, naming @p entry, if there is no point of this name. */
    void
    check_name(const std::string &entry, const std::string &name) const;

    /** The points in the internal unit of a surface. */
    std::vector<NamedPoint>
    on(const ReferenceSurface &surface) const;
  };


  /**
   * The nodes of the mesh at points: positions in ShellMesh::nodes, or invalid
   * numbers for nodes that exist only on other ranks. The coordinates of the
   * points are replaced by those of their nodes, which differ by a period or by
   * round-off.
   *
   * Throws InputError, naming the nearest node, if a point is not a node.
   */
  std::vector<unsigned int>
  find_nodes(std::vector<NamedPoint> &points, const ShellMesh &mesh);

  /** The node of a named point of the mesh, see find_nodes(). Throws
   * InputError, naming @p entry, if there is no such point. */
  unsigned int
  node_of_point(const ShellMesh   &mesh,
                const std::string &entry,
                const std::string &name);

  /**
   * The vector @f$\mathbf l@f$ for which @f$\mathbf l\cdot\mathbf V@f$ is a
   * component of the displacement of the middle surface at a named point.
   */
  LA::Vector
  displacement_functional(const ShellMesh   &mesh,
                          const std::string &point,
                          const Component    component);
} // namespace Biface

#endif
