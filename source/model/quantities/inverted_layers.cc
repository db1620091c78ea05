// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/mpi.h>

#include <limits>

#include <biface/model/quantities/inverted_layers.h>
#include <biface/model/state/state.h>

namespace Biface
{
  using namespace dealii;

  namespace
  {
    /** The volume between the director and the tangents of the middle of a
     * layer: negative if it is inside out. */
    double
    volume(const ThicknessMetric &metric, const DisplacementGradient &u)
    {
      std::array<Tensor<1, 3>, 2> tangent;
      for (unsigned int a = 0; a < 2; ++a)
        for (unsigned int face = 0; face < 2; ++face)
          tangent[a] +=
            metric.zeta[face][a] * metric.tangents[face][a] + u.g[face][a];
      Tensor<1, 3> director = u.beta;
      director[2] += 1;
      return cross_product_3d(tangent[0], tangent[1]) * director;
    }
  } // namespace


  std::optional<InvertedLayer>
  find_inverted_layer(const ShellMesh &mesh, const State &state)
  {
    if (state.linearization_point || mesh.n_layers() == 1)
      return {};
    constexpr auto none = std::numeric_limits<types::global_cell_index>::max();
    types::global_cell_index first = none;
    for (const unsigned int c : mesh.layers)
      {
        const Cell &cell = mesh.cells[c];
        const auto  V    = mesh.cell_values(state.displacement, cell);
        for (unsigned int v = 0; v < 4; ++v)
          if (volume(cell.geometry.vertices[v].metric,
                     displacement_gradient(cell.geometry, V, v)) < 0)
            // the first one by number is the same on any number of ranks
            first =
              std::min(first,
                       cell.column * mesh.n_layers() +
                         static_cast<types::global_cell_index>(cell.layer));
      }
    first = Utilities::MPI::min(first, mesh.communicator);
    if (first == none)
      return {};
    return InvertedLayer{first / mesh.n_layers(),
                         static_cast<unsigned int>(first % mesh.n_layers())};
  }
} // namespace Biface
