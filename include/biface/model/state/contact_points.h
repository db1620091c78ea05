// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_model_state_contact_points_h
#define biface_model_state_contact_points_h

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <array>
#include <vector>

#include <biface/base/linear_algebra.h>
#include <biface/contact/active_set.h>
#include <biface/contact/contact_state.h>
#include <biface/laminate/resultants.h>
#include <biface/model/mesh/shell_mesh.h>

namespace Biface
{
  enum class MortarMatrix;


  /**
   * The points of a face of the shell at which it may touch a body, each with a
   * multiplier of its own: the nodes, or @f$k\times k@f$ points in each cell,
   * at the middle of equal parts of it. The face is bilinear between the
   * deformed positions of the nodes.
   *
   * Each rank has the points of its nodes or cells, numbered consecutively:
   * like ShellMesh::nodes, or cell by cell.
   */
  class ContactPoints
  {
  public:
    /** The points of a face.
     * @param per_side the number k; 0 for the nodes.
     * @param mass that of the multipliers of nodes. */
    ContactPoints(const ShellMesh       &mesh,
                  const Resultants::Face face,
                  const unsigned int     per_side,
                  const MortarMatrix     mass);

    /** The points of a state, in which the kind of the mass of multipliers does
     * not show. */
    ContactPoints(const ShellMesh       &mesh,
                  const Resultants::Face face,
                  const ContactState    &state);

    /** A point of a cell. */
    struct OnCell
    {
      /** The weights of the vertices in the position of the point, whose sum is
       * 1. */
      std::array<double, 4> position;
      /** The forces on the vertices by a traction at the point, with a density
       * of area of 1 and with those that are odd in either coordinate, see
       * ElementGeometry::area_density(). */
      std::array<std::array<double, 4>, 3> forces;
    };

    /** The points of a cell, which are the same in all cells. Nodes belong to
     * all cells around. */
    const std::vector<OnCell> &
    on_cell() const
    {
      return points_on_cell;
    }

    /** The number of a point of a cell among the points of this rank.
     * @param i its position in on_cell(). */
    unsigned int
    number(const Cell &cell, const unsigned int i) const
    {
      return at_nodes() ? cell.nodes[i]
                        : (&cell - mesh.cells.data()) * per_cell() + i;
    }

    /** The areas by which a traction at a point of a cell acts on the vertices.
     * Unit: area.
     * @param i the position of the point in on_cell(). */
    std::array<double, 4>
    areas(const Cell &cell, const unsigned int i) const
    {
      const auto           &of_density = points_on_cell[i].forces;
      std::array<double, 4> result;
      for (unsigned int v = 0; v < 4; ++v)
        result[v] = cell.geometry.weight * of_density[0][v];
      if (!cell.geometry.along_lines)
        {
          const std::array<double, 3> density = cell.geometry.area_density();
          for (unsigned int v = 0; v < 4; ++v)
            result[v] +=
              density[1] * of_density[1][v] + density[2] * of_density[2][v];
        }
      return result;
    }

    /** The area of a point of a cell, the sum of areas(). Unit: area. */
    double
    area(const Cell &cell, const unsigned int i) const
    {
      double sum = 0;
      for (const double of_vertex : areas(cell, i))
        sum += of_vertex;
      return sum;
    }

    bool
    at_nodes() const
    {
      return points_per_side == 0;
    }

    /** The number of points in a cell; 0 if they are the nodes. */
    unsigned int
    per_cell() const
    {
      return points_per_side * points_per_side;
    }

    /** The number of points along a side of a cell; 0 if they are the nodes. */
    unsigned int
    per_side() const
    {
      return points_per_side;
    }

    /** The number of points on this rank. */
    unsigned int
    size() const
    {
      return at_nodes() ? mesh.nodes.size() : mesh.cells.size() * per_cell();
    }

    /** Whether a point belongs to this rank. */
    bool
    is_owned(const unsigned int point) const
    {
      return at_nodes() ? mesh.nodes[point].locally_owned : true;
    }

    /** Whether a point may touch a body: supports do not hold it, nor all nodes
     * around. */
    bool
    may_touch(const unsigned int point) const;

    /** The value at a point of a function of the nodes that is bilinear between
     * them. */
    template <typename Function>
    auto
    interpolate(const unsigned int point, const Function &at_node) const
    {
      if (at_nodes())
        return at_node(mesh.nodes[point]);
      const auto &nodes = cell_of(point).nodes;
      const auto &part  = points_on_cell[point % per_cell()].position;
      auto        value = part[0] * at_node(mesh.nodes[nodes[0]]);
      for (unsigned int v = 1; v < 4; ++v)
        value += part[v] * at_node(mesh.nodes[nodes[v]]);
      return value;
    }

    /** The deformed position of a point. */
    dealii::Point<3>
    position(const LA::Vector &displacement, const unsigned int point) const;

    /** The motion of a point by an increment, a vector with ghosts. */
    dealii::Tensor<1, 3>
    motion(const LA::Vector &increment, const unsigned int point) const;

    /** The nodes of this rank around marked points of any rank, or the marked
     * points themselves if these are nodes. Must be called on all ranks. */
    ActiveSet
    nodes_around(const ActiveSet &marked) const;

  private:
    /** The cell of a point that is no node. */
    const Cell &
    cell_of(const unsigned int point) const
    {
      return mesh.cells[point / per_cell()];
    }

    const ShellMesh       &mesh;
    const Resultants::Face face;
    const unsigned int     points_per_side;
    std::vector<OnCell>    points_on_cell;
  };
} // namespace Biface

#endif
