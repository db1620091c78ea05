// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/numbers.h>

#include <map>

#include <biface/model/mesh/streamlines.h>

namespace Biface
{
  using namespace dealii;

  Streamlines::Streamlines(const ShellMesh &mesh) : stencils(mesh.nodes.size())
  {
    const ChartGrid &grid = mesh.grid;
    if (!grid.closed)
      return;
    std::map<types::global_cell_index, unsigned int> known;
    for (unsigned int n = 0; n < mesh.nodes.size(); ++n)
      known[mesh.nodes[n].number] = n;

    const std::vector<double> &lines   = grid.lines[1];
    const unsigned int         n_lines = grid.n_nodes(1);
    for (unsigned int n = 0; n < mesh.nodes.size(); ++n)
      {
        const GridIndex    at     = mesh.nodes[n].grid_index;
        const unsigned int before = (at[1] + n_lines - 1) % n_lines;
        const auto behind = known.find(grid.node_number({{at[0], before}}));
        const auto ahead =
          known.find(grid.node_number({{at[0], (at[1] + 1) % n_lines}}));
        if (behind != known.end() && ahead != known.end())
          // there is a line more than nodes: the first one again, after a turn
          stencils[n] = Stencil{{{behind->second, ahead->second}},
                                {{lines[before + 1] - lines[before],
                                  lines[at[1] + 1] - lines[at[1]]}}};
      }
  }
} // namespace Biface
