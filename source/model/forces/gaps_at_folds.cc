// SPDX-License-Identifier: LGPL-2.1-or-later

#include <algorithm>
#include <array>

#include <biface/model/forces/gaps_at_folds.h>
#include <biface/model/mesh/element_between.h>
#include <biface/model/mesh/fold_side.h>

namespace Biface
{
  using namespace dealii;

  namespace
  {
    GapAtFold
    strip(const ShellMesh &mesh, const std::array<unsigned int, 4> &nodes)
    {
      return {element_between(mesh, nodes), false};
    }


    GapAtFold
    triangle(const ShellMesh &mesh, const std::array<unsigned int, 3> &nodes)
    {
      // the unknowns of an element are those of different nodes
      const auto        &others = mesh.neighbors[nodes[0]];
      const unsigned int other =
        *std::find_if(others.begin(), others.end(), [&](const unsigned int n) {
          return std::find(nodes.begin(), nodes.end(), n) == nodes.end();
        });
      GapAtFold gap{
        element_between(mesh, {{nodes[0], nodes[1], nodes[2], other}}), true};
      gap.element.geometry =
        element_between(mesh, {{nodes[0], nodes[1], nodes[2], nodes[2]}})
          .geometry;
      return gap;
    }


    /** The unknown of the third vertex that takes the place of an unknown of
     * the fourth one. */
    unsigned int
    at_third_vertex(const unsigned int dof)
    {
      constexpr unsigned int n_of_vertex = MixedElement::n_dofs / 4;
      return dof < 3 * n_of_vertex ? dof : dof - n_of_vertex;
    }
  } // namespace


  MixedElement::NodalVector
  GapAtFold::displacements(const MixedElement::NodalVector &V) const
  {
    MixedElement::NodalVector result = V;
    for (unsigned int i = 0; i < MixedElement::n_dofs && is_triangle; ++i)
      result[i] = V[at_third_vertex(i)];
    return result;
  }


  MixedElement::NodalVector
  GapAtFold::at_unknowns(const MixedElement::NodalVector &force) const
  {
    MixedElement::NodalVector result;
    for (unsigned int i = 0; i < MixedElement::n_dofs; ++i)
      result[is_triangle ? at_third_vertex(i) : i] += force[i];
    return result;
  }


  void
  GapAtFold::add_at_unknowns(const MixedElement::NodalMatrix &derivative,
                             MixedElement::NodalMatrix       &K) const
  {
    const auto at = [this](const unsigned int i) {
      return is_triangle ? at_third_vertex(i) : i;
    };
    for (unsigned int i = 0; i < MixedElement::n_dofs; ++i)
      for (unsigned int j = 0; j < MixedElement::n_dofs; ++j)
        K[at(i)][at(j)] += derivative[i][j];
  }


  std::vector<GapAtFold>
  gaps_at_folds(const ShellMesh &mesh, const unsigned int face)
  {
    std::vector<GapAtFold> gaps;
    for (const FoldSide &fold : mesh.folds)
      for (const auto &wedge : fold.wedges[face])
        {
          const FoldSide::Part &one = fold.parts[wedge[0]],
                               &two = fold.parts[wedge[1]];
          // counterclockwise between the sides of both cells
          const unsigned int a = (one.is_reversed ? 1 : 0), b = 1 - a;
          gaps.push_back(strip(
            mesh, {{one.nodes[b], one.nodes[a], two.nodes[b], two.nodes[a]}}));
        }
    for (const std::vector<unsigned int> &corner : mesh.corners[face])
      for (unsigned int k = 1; k + 1 < corner.size(); ++k)
        gaps.push_back(triangle(mesh, {{corner[0], corner[k], corner[k + 1]}}));
    return gaps;
  }
} // namespace Biface
