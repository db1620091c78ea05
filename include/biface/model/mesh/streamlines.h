// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_model_mesh_streamlines_h
#define biface_model_mesh_streamlines_h

#include <array>
#include <optional>
#include <vector>

#include <biface/model/mesh/shell_mesh.h>

namespace Biface
{
  /**
   * The streamlines of a rolling wheel: the mesh lines around the axis of a
   * closed surface of revolution, along which the material is transported
   * through the mesh (ALE), with the derivative by
   * @f$\varphi@f$ at the nodes: the central difference of whole Cartesian
   * positions,
   * @f[
   *   \frac{\partial\mathbf x}{\partial\varphi}\approx
   *   \frac{\mathbf x^+-\mathbf x^-}{h^-+h^+}
   * @f]
   * with the angles @f$h^\pm@f$ to the neighbors: the mean of the slopes of
   * both segments with the weights of their areas, so that the power of
   * constant tractions is that of the ends of the line. The differences of a
   * cell alone would give two slip velocities at the two ends of a segment.
   */
  class Streamlines
  {
  public:
    /** The streamlines of a mesh, which has some only if its surface is closed.
     * @param mesh any mesh; only one of a closed surface has streamlines. */
    explicit Streamlines(const ShellMesh &mesh);

    /** The neighbors of a node along its line, behind and ahead in the
     * direction of @f$\varphi@f$. */
    struct Stencil
    {
      /** The positions of the neighbors in ShellMesh::nodes. */
      std::array<unsigned int, 2> neighbors;
      /** The angles @f$h^-,h^+@f$ to the neighbors, in radians. */
      std::array<double, 2> angles;

      /** The derivative of the slope by the position of the neighbor ahead,
       * and minus that by the neighbor behind. */
      double
      per_neighbor() const
      {
        return 1 / (angles[0] + angles[1]);
      }
    };

    /** The neighbors of a node; none if the mesh is not closed, or if a
     * neighbor is not on this rank, which is possible for nodes that no cell of
     * this rank has. */
    const std::optional<Stencil> &
    at(const unsigned int node) const
    {
      return stencils[node];
    }

  private:
    std::vector<std::optional<Stencil>> stencils;
  };
} // namespace Biface

#endif
