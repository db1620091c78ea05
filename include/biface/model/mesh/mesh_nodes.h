// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_model_mesh_mesh_nodes_h
#define biface_model_mesh_mesh_nodes_h

#include <deal.II/base/index_set.h>
#include <deal.II/base/point.h>
#include <deal.II/base/types.h>

#include <mpi.h>

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <biface/surface/chart_grid.h>
#include <biface/surface/surface_point.h>

namespace Biface
{
  struct NamedPoint;
  class ReferenceSurface;

  /**
   * A node of the mesh: a vertex with the displacements of all faces.
   *
   * With L layers between L + 1 faces, the unknowns per component are the mean
   * of the displacements of the inner and the outer face,
   * @f$x_0=\frac12(v_0+v_L)@f$, and half the difference over each layer,
   * @f$d_k=\frac12(v_{k+1}-v_k)@f$, so that
   * @f$v_k=x_0+\sum_{j<k}d_j-\sum_{j\ge k}d_j@f$. With one layer they are
   * those of MixedElement. In the displacements of the faces themselves, the
   * stiffness against changes of thickness would drown that against bending,
   * more so with each layer.
   */
  struct Node
  {
    /** The lines of the grid that meet at the node; of no meaning without
     * lines. */
    GridIndex grid_index;

    /** The number of the node, see ChartGrid::node_number(), or its position in
     * QuadrilateralMesh::nodes; it does not depend on the number of ranks. */
    dealii::types::global_cell_index number;

    /** The coordinates @f$(\alpha_1,\alpha_2)@f$, in the internal unit of the
     * surface; not a number without coordinates. */
    dealii::Point<2> alpha;

    SurfacePoint surface;

    /** The heights @f$\delta^-,\delta^+@f$ of the inner and the outer face
     * above the reference surface, see Laminate::face_heights(): the means of
     * both sides if a ply ends here. Unit: length. */
    std::array<double, 2> face_heights;

    /** Half the thickness of each layer, inner layer first: the mean of both
     * sides if a ply ends here; zero where a layer does not exist. Unit:
     * length. */
    std::vector<double> half_thickness;

    /** The global indices of the unknowns, in the order of dof(). */
    std::vector<dealii::types::global_dof_index> dofs;

    /** The positions of the unknowns among the entries of a vector with
     * ghosts. */
    std::vector<unsigned int> entries;

    unsigned int
    n_layers() const
    {
      return half_thickness.size();
    }

    /** The number of unknowns per component: the mean is part 0, half the
     * difference over the layer k is part k + 1. */
    unsigned int
    n_parts() const
    {
      return n_layers() + 1;
    }

    /** The position of an unknown in @p dofs. */
    unsigned int
    position(const unsigned int component, const unsigned int part) const
    {
      return n_parts() * component + part;
    }

    dealii::types::global_dof_index
    dof(const unsigned int component, const unsigned int part) const
    {
      return dofs[position(component, part)];
    }

    /** The derivative of the displacement of the face @p face, from 0 to L, by
     * a part of the unknowns. */
    static double
    sign_of_part(const unsigned int face, const unsigned int part)
    {
      return part == 0 || part <= face ? 1. : -1.;
    }

    /** The height of a face, from 0 to L, above the reference surface. Unit:
     * length. */
    double
    height(const unsigned int face) const
    {
      if (face == n_layers())
        return face_heights[1];
      double height = face_heights[0];
      for (unsigned int k = 0; k < face; ++k)
        height += 2 * half_thickness[k];
      return height;
    }

    /** The parts of the thickness below and above each layer, weighted such
     * that a force that is spread evenly over the thickness does work on the
     * part k + 1: the @f$k@f$-th entry is the derivative of the mean
     * displacement of the wall by @f$d_k@f$. */
    std::vector<double>
    thickness_weights() const;

    /** Whether the node belongs to this rank. */
    bool locally_owned;

    /** Whether any displacement of each face is free. */
    std::array<bool, 2> face_is_free;
  };


  /** The nodes of a mesh on a surface, some of which have names. */
  class MeshNodes
  {
  public:
    /** A mesh without nodes yet. */
    MeshNodes(const MPI_Comm                          communicator,
              std::shared_ptr<const ReferenceSurface> surface,
              const ChartGrid                        &grid,
              const std::vector<NamedPoint>          &points);

    MeshNodes(const MeshNodes &);

    ~MeshNodes();

    const MPI_Comm communicator;
    /** The lines of the mesh, see ChartGrid::has_lines(). */
    const ChartGrid grid;

    /** An edge of the shell, or a line of a mesh from a file. */
    struct NamedEdge
    {
      std::string name;
      /** The nodes of this rank on it, by their positions in @p nodes. */
      std::vector<unsigned int> nodes;
      /** Whether a part of it lies between two cells; the same on all ranks. */
      bool is_inside = false;
    };

    /** The edges: those of a grid in the order of Edge, or the groups of lines
     * of a mesh from a file. */
    std::vector<NamedEdge> edges;

    /** The nodes of this rank at one place that belong to different parts of a
     * mesh from a file, by their positions in @p nodes, see
     * QuadrilateralMesh::joints. Their points on the reference surface have the
     * same displacement, and their sections remain plane. */
    std::vector<std::vector<unsigned int>> joints;

    /** A node where the first direction of the material, see
     * MeshFile::direction, is normal to the surface, so that v_1 and v_2 have
     * no meaning; the same on all ranks. */
    std::optional<dealii::Point<3>> place_without_direction;

    /** Throw InputError that names @p entry and @p text if there is a
     * place_without_direction. */
    void
    require_direction(const std::string &entry, const std::string &text) const;

    /** The position of an edge in @p edges. Throws InputError that names
     * @p entry and @p text if there is no such edge. */
    unsigned int
    find_edge(const std::string &entry,
              const std::string &text,
              const std::string &name) const;

    /** The nodes of this rank: those of its cells and of their neighbors, also
     * across cyclic edges, and all nodes of their joints. */
    std::vector<Node> nodes;

    /** The unknowns of the nodes of this rank. */
    dealii::IndexSet locally_relevant;

    /** The named points, with the coordinates of their nodes, which differ by a
     * period or by round-off from those that were given, and the positions of
     * these nodes; invalid numbers for nodes that exist only on other ranks. */
    std::vector<NamedPoint>   points;
    std::vector<unsigned int> nodes_of_points;

    /** The position of the node of a named point. Throws InputError that names
     * @p entry if there is no such point. */
    unsigned int
    node_of_point(const std::string &entry, const std::string &name) const;

    /** The coordinates of a node in the user's unit, or its position where
     * there are none, in parentheses. */
    std::string
    place_in_words(const Node &node) const;

    const ReferenceSurface &
    get_surface() const
    {
      return *surface;
    }

    /** The diagonal of the box around the reference surface. Unit: length. */
    double
    size() const
    {
      return diameter;
    }

  protected:
    /** Find the nodes of the named points. Throws InputError that names the
     * nearest node if a point is not a node.
     * @param positions those of all nodes of a mesh from a file. */
    void
    find_points(const std::vector<dealii::Point<3>> &positions = {});

    std::shared_ptr<const ReferenceSurface> surface;
    double                                  diameter = 0;
  };
} // namespace Biface

#endif
