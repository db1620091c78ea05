// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_model_mesh_mesh_nodes_h
#define biface_model_mesh_mesh_nodes_h

#include <deal.II/base/index_set.h>
#include <deal.II/base/point.h>
#include <deal.II/base/types.h>

#include <mpi.h>

#include <array>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <biface/element/mixed_element.h>
#include <biface/model/mesh/named_points.h>
#include <biface/surface/chart_grid.h>
#include <biface/surface/reference_surface.h>

namespace Biface
{
  /** A node of the mesh: a vertex with the displacements of both faces. */
  struct Node
  {
    /** The lines of the grid that meet at the node. */
    GridIndex grid_index;

    /** See ChartGrid::node_number(): independent of the number of ranks. */
    dealii::types::global_cell_index number;

    /** The coordinates @f$(\alpha_1,\alpha_2)@f$, in the internal unit of the
     * surface. */
    dealii::Point<2> alpha;

    SurfacePoint surface;

    /** @f$\delta^-,\delta^+@f$, see Laminate::face_heights(): the mean of both
     * sides if a ply ends here. Unit: length. */
    std::array<double, 2> face_heights;

    /** Global indices of the unknowns, in the order of dof(). */
    std::array<dealii::types::global_dof_index, 6> dofs;

    /** See MixedElement::dof(). */
    dealii::types::global_dof_index
    dof(const unsigned int component, const MixedElement::Part part) const
    {
      return dofs[MixedElement::dof(0, component, part)];
    }

    /** Whether the node belongs to this rank. */
    bool locally_owned;

    /** Whether any displacement of each face is free. */
    std::array<bool, 2> face_is_free;
  };


  /** The nodes of a mesh on a surface, some of which have names. */
  class MeshNodes
  {
  public:
    /** Without nodes yet. */
    MeshNodes(const MPI_Comm                          communicator,
              std::shared_ptr<const ReferenceSurface> surface,
              const ChartGrid                        &grid,
              const std::vector<NamedPoint>          &points)
      : communicator(communicator)
      , grid(grid)
      , points(points)
      , surface(std::move(surface))
    {}

    const MPI_Comm  communicator;
    const ChartGrid grid;

    /** Those of this rank: of its cells and of their neighbors, also across
     * cyclic edges. */
    std::vector<Node> nodes;

    /** Their unknowns. */
    dealii::IndexSet locally_relevant;

    /** Named points, with the coordinates of their nodes, which differ by a
     * period or by round-off from those that were given, and the positions of
     * these nodes; invalid numbers for nodes that exist only on other ranks. */
    std::vector<NamedPoint>   points;
    std::vector<unsigned int> nodes_of_points;

    /** The node of a named point. Throws InputError, naming @p entry, if there
     * is no such point. */
    unsigned int
    node_of_point(const std::string &entry, const std::string &name) const;

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
    /** Find the nodes of the named points. Throws InputError, naming the
     * nearest node, if a point is not a node. */
    void
    find_points();

    std::shared_ptr<const ReferenceSurface> surface;
    double                                  diameter = 0;
  };
} // namespace Biface

#endif
