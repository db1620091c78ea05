// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/mpi.h>

#include <algorithm>

#include <biface/model/mesh/cell_maximum.h>

namespace Biface
{
  using namespace dealii;

  std::optional<CellMaximum>
  find_cell_maximum(const ShellMesh &mesh, const std::vector<double> &values)
  {
    CellMaximum largest;
    for (const double value : values)
      largest.value = std::max(largest.value, value);
    largest.value = Utilities::MPI::max(largest.value, mesh.communicator);
    if (largest.value == CellMaximum::none)
      return {};

    // of cells with equal values but for round-off the one with the lowest
    // number, whatever the number of ranks
    auto first = std::numeric_limits<types::global_cell_index>::max();
    for (unsigned int c = 0; c < values.size(); ++c)
      if (values[c] >= largest.bound() && mesh.cells[c].number < first)
        {
          first            = mesh.cells[c].number;
          largest.position = c;
        }
    if (Utilities::MPI::min(first, mesh.communicator) != first)
      largest.position.reset();
    if (largest.position)
      {
        largest.number = mesh.cells[*largest.position].column;
        largest.layer  = mesh.cells[*largest.position].layer;
      }
    largest.number = Utilities::MPI::max(largest.number, mesh.communicator);
    largest.layer  = Utilities::MPI::max(largest.layer, mesh.communicator);
    return largest;
  }
} // namespace Biface
