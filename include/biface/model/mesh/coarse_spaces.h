// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_model_mesh_coarse_spaces_h
#define biface_model_mesh_coarse_spaces_h

#include <vector>

#include <biface/base/linear_algebra.h>
#include <biface/model/mesh/shell_mesh.h>

namespace Biface
{
  /** The locally owned nodes of a mesh of some of the grid lines, ordered along
   * lines, with their unknowns as matrices of multigrid see them. */
  struct GridLineNodes
  {
    /** The local numbers of the rows of a matrix, node by node. */
    std::vector<int> rows;
    /** The position in @p rows at which the rows of each node start, and that
     * at which those of the last one end. */
    std::vector<unsigned int> begin{0};
    /** The first nodes of the lines, and the number of nodes. A new line starts
     * where a node of a line belongs to another rank. */
    std::vector<unsigned int> line_begin;

    unsigned int
    n_nodes() const
    {
      return begin.size() - 1;
    }
  };


  /** A mesh of every second line, see ChartGrid::coarsened(), as a space of
   * displacements on a finer one. */
  struct CoarseSpace
  {
    /** The unknowns of the coarse nodes but for those with constraints. */
    GridLineNodes nodes;

    /**
     * The matrix from the unknowns of this mesh to those of the next finer one.
     *
     * Mean and half differences of the faces are interpolated bilinearly, the
     * former as a Cartesian vector, the latter divided by the thicknesses of
     * their layers, which are rotations. Between the nodes, these rotations
     * @f$\boldsymbol\omega@f$ move the mean by half of
     * @f$\boldsymbol\omega\times(\mathbf x-\mathbf x_\text{node})@f$ in
     * addition, so that bending does not shear a thin shell (linked
     * interpolation).
     *
     * Rows of constrained unknowns are empty.
     */
    LA::SparseMatrix interpolation;
  };

  /** A mesh and coarser ones, as spaces of displacements. */
  struct NestedSpaces
  {
    /** All unknowns of the mesh, including those with constraints. */
    GridLineNodes nodes;
    /** The coarser spaces, from fine to coarse. */
    std::vector<CoarseSpace> coarse;
  };

  /**
   * Coarser and coarser spaces, each a part of the one before, until there are
   * at most @p max_unknowns or no lines are left that could be omitted.
   *
   * Every node of a coarse mesh is a node of the given one, with the same
   * owner, so that no rank needs another mesh. The lines of GridLineNodes run
   * along the short sides of the most elongated cell.
   */
  NestedSpaces
  make_nested_spaces(const ShellMesh                      &mesh,
                     const dealii::types::global_dof_index max_unknowns);
} // namespace Biface

#endif
