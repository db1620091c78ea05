// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_model_shell_mesh_h
#define biface_model_shell_mesh_h

#include <deal.II/base/index_set.h>
#include <deal.II/base/types.h>
#include <deal.II/distributed/tria_base.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/fe/fe_system.h>
#include <deal.II/lac/affine_constraints.h>

#include <array>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include <biface/base/linear_algebra.h>
#include <biface/element/mixed_element.h>
#include <biface/element/shell_fe_values.h>
#include <biface/laminate/layup.h>
#include <biface/model/named_points.h>
#include <biface/model/supports.h>
#include <biface/surface/chart_grid.h>
#include <biface/surface/reference_surface.h>

namespace Biface
{
  /** A node of the mesh: a vertex with the displacements of both faces. */
  struct Node
  {
    /** The node's coordinates @f$(\alpha_1,\alpha_2)@f$, in the surface's
     * internal unit. */
    dealii::Point<2> alpha;

    SurfacePoint surface;

    /** @f$\delta^-,\delta^+@f$, see Laminate::face_heights(). Unit: length. */
    std::array<double, 2> face_heights;

    /** Global indices of @f$v_1^-,v_1^+,v_2^-,v_2^+,v_3^-,v_3^+@f$. */
    std::array<dealii::types::global_dof_index, 6> dofs;

    /** See ChartGrid::node_number(): the same on any number of ranks. */
    dealii::types::global_cell_index number;

    /** Whether the node belongs to this rank. */
    bool locally_owned;

    /** Whether any displacement of the outer face is free. */
    bool outer_face_free;
  };


  /** A locally owned cell of the mesh. */
  struct Cell
  {
    std::array<dealii::types::global_dof_index, MixedElement::n_dofs> dofs;
    /** Positions in ShellMesh::nodes. */
    std::array<unsigned int, 4> nodes;
    /** Position in ShellMesh::strips. */
    unsigned int    strip;
    ElementGeometry geometry;
    /** See ChartGrid::cell_number(). */
    dealii::types::global_cell_index number;
  };


  /** The plies between two lines of the first coordinate. */
  struct Strip
  {
    /** In the middle: those that give the cells their stiffness. */
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
    /** Of the cell. */
    std::array<unsigned int, 2> vertices;
    /** Positions in ShellMesh::nodes. */
    std::array<unsigned int, 2> nodes;
    /** On the reference surface. */
    double length;
  };


  /** A displacement that a support prescribes:
   * @f$v = f\,v_{other} + \bar v@f$, where @f$\bar v@f$ grows with the load
   * factor. */
  struct PrescribedDisplacement
  {
    dealii::types::global_dof_index dof;
    /** Invalid where f is zero. */
    dealii::types::global_dof_index other;
    double                          factor;
    double                          value;
  };


  /**
   * The mesh with its degrees of freedom: what is fixed once the surface, the
   * grid, the plies and the supports are known.
   *
   * Cells and nodes are plain arrays, filled once, so that what runs in every
   * iteration walks through memory in order. Each rank has the cells it owns
   * and the nodes of these cells and of their neighbors.
   */
  class ShellMesh
  {
  public:
    /**
     * Throws InputError where @f$A_2@f$ vanishes within the grid, where plies
     * have no positive thickness or a face lies beyond a center of curvature,
     * or where an edge that does not exist is supported.
     */
    ShellMesh(const MPI_Comm                          communicator,
              std::unique_ptr<const ReferenceSurface> surface,
              const ChartGrid                        &grid,
              const Layup                            &layup,
              const Supports                         &supports,
              const std::vector<NamedPoint>          &points = {});

    const MPI_Comm communicator;

    std::vector<Cell> cells;
    std::vector<Node> nodes;

    const ChartGrid grid;
    const Layup     layup;

    /** By the lines of the first coordinate, rising. */
    std::vector<Strip> strips;

    /** Nodes that share a cell with the node of the same position, itself
     * included. Complete for locally owned nodes. */
    std::vector<std::vector<unsigned int>> neighbors;

    /** Sides of locally owned cells on the shell's edges. */
    std::vector<BoundarySegment> boundary;

    const std::vector<NamedPoint> points;

    /** Displacements that are prescribed and not zero. */
    std::vector<PrescribedDisplacement> prescribed;

    dealii::IndexSet locally_owned;
    dealii::IndexSet locally_relevant;
    /** The supports with zero prescribed displacements. */
    dealii::AffineConstraints<double> constraints;

    const ReferenceSurface &
    get_surface() const
    {
      return *surface;
    }

    const dealii::DoFHandler<2, 3> &
    get_dof_handler() const
    {
      return dof_handler;
    }

    /** The shell's greatest thickness. Unit: length. */
    double
    thickness() const
    {
      return greatest_thickness;
    }

    /** Displacements that are not given by supports. */
    dealii::types::global_dof_index
    n_unknowns() const
    {
      return n_free;
    }

    /** Nodes on all ranks. */
    dealii::types::global_dof_index
    n_nodes() const
    {
      return dof_handler.n_dofs() / 6;
    }

    /** Cells on all ranks. */
    dealii::types::global_dof_index
    n_cells() const
    {
      return triangulation->n_global_active_cells();
    }

    /** The diagonal of the box around the reference surface. Unit: length. */
    double
    size() const
    {
      return diameter;
    }

    /**
     * The node of a named point: its position in nodes, or an invalid number
     * where it is on other ranks only.
     *
     * Throws InputError, naming @p entry, where there is no such point.
     */
    unsigned int
    node_of_point(const std::string &entry, const std::string &name) const;

    /**
     * The vector @f$\mathbf l@f$ for which @f$\mathbf l\cdot\mathbf V@f$ is a
     * Cartesian component of the displacement of the middle surface at a named
     * point.
     */
    LA::Vector
    displacement_functional(const std::string &point,
                            const unsigned int component) const;

    /** A vector whose entries can be read at all nodes of this rank. */
    LA::Vector
    ghosted_vector() const;

    /** A vector of the locally owned entries. */
    LA::Vector
    owned_vector() const;

    /** Displacement of a face at a node, in the node's frame. */
    dealii::Tensor<1, 3>
    displacement(const LA::Vector  &V,
                 const Node        &node,
                 const unsigned int face) const;

    /** Position of a face at a node in the deformed shell. */
    dealii::Point<3>
    deformed_position(const LA::Vector  &V,
                      const Node        &node,
                      const unsigned int face) const;

    /** Add forces on the nodes of a cell to those of all nodes. */
    void
    add_nodal_forces(const Cell                      &cell,
                     const MixedElement::NodalVector &force,
                     LA::Vector                      &nodal_forces) const;

    /** The displacements of a cell. */
    MixedElement::NodalVector
    cell_values(const LA::Vector &V, const Cell &cell) const;

  private:
    void
    make_strips(const ChartGrid &grid);

    /** Check that the surface and both faces are regular at all grid points. */
    void
    check_geometry(const ChartGrid &grid) const;

    void
    collect_cells_and_nodes(const ChartGrid &grid);

    void
    find_points();

    void
    make_constraints(const Supports &supports);

    std::unique_ptr<const ReferenceSurface>                    surface;
    std::unique_ptr<dealii::parallel::TriangulationBase<2, 3>> triangulation;
    const dealii::FESystem<2, 3>                               fe;
    dealii::DoFHandler<2, 3>                                   dof_handler;
    dealii::types::global_dof_index                            n_free   = 0;
    double                                                     diameter = 0;
    double greatest_thickness                                           = 0;
    /** Laminate::face_heights() on each line of the first coordinate: where a
     * ply ends there, the mean of both sides. */
    std::vector<std::array<double, 2>> line_faces;
    /** Nodes of this rank on the shell's edges. */
    std::array<std::set<unsigned int>, 4> edge_nodes;
    /** Of each named point. */
    std::vector<unsigned int> nodes_of_points;
  };
} // namespace Biface

#endif
