// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/mpi.h>

#include <algorithm>

#include <biface/model/mesh/largest_cell.h>

namespace Biface
{
  using namespace dealii;

  std::optional<LargestCell>
  find_largest_cell(const ShellMesh &mesh, const std::vector<double> &values)
  {
    LargestCell largest;
    for (const double value : values)
      largest.value = std::max(largest.value, value);
    largest.value = Utilities::MPI::max(largest.value, mesh.communicator);
    if (largest.value == LargestCell::none)
      return {};

    auto first = std::numeric_limits<types::global_cell_index>::max();
    for (unsigned int c = 0; c < values.size(); ++c)
      if (values[c] >= largest.bound() && mesh.cells[c].number < first)
        {
          first            = mesh.cells[c].number;
          largest.position = c;
        }
    largest.number = Utilities::MPI::min(first, mesh.communicator);
    if (largest.number != first)
      largest.position.reset();
    return largest;
  }
} // namespace Biface
