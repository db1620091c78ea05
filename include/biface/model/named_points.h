// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_model_named_points_h
#define biface_model_named_points_h

#include <deal.II/base/parameter_handler.h>

#include <string>
#include <vector>

#include <biface/base/linear_algebra.h>
#include <biface/surface/reference_surface.h>

namespace Biface
{
  class ShellMesh;

  /** A point of the surface that has a name: nodes can be supported, loaded,
   * watched and steered by it. */
  struct NamedPoint
  {
    std::string name;
    /** In the surface's internal unit. */
    dealii::Point<2> alpha;
  };


  /** The points of a shell. */
  struct NamedPoints
  {
    std::string list;

    void
    add_parameters(dealii::ParameterHandler &prm);

    /** Read the list in the units of @p surface. Throws InputError where it is
     * malformed, or names a point twice. */
    std::vector<NamedPoint>
    parse(const ReferenceSurface &surface) const;
  };


  /**
   * The nodes of the mesh at points: positions in ShellMesh::nodes, or invalid
   * numbers where a node is on other ranks only. The points get the coordinates
   * of their nodes, which differ by a period or by round-off.
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
   * Cartesian component of the displacement of the middle surface at a named
   * point.
   */
  LA::Vector
  displacement_functional(const ShellMesh   &mesh,
                          const std::string &point,
                          const unsigned int component);
} // namespace Biface

#endif
