// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_model_mesh_shell_mesh_h
#define biface_model_mesh_shell_mesh_h

#include <deal.II/base/index_set.h>
#include <deal.II/base/types.h>
#include <deal.II/distributed/tria_base.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/fe/fe_system.h>
#include <deal.II/lac/affine_constraints.h>

#include <array>
#include <memory>
#include <optional>
#include <vector>

#include <biface/base/linear_algebra.h>
#include <biface/element/mixed_element.h>
#include <biface/element/shell_fe_values.h>
#include <biface/input/formula.h>
#include <biface/laminate/layup.h>
#include <biface/model/mesh/constraints.h>
#include <biface/model/mesh/mesh_nodes.h>
#include <biface/model/mesh/supports.h>
#include <biface/surface/chart_grid.h>
#include <biface/surface/reference_surface.h>

namespace Biface
{
  /** A locally owned cell of the mesh. */
  struct Cell
  {
    std::array<dealii::types::global_dof_index, MixedElement::n_dofs> dofs;
    /** The positions of the dofs in ShellMesh::locally_relevant, and so among
     * the entries of a vector with ghosts. */
    std::array<unsigned int, MixedElement::n_dofs> positions;
    /** Positions in ShellMesh::nodes. */
    std::array<unsigned int, 4> nodes;
    /** Position in ShellMesh::strips. */
    unsigned int    strip;
    ElementGeometry geometry;
    /** See ChartGrid::cell_number(). */
    dealii::types::global_cell_index number;

    /**
     * Where a ply ends at a side of the cell, the faces of the cell differ from
     * those of the nodes. Since displacements are linear in the height, those
     * of the faces of the cell follow from the unknowns of the node,
     * @f$\bar v_c=\bar v+s\tilde v@f$ and @f$\tilde v_c=r\tilde v@f$. This
     * is exact for rigid motions.
     */
    struct FaceOffset
    {
      double s = 0, r = 1;
    };

    /** By vertex; empty if the faces of the cell are those of the nodes. */
    std::optional<std::array<FaceOffset, 4>> face_offsets;

    /** From the unknowns of the nodes to those of the faces of the cell. */
    void
    to_own_faces(MixedElement::NodalVector &V) const;

    /** From forces on the faces of the cell to those on the nodes. */
    void
    to_nodes(MixedElement::NodalVector &forces) const;

    /** From a tangent for the faces of the cell to one for the nodes. */
    void
    to_nodes(MixedElement::NodalMatrix &K) const;

    /** The derivative of the displacement of a face of the node by the half
     * difference of the faces of the cell. */
    double
    sign_of_face(const unsigned int vertex, const unsigned int face) const;
  };


  /** The plies between two lines of the first coordinate. */
  struct Strip
  {
    /** At the middle of the strip, which gives the stiffness of the cells. */
    Laminate laminate;
    /** The same plies at both lines. */
    std::array<Laminate, 2> at_lines;
  };


  /** A side of a locally owned cell on an edge of the shell. */
  struct BoundarySegment
  {
    Edge edge;
    /** Position in ShellMesh::cells. */
    unsigned int cell;
    /** The numbers of the vertices in the cell. */
    std::array<unsigned int, 2> vertices;
    /** Positions in ShellMesh::nodes. */
    std::array<unsigned int, 2> nodes;
    /** On the reference surface. */
    double length;
  };


  /**
   * The mesh with its degrees of freedom: everything that follows from the
   * surface, the grid, the plies and the supports.
   *
   * The data of cells and nodes are plain arrays, filled once, so that
   * iterations access memory in order. Each rank has the cells it owns and the
   * nodes of these cells and of their neighbors, also across cyclic edges.
   */
  class ShellMesh : public MeshNodes
  {
  public:
    /**
     * Throws InputError if @f$A_2@f$ vanishes within the grid, if the thickness
     * of a ply is not positive, if a face lies beyond a center of curvature, if
     * an edge that does not exist is supported, or if a point is not a node.
     */
    ShellMesh(const MPI_Comm                          communicator,
              std::unique_ptr<const ReferenceSurface> surface,
              const ChartGrid                        &grid,
              const Layup                            &layup,
              const Supports                         &supports,
              const std::vector<NamedPoint>          &points = {},
              const StrainSampling sampling      = StrainSampling::vertices,
              const Interpolation  interpolation = Interpolation::components);

    /** The same mesh with other plies, of which it shares all but these; null
     * if they place the faces elsewhere. Throws InputError if a ply ends
     * between two lines. */
    std::shared_ptr<const ShellMesh>
    with_layup(const Layup &other) const;

    Layup layup;

    const StrainSampling sampling;
    const Interpolation  interpolation;

    /** Between the lines of the first coordinate, in ascending order. */
    std::vector<Strip> strips;

    std::vector<Cell> cells;

    /** Nodes that share a cell with the node of the same position, including
     * itself. Complete for locally owned nodes. Not across cyclic edges. */
    std::vector<std::vector<unsigned int>> neighbors;

    /** Sides of locally owned cells on the edges of the shell. */
    std::vector<BoundarySegment> boundary;

    dealii::IndexSet locally_owned;

    /** See make_constraints(). */
    dealii::AffineConstraints<double>   constraints;
    std::vector<PrescribedDisplacement> prescribed;
    SupportedNodes                      supported;

    const dealii::DoFHandler<2, 3> &
    get_dof_handler() const
    {
      return *dof_handler;
    }

    /** The maximum thickness of the shell. Unit: length. */
    double
    thickness() const
    {
      return max_thickness;
    }

    /** The stiffness of the shell under pressure, from which the stiffness of
     * contact follows: the lowest Laminate::thickness_stiffness(). In a
     * membrane it would be so high that the pressure shows the rounding of
     * positions; it is limited to 1000 times the lowest
     * Laminate::membrane_stiffness() over the square of size(). Unit:
     * pressure/length. */
    double
    wall_stiffness() const;

    /** Whether supports prescribe displacements, on any rank. */
    bool
    prescribes_displacements() const;

    /** Whether they prescribe some that have a given factor, see
     * SupportEquation. */
    bool
    prescribes_displacements(const unsigned int factor) const;

    /** The number of unknowns not determined by supports. */
    dealii::types::global_dof_index
    n_unknowns() const
    {
      return n_free;
    }

    /** The number of nodes on all ranks. */
    dealii::types::global_dof_index
    n_nodes() const
    {
      return dof_handler->n_dofs() / 6;
    }

    /** The number of cells on all ranks. */
    dealii::types::global_dof_index
    n_cells() const
    {
      return triangulation->n_global_active_cells();
    }

    /** A vector with entries for all nodes of this rank, including ghosts. */
    LA::Vector
    ghosted_vector() const;

    /** A vector of the locally owned entries. */
    LA::Vector
    owned_vector() const;

    /** Displacement of a face at a node, in the frame of the node. */
    dealii::Tensor<1, 3>
    displacement(const LA::Vector  &V,
                 const Node        &node,
                 const unsigned int face) const;

    /** Position of a face at a node in the deformed shell. */
    dealii::Point<3>
    deformed_position(const LA::Vector  &V,
                      const Node        &node,
                      const unsigned int face) const;

    /** Add forces on the faces of a cell at its vertices to those of all nodes,
     * regardless of supports. */
    void
    add_nodal_forces(const Cell                      &cell,
                     const MixedElement::NodalVector &force,
                     LA::Vector                      &nodal_forces) const;

    /** Move the forces on constrained unknowns to the free ones that they
     * depend on. */
    void
    condense(LA::Vector &nodal_forces) const;

    /** The force on a face at a node, in the frame of the node.
     * @param nodal_forces conjugate to the unknowns, see Node::dofs. */
    dealii::Tensor<1, 3>
    force_on_face(const LA::Vector  &nodal_forces,
                  const Node        &node,
                  const unsigned int face) const;

    /** The displacements of the faces of a cell, see MixedElement::Part.
     * @param V a vector with ghosts. */
    MixedElement::NodalVector
    cell_values(const LA::Vector &V, const Cell &cell) const;

  private:
    /** A copy on the same triangulation. */
    ShellMesh(const ShellMesh &) = default;

    /** @param face_heights on each line of the first coordinate. */
    void
    collect_cells_and_nodes(
      const std::vector<std::array<double, 2>> &face_heights);

    /** Add the nodes to which cyclic edges couple those of this rank. */
    void
    add_cyclic_nodes(const std::vector<std::array<double, 2>> &face_heights);

    std::shared_ptr<const dealii::parallel::TriangulationBase<2, 3>>
                                                    triangulation;
    std::shared_ptr<const dealii::DoFHandler<2, 3>> dof_handler;
    dealii::types::global_dof_index                 n_free        = 0;
    double                                          max_thickness = 0;
  };


  /** Formulas of the position, see parse_position_formula(), at all nodes of
   * this rank: `[node][i]` is the i-th formula's value. Throws InputError on
   * all ranks where one is not finite at any node. */
  std::vector<std::vector<double>>
  evaluate_at_nodes(const std::vector<Formula> &formulas,
                    const ShellMesh            &mesh);
} // namespace Biface

#endif
