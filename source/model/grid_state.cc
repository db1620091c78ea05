// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/geometry_info.h>
#include <deal.II/base/mpi.h>

#include <algorithm>
#include <tuple>
#include <utility>

#include <biface/model/grid_state.h>

namespace Biface
{
  using namespace dealii;

  namespace
  {
    /** Where a coordinate lies: the number of the interval, and the part of it,
     * from 0 to 1. */
    std::pair<unsigned int, double>
    interval(const std::vector<double> &lines, const double alpha)
    {
      const auto above =
        std::upper_bound(lines.begin() + 1, lines.end() - 1, alpha);
      const double part = (alpha - above[-1]) / (above[0] - above[-1]);
      return {above - lines.begin() - 1, std::min(1., std::max(0., part))};
    }


    /** Add up tensors of all ranks. */
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


  GridState::GridState(const ChartGrid &grid)
    : lines(grid.lines), closed(grid.closed)
  {
    const unsigned int n_1 = lines[0].size(), n_2 = lines[1].size();
    displacements.resize(n_1 * (closed ? n_2 - 1 : n_2));
    contacts.resize(displacements.size());
    cell_resultants.resize((n_1 - 1) * (n_2 - 1));
  }


  GridState::GridState(const ShellMesh &mesh, const State &state)
    : GridState(mesh.grid)
  {
    for (unsigned int n = 0; n < mesh.nodes.size(); ++n)
      {
        const Node &node = mesh.nodes[n];
        if (!node.locally_owned)
          continue;
        const Place        at = place(node.alpha);
        const unsigned int k  = vertices(
          at.cell)[(at.xi[0] > 0.5 ? 1 : 0) + (at.xi[1] > 0.5 ? 2 : 0)];
        for (unsigned int i = 0; i < 6; ++i)
          displacements[k][i] = state.displacement(node.dofs[i]);
        contacts[k] = state.active[n];
      }
    for (unsigned int c = 0; c < mesh.cells.size(); ++c)
      {
        const std::array<unsigned int, 2> at =
          place(mesh.nodes[mesh.cells[c].nodes[0]].alpha).cell;
        cell_resultants[at[0] + (lines[0].size() - 1) * at[1]] =
          state.resultants[c];
      }

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
    const std::array<unsigned int, 2> at          = place(center).cell;
    const auto                        at_vertices = Modes::at_vertices(
      cell_resultants[at[0] + (lines[0].size() - 1) * at[1]]);

    std::array<Resultants::Vector, 4> values;
    for (unsigned int v = 0; v < 4; ++v)
      {
        Point<2> xi;
        for (unsigned int a = 0; a < 2; ++a)
          xi[a] = (cell[v][a] - lines[a][at[a]]) /
                  (lines[a][at[a] + 1] - lines[a][at[a]]);
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
      std::tie(place.cell[a], place.xi[a]) = interval(lines[a], alpha[a]);
    return place;
  }


  std::array<unsigned int, 4>
  GridState::vertices(const std::array<unsigned int, 2> &cell) const
  {
    const unsigned int n_1  = lines[0].size();
    const unsigned int rows = displacements.size() / n_1;
    const unsigned int low  = n_1 * cell[1];
    const unsigned int high = n_1 * ((cell[1] + 1) % rows);
    return {
      {low + cell[0], low + cell[0] + 1, high + cell[0], high + cell[0] + 1}};
  }


  template <typename T>
  T
  GridState::interpolate(const std::vector<T> &values, const Place &place) const
  {
    const std::array<unsigned int, 4> at = vertices(place.cell);
    T                                 value{};
    for (unsigned int v = 0; v < 4; ++v)
      value +=
        GeometryInfo<2>::d_linear_shape_function(place.xi, v) * values[at[v]];
    return value;
  }
} // namespace Biface
