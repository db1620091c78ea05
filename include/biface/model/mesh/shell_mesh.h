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
#include <functional>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include <biface/base/linear_algebra.h>
#include <biface/element/element_geometry.h>
#include <biface/element/mixed_element.h>
#include <biface/model/mesh/constraints.h>
#include <biface/model/mesh/fold_side.h>
#include <biface/model/mesh/mesh_nodes.h>

#include <boost/iterator/permutation_iterator.hpp>
#include <boost/range/iterator_range.hpp>

namespace Biface
{
  class Formula;
  class Imperfection;
  class Layup;
  struct MeshFile;
  struct NamedPoint;
  struct PlacesOfStrips;
  class PliesOfCells;
  struct QuadrilateralMesh;
  class ReferenceSurface;
  struct Strip;
  struct Supports;

  /**
   * An element on a locally owned cell of the triangulation, between two faces
   * of the shell: one of its layers, which has stiffness and mass, or the whole
   * wall, on which loads and contact act. In a shell with a single layer, the
   * layer is the wall.
   *
   * The unknowns of the element are those of MixedElement, for its own two
   * faces; they are linear in the unknowns of the nodes, see Node.
   */
  struct Cell
  {
    /** The global indices of the unknowns of the nodes, vertex by vertex, in
     * the order of Node::dofs. */
    std::vector<dealii::types::global_dof_index> dofs;
    /** The positions of the dofs in ShellMesh::locally_relevant, which are
     * those among the entries of a vector with ghosts. */
    std::vector<unsigned int> positions;
    /** The positions of the nodes in ShellMesh::nodes, by vertex. */
    std::array<unsigned int, 4> nodes;
    /** The position of the element in ShellMesh::cells. */
    unsigned int position;
    /** The position of the strip in ShellMesh::strips. */
    unsigned int    strip;
    ElementGeometry geometry;
    /** The number of the cell, see ChartGrid::cell_number(), or its position in
     * QuadrilateralMesh::cells: the same for the wall and its layers. */
    dealii::types::global_cell_index column;
    /** The number of the element, independent of the number of ranks. */
    dealii::types::global_cell_index number;
    bool                             is_wall, is_layer;
    /** The number of the layer, counted from the inner face. */
    unsigned int layer;

    /** The contribution of the half difference over one of the layers at a node
     * to the mean and to the half difference of the faces of the element. */
    struct Contribution
    {
      double mean = 0, half_difference = 1;
    };

    /** The contributions by vertex and layer; empty if the unknowns of the
     * element are those of the nodes. */
    std::vector<Contribution> contributions;

    /** The unknowns of the element from those of the nodes, which are in the
     * order of @p dofs. */
    MixedElement::NodalVector
    element_unknowns(const std::vector<double> &values) const;

    /** Convert forces on the faces of the element into those on the unknowns of
     * the nodes, in the order of @p dofs. */
    void
    to_nodes(const MixedElement::NodalVector &forces,
             std::vector<double>             &of_nodes) const;

    /** Convert a tangent for the faces of the element into one for the unknowns
     * of the nodes, row by row. */
    void
    to_nodes(const MixedElement::NodalMatrix &K,
             std::vector<double>             &of_nodes) const;

    /** The derivative of the displacement of the inner or the outer face of the
     * node by the half difference of the faces of the element, which is a
     * wall. */
    double
    sign_of_face(const unsigned int vertex, const unsigned int face) const;
  };


  /** A side of a locally owned cell on an edge of the shell; for a side on
   * several named lines there is a segment for each. */
  struct BoundarySegment
  {
    /** The position of the edge in MeshNodes::edges. */
    unsigned int edge;
    /** The position of the cell in ShellMesh::cells. */
    unsigned int cell;
    /** The numbers of the vertices in the cell. */
    std::array<unsigned int, 2> vertices;
    /** The positions of the nodes in ShellMesh::nodes. */
    std::array<unsigned int, 2> nodes;
    /** The length of the side on the reference surface. Unit: length. */
    double length;
    /** The outward normal of the shell times that of the edge, in the frames of
     * the nodes: unit vectors along the side. */
    std::array<dealii::Tensor<1, 3>, 2> axes;
    /** The curvatures of the surface along the side at the nodes. Unit:
     * 1/length. */
    std::array<double, 2> curvatures;

    /** Whether the side is on an edge of a grid. */
    bool
    is_on(const Edge of_grid) const
    {
      return edge == static_cast<unsigned int>(of_grid);
    }
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
              const std::vector<NamedPoint>          &points,
              const Formulation formulation = Formulation::standard);

    /**
     * The mesh of a file, with Formulation::standard.
     *
     * Throws InputError if the direction of the material is not finite or
     * normal to a cell, if a face is turned inside out, or if an edge or a
     * point does not exist.
     *
     * @param surface without coordinates.
     * @param grid without lines, of which only the distribution counts.
     */
    ShellMesh(const MPI_Comm                          communicator,
              std::unique_ptr<const ReferenceSurface> surface,
              const ChartGrid                        &grid,
              const MeshFile                         &file,
              const Layup                            &layup,
              const Supports                         &supports,
              const std::vector<NamedPoint>          &points);

    /** Let the stress-free shell deviate from the surface, but where supports
     * hold it. Throws InputError, see Imperfection, and if the deviation is
     * steeper than 0.3 between two nodes. */
    void
    add_imperfection(const Imperfection &imperfection);

    /** A mesh with other plies, which shares everything else with this one;
     * null if they place the faces elsewhere. Throws InputError if a ply ends
     * between two lines. */
    std::shared_ptr<const ShellMesh>
    with_layup(const Layup &other) const;

    ~ShellMesh();

    const Layup &
    get_layup() const
    {
      return *layup;
    }

    const Formulation formulation;
    /** Whether the thickness strain is that of the distance of the faces, see
     * NormalThickness: if the wall has several layers. */
    const bool normal_thickness;

    /** The strips of the whole wall between the lines of the first coordinate,
     * in ascending order, or on a mesh from a file those of PlacesOfStrips,
     * which may be of this rank alone; followed by those of single layers if
     * there are several. */
    std::vector<Strip> strips;

    /** The elements, those on the same cell of the triangulation next to each
     * other: the wall first, then the layers that exist there. */
    std::vector<Cell> cells;

    /** The positions in @p cells of the layers, and of the walls. */
    std::vector<unsigned int> layers, walls;

    /** The elements on which loads and contact act, to loop over. */
    auto
    wall_elements() const
    {
      return boost::make_iterator_range(
        boost::make_permutation_iterator(cells.begin(), walls.begin()),
        boost::make_permutation_iterator(cells.begin(), walls.end()));
    }

    /** The positions in @p cells of the first layer of a wall, and of the one
     * after its last. */
    std::pair<unsigned int, unsigned int>
    layers_of(const unsigned int wall) const;

    /** The position in @p cells of the wall to which a layer belongs. */
    unsigned int
    wall_of(unsigned int layer) const
    {
      while (!cells[layer].is_wall)
        --layer;
      return layer;
    }

    /** The number of layers at places where all exist. */
    unsigned int
    n_layers() const
    {
      return n_all_layers;
    }

    /** The number of unknowns of a node. */
    unsigned int
    n_dofs_per_node() const
    {
      return 3 * (n_layers() + 1);
    }

    /** The number of strips of the whole wall. */
    unsigned int
    n_strips() const
    {
      return n_walls;
    }

    /** The nodes that share a cell with each node, including itself, by their
     * positions in @p nodes. Complete for locally owned nodes. Not across
     * cyclic edges. */
    std::vector<std::vector<unsigned int>> neighbors;

    /** The sides of locally owned cells on the edges. */
    std::vector<BoundarySegment> boundary;

    /** The sides at which parts of the shell meet at an angle or a hinge, each
     * on one rank. */
    std::vector<FoldSide> folds;

    /** The number of sides at folds on all ranks. */
    unsigned int
    n_folds() const
    {
      return n_all_folds;
    }

    /** The corners that inner, or outer, faces enclose, each on one rank: the
     * positions of the nodes of their parts, see QuadrilateralMesh::corners. */
    std::array<std::vector<std::vector<unsigned int>>, 2> corners;

    /** The nodes at sides of a mesh from a file where the inner, or outer, face
     * ends, except in planes of symmetry: positions in @p nodes. */
    std::array<std::vector<unsigned int>, 2> ends_of_faces;

    /** The coordinates x, y and z of all nodes in planes of symmetry of a mesh
     * from a file that are normal to them; the same on all ranks. Unit:
     * length. */
    std::array<std::vector<double>, 3> symmetry_planes;

    dealii::IndexSet locally_owned;

    /** The displacements of the stress-free shell from the surface, readable
     * at all nodes of this rank: its imperfections. Empty if there are none. */
    LA::Vector imperfection;

    /** The supports as constraints, prescribed displacements, and equations,
     * see make_constraints(). */
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
    wall_stiffness() const
    {
      return lowest_stiffness;
    }

    /** The stiffness from which that of sticking follows: where
     * wall_stiffness() is limited, it is lower by the same part once more,
     * since nodes that stick resist the stretch of a membrane, and parts of it
     * cannot stick and others slip if they stick within far less than this.
     * Unit: pressure/length. */
    double
    wall_stiffness_sideways() const
    {
      return lowest_stiffness_sideways;
    }

    /** Whether supports prescribe displacements, on any rank. */
    bool
    prescribes_displacements() const;

    /** Whether supports prescribe displacements that have a given factor, see
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
      return dof_handler->n_dofs() / n_dofs_per_node();
    }

    /** The number of cells of the triangulation on all ranks. */
    dealii::types::global_dof_index
    n_cells() const
    {
      return triangulation->n_global_active_cells();
    }

    /** The number of elements on all ranks, see Cell. */
    dealii::types::global_dof_index
    n_elements() const
    {
      return n_all_elements;
    }

    /** A vector with entries for all nodes of this rank, including ghosts. */
    LA::Vector
    ghosted_vector() const;

    /** A vector of the locally owned entries. */
    LA::Vector
    owned_vector() const;

    /** The displacement of the inner or outer face at a node, in the frame of
     * the node. */
    dealii::Tensor<1, 3>
    displacement(const LA::Vector  &V,
                 const Node        &node,
                 const unsigned int face) const;

    /** The displacement of any face at a node, from 0 to L, in the frame of the
     * node, see Node. */
    dealii::Tensor<1, 3>
    displacement_of_any_face(const LA::Vector  &V,
                             const Node        &node,
                             const unsigned int face) const;

    /** The position of the inner or outer face at a node in the deformed
     * shell. */
    dealii::Point<3>
    deformed_position(const LA::Vector  &V,
                      const Node        &node,
                      const unsigned int face) const;

    /** The position of any face at a node, from 0 to L, in the deformed
     * shell. */
    dealii::Point<3>
    position_of_any_face(const LA::Vector  &V,
                         const Node        &node,
                         const unsigned int face) const;

    /** The position in the deformed shell of the point of a node at a height,
     * see Node::face_heights. */
    dealii::Point<3>
    position_at_height(const LA::Vector &V,
                       const Node       &node,
                       const double      height) const;

    /** Add forces on the faces of a cell at its vertices to a vector of the
     * forces on all nodes, regardless of supports. */
    void
    add_nodal_forces(const Cell                      &cell,
                     const MixedElement::NodalVector &force,
                     LA::Vector                      &nodal_forces) const;

    /** Move the forces on constrained unknowns to the free ones that they
     * depend on. */
    void
    condense(LA::Vector &nodal_forces) const;

    /** The force on any face at a node, from 0 to L, in the frame of the node.
     * @param nodal_forces conjugate to the unknowns, see Node::dofs. */
    dealii::Tensor<1, 3>
    force_on_any_face(const LA::Vector  &nodal_forces,
                      const Node        &node,
                      const unsigned int face) const;

    /** The unknowns of the faces of a cell at its vertices, see
     * MixedElement::Part.
     * @param V a vector with ghosts. */
    MixedElement::NodalVector
    cell_values(const LA::Vector &V, const Cell &cell) const;

  private:
    /** Set wall_stiffness() and wall_stiffness_sideways(). */
    void
    set_wall_stiffness();

    /** A copy on the same triangulation. */
    ShellMesh(const ShellMesh &);

    /** Distribute the unknowns on the triangulation. */
    void
    distribute_dofs();

    /** Set what follows from cells and nodes, and from the supports.
     * @param positions those of all nodes of a mesh from a file. */
    void
    complete(const Supports                      &supports,
             const std::vector<dealii::Point<3>> &positions = {});

    /** Throw InputError if supports use directions that have no meaning. */
    void
    check_components(const Supports &supports) const;

    /** Create cells, nodes and edges from a file.
     * @param strip_of_cell the positions in @p strips of the walls of the cells
     * that this rank owns, and of those across its folds.
     * @param layers_of_strips see PlacesOfStrips::make_strips(). */
    void
    collect_from_file(
      const MeshFile                               &file,
      const Supports                               &supports,
      const PliesOfCells                           &plies,
      const std::map<unsigned int, unsigned int>   &strip_of_cell,
      const std::vector<std::vector<unsigned int>> &layers_of_strips);

    /** Add the nodes of other ranks at the joints of this one.
     * @param make_node makes a node with a number without its unknowns.
     * @param [in,out] node_of_number the positions of the nodes of this rank by
     * their numbers. */
    void
    add_nodes_of_joints(
      const QuadrilateralMesh                       &mesh,
      const std::function<Node(const unsigned int)> &make_node,
      std::map<unsigned int, unsigned int>          &node_of_number);

    /** The displacements of the nodes of joints by given deviations along their
     * normals: in space, that of each joint fits them all best.
     * @param deviations by the position of the node. */
    void
    set_deviation_of_joints(const std::vector<double> &deviations,
                            LA::Vector                &V) const;

    /** The largest curvature at a locally owned node, without its sign. Unit:
     * 1/length. */
    double
    curvature(const unsigned int node) const;

    /** Throw InputError if the imperfection is steep. */
    void
    check_slope_of_imperfection() const;

    /** Take the plies, and say how they follow the strain of the thickness. */
    void
    set_layup(const Layup &new_layup);

    /** The contributions of the layers at a node to the whole wall beside it,
     * over which displacements are linear in the height.
     * @param own the heights of its two faces. */
    static std::vector<Cell::Contribution>
    contributions_to_wall(const Node &node, const std::array<double, 2> &own);

    /** The contributions of the layers at a node to a layer beside it. Where a
     * ply ends, the heights of the faces there are not those of the node. The
     * stiffest layer goes on along its director; the others remain connected
     * with it, each with its own director.
     * @param own the heights of all faces beside the node. */
    static std::vector<Cell::Contribution>
    contributions_to_layer(const Node                &node,
                           const std::vector<double> &own,
                           const unsigned int         stiffest,
                           const unsigned int         layer);

    /** The strips, and the heights of the faces. */
    class Faces;

    /** The plies of a column of elements. */
    struct Column
    {
      /** The positions in @p strips of the wall and of its layers, an invalid
       * number for a layer that does not exist there. */
      unsigned int              wall;
      std::vector<unsigned int> layers;
      /** The heights of all faces beside the nodes at the vertices, inner face
       * first. */
      std::array<std::vector<double>, 4> heights;
      /** The stiffest layers around these nodes, see contributions_to_layer().
       */
      std::array<unsigned int, 4> stiffest;
    };

    /** Add the elements of a cell: the wall and, if there are several, its
     * layers.
     * @param number that of the cell, see Cell::column.
     * @param first the number of the wall, see Cell::number.
     * @param geometry of an element with faces at given heights at the
     * vertices. */
    void
    add_elements(const std::array<unsigned int, 4>                &cell_nodes,
                 const dealii::types::global_cell_index            number,
                 const dealii::types::global_cell_index            first,
                 const Column                                     &column,
                 const std::function<ElementGeometry(
                   const std::array<std::array<double, 2>, 4> &)> &geometry);

    void
    collect_cells_and_nodes(const Faces &faces);

    /** Add the nodes to which cyclic edges couple those of this rank. */
    void
    add_cyclic_nodes(const Faces &faces);

    /** A node without its unknowns. */
    Node
    make_node(const GridIndex &index, const Faces &faces) const;

    std::shared_ptr<const Layup> layup;
    unsigned int                 n_all_layers;
    /** The number of strips of the whole wall. */
    unsigned int n_walls     = 1;
    unsigned int n_all_folds = 0;
    /** Where the strips are; null if there are lines. */
    std::shared_ptr<const PlacesOfStrips> places_of_strips;
    /** The values of wall_stiffness() and wall_stiffness_sideways(). Unit:
     * pressure/length. */
    double lowest_stiffness = 0, lowest_stiffness_sideways = 0;
    std::shared_ptr<const dealii::parallel::TriangulationBase<2, 3>>
                                                    triangulation;
    std::shared_ptr<const dealii::DoFHandler<2, 3>> dof_handler;
    dealii::types::global_dof_index                 n_free         = 0;
    dealii::types::global_dof_index                 n_all_elements = 0;
    double                                          max_thickness  = 0;
  };


  /** The values of formulas of the position, see parse_position_formula(), at
   * all nodes of this rank: `[node][i]` is that of the i-th formula. Throws
   * InputError on all ranks where one is not finite at any node. */
  std::vector<std::vector<double>>
  evaluate_at_nodes(const std::vector<Formula> &formulas,
                    const ShellMesh            &mesh);
} // namespace Biface

#endif
