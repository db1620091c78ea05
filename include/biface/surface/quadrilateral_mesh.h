// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_surface_quadrilateral_mesh_h
#define biface_surface_quadrilateral_mesh_h

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace Biface
{
  struct MeshOptions;

  /**
   * A mesh of quadrilaterals in space whose parts have names, from a file of
   * another program: the positions of its nodes, its cells, and its groups.
   *
   * All cells of a connected part have the same orientation, that of its first
   * cell in the file: the outward normal is the one about which the nodes of
   * the file run counterclockwise. Sides at which three or more cells meet
   * connect only those that go on smoothly.
   *
   * At a fold, each smooth part of the surface has nodes of its own at the same
   * places.
   */
  struct QuadrilateralMesh
  {
    /** The positions of the nodes of cells, those of further parts that meet at
     * a fold after those of the file. Unit: length. */
    std::vector<dealii::Point<3>> nodes;

    /** The unit normals at the nodes: those of the known surface where they are
     * within the angle of a fold from those of the cells around the node,
     * weighted by their angles there; else the latter. */
    std::vector<dealii::Tensor<1, 3>> normals;

    /** The nodes of the cells in the order of deal.II, lexicographic. */
    std::vector<std::array<unsigned int, 4>> cells;

    /** The numbers of the nodes and the cells in the file, for messages. */
    std::vector<std::size_t> node_numbers, cell_numbers;

    /** A side of a cell, its two nodes. */
    using Side = std::array<unsigned int, 2>;

    /** A part of the mesh with a name. */
    struct Group
    {
      std::string name;
      /** The cells of a group of surfaces. */
      std::vector<unsigned int> cells;
      /** The sides of cells of a group of lines. */
      std::vector<Side> sides;
      /** The nodes of a group of points or lines, in ascending order. */
      std::vector<unsigned int> nodes;
    };

    std::vector<Group> groups;

    /** A side with its cell, and its number there, see dealii::GeometryInfo. */
    struct CellSide
    {
      unsigned int cell, face;
    };
    /** The sides that belong to one cell only. */
    std::vector<CellSide> free_sides;

    /** A side at which parts of the surface meet at an angle or a hinge. */
    struct Fold
    {
      /** All cells that meet there. Two of them that belong to one part have
       * the same nodes at the side. */
      std::vector<CellSide> cells;
      /** The moment per length and angle between the parts; infinite if they
       * are joined rigidly, zero at a hinge. Unit: force. */
      double stiffness;
      /** Pairs of positions in @p cells whose inner, or outer, faces bound one
       * wedge between them: a pressure there acts on the gap between their
       * edges, too. The outward normal points out of the wedge of inner faces.
       */
      std::array<std::vector<std::array<unsigned int, 2>>, 2> wedges;
      /** Whether the inner, or outer, face of each cell bounds a wedge with
       * that of another one. */
      std::array<bool, 2> is_closed{{true, true}};
    };
    std::vector<Fold> folds;

    /** The nodes at one place that belong to different parts. */
    std::vector<std::vector<unsigned int>> joints;

    /** Sentences about what may be meant otherwise: sets of nodes of divided
     * cells, and facets that turn against each other where no surface is known.
     */
    std::vector<std::string> remarks;

    /** Corners that the inner, or outer, faces of three or more parts enclose:
     * their nodes, counterclockwise about the outward normal. */
    std::array<std::vector<std::vector<unsigned int>>, 2> corners;

    /** The center of a cell, the mean of its nodes. */
    dealii::Point<3>
    center(const unsigned int cell) const;

    /** The number in the file and the center of a cell, for messages. */
    std::string
    cell_in_words(const unsigned int cell) const;

    /** A side of a cell by its number, see dealii::GeometryInfo, in the
     * direction in which it runs around the cell counterclockwise. */
    Side
    side(const unsigned int cell, const unsigned int face) const;

    /** A side whatever its direction: with the lower number first, as in
     * Group::sides. */
    static Side
    without_direction(const Side &side)
    {
      return {{std::min(side[0], side[1]), std::max(side[0], side[1])}};
    }
  };


  /**
   * Read a mesh from the text of a file of Gmsh, MSH 2.2 or 4.1 in ASCII, or of
   * Abaqus or CalculiX. Quadrilaterals of second order count as those of their
   * corners. Names of groups are those of physical groups, or their numbers
   * where they have none, and of sets of nodes and elements, in capitals.
   *
   * Throws InputError, naming the file and the line, if the text is anything
   * else; naming the cell or the node and its position, if there are solids, or
   * triangles that are not divided, if a cell is concave or degenerate, if
   * cells cover each other, if the surface has one side only, or if two nodes
   * are at one place; and like prepare_mesh().
   */
  QuadrilateralMesh
  parse_mesh(const std::string &text,
             const std::string &file_name,
             const MeshOptions &options);
} // namespace Biface

#endif
