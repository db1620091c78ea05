// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/geometry_info.h>
#include <deal.II/base/mpi.h>

#include <algorithm>
#include <tuple>
#include <utility>

#include <biface/model/state/grid_state.h>

namespace Biface
{
  using namespace dealii;

  namespace
  {
    /** The position of a coordinate: the number of the interval, and the
     * fraction of it, from 0 to 1. */
    std::pair<unsigned int, double>
    interval(const std::vector<double> &lines, const double alpha)
    {
      const auto above =
        std::upper_bound(lines.begin() + 1, lines.end() - 1, alpha);
      const double part = (alpha - above[-1]) / (above[0] - above[-1]);
      return {above - lines.begin() - 1, std::min(1., std::max(0., part))};
    }


    /** Sum tensors over all ranks. */
    template <int n>
    void
    sum(std::vector<Tensor<1, n>> &values, const MPI_Comm communicator)
    {
      std::vector<double> flat;
      flat.reserve(n * values.size());
      for (const auto &value : values)
        for (unsigned int i = 0; i < n; ++i)
          flat.push_back(value[i]);
      Utilities::MPI::sum(flat, communicator, flat);
      for (unsigned int k = 0; k < values.size(); ++k)
        for (unsigned int i = 0; i < n; ++i)
          values[k][i] = flat[n * k + i];
    }
  } // namespace


  GridState::GridState(const ChartGrid &grid) : grid(grid)
  {
    displacements.resize(grid.n_nodes(0) * grid.n_nodes(1));
    contacts.resize(displacements.size());
    cell_resultants.resize(grid.n_cells(0) * grid.n_cells(1));
  }


  GridState::GridState(const ShellMesh &mesh, const State &state)
    : GridState(mesh.grid)
  {
    for (unsigned int n = 0; n < mesh.nodes.size(); ++n)
      {
        const Node &node = mesh.nodes[n];
        if (!node.locally_owned)
          continue;
        for (unsigned int i = 0; i < 6; ++i)
          displacements[node.number][i] = state.displacement(node.dofs[i]);
        contacts[node.number] = state.ground().active[n];
      }
    for (unsigned int c = 0; c < mesh.cells.size(); ++c)
      cell_resultants[mesh.cells[c].number] = state.resultants[c];

    sum(displacements, mesh.communicator);
    sum(cell_resultants, mesh.communicator);
    Utilities::MPI::sum(contacts, mesh.communicator, contacts);
  }


  Tensor<1, 6>
  GridState::displacement(const Point<2> &alpha) const
  {
    return interpolate(displacements, place(alpha));
  }


  double
  GridState::contact(const Point<2> &alpha) const
  {
    return interpolate(contacts, place(alpha));
  }


  Modes::Vector
  GridState::resultants(const std::array<Point<2>, 4> &cell) const
  {
    Point<2> center;
    for (const Point<2> &vertex : cell)
      center += vertex / 4;
    const GridIndex at = place(center).cell;
    const auto      at_vertices =
      Modes::at_vertices(cell_resultants[grid.cell_number(at)]);

    std::array<Resultants::Vector, 4> values;
    for (unsigned int v = 0; v < 4; ++v)
      {
        Point<2> xi;
        for (unsigned int a = 0; a < 2; ++a)
          xi[a] = (cell[v][a] - grid.lines[a][at[a]]) /
                  (grid.lines[a][at[a] + 1] - grid.lines[a][at[a]]);
        for (unsigned int w = 0; w < 4; ++w)
          values[v] +=
            GeometryInfo<2>::d_linear_shape_function(xi, w) * at_vertices[w];
      }
    return Modes::from_vertices(values);
  }


  GridState::Place
  GridState::place(const Point<2> &alpha) const
  {
    Place place;
    for (unsigned int a = 0; a < 2; ++a)
      std::tie(place.cell[a], place.xi[a]) = interval(grid.lines[a], alpha[a]);
    return place;
  }


  template <typename T>
  T
  GridState::interpolate(const std::vector<T> &values, const Place &place) const
  {
    T value{};
    for (unsigned int v = 0; v < 4; ++v)
      value += GeometryInfo<2>::d_linear_shape_function(place.xi, v) *
               values[grid.node_number(grid.node_of_cell(place.cell, v))];
    return value;
  }
} // namespace Biface
