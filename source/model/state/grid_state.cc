// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/geometry_info.h>
#include <deal.II/base/mpi.h>

#include <algorithm>
#include <tuple>
#include <utility>

#include <biface/model/state/contact_points.h>
#include <biface/model/state/grid_state.h>
#include <biface/model/state/state.h>

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


  GridState::GridState(const ChartGrid &grid, const unsigned int n_layers)
    : grid(grid), n_layers(n_layers)
  {
    contacts.resize(grid.n_nodes(0) * grid.n_nodes(1));
    displacements.assign((n_layers + 1) * contacts.size(), {});
    resultants_of_layers.resize(n_layers * grid.n_cells(0) * grid.n_cells(1));
  }


  GridState::GridState(const ShellMesh &mesh, const State &state)
    : GridState(mesh.grid, mesh.n_layers())
  {
    const ActiveSet in_contact =
      ContactPoints(mesh, Resultants::outer, state.ground())
        .nodes_around(state.ground().active);
    for (unsigned int n = 0; n < mesh.nodes.size(); ++n)
      {
        const Node &node = mesh.nodes[n];
        if (!node.locally_owned)
          continue;
        for (unsigned int part = 0; part < node.n_parts(); ++part)
          for (unsigned int i = 0; i < 3; ++i)
            {
              const auto dof = node.dof(i, part);
              // without the imperfection, which the finer mesh has on its own
              displacements[part * contacts.size() + node.number][i] =
                state.displacement(dof) -
                (mesh.imperfection.size() > 0 ? mesh.imperfection(dof) : 0.);
            }
        contacts[node.number] = in_contact[n];
      }
    for (const unsigned int c : mesh.layers)
      resultants_of_layers[n_layers * mesh.cells[c].column +
                           mesh.cells[c].layer] = state.resultants[c];

    // nodes and cells have one owner and are zero elsewhere: after the sums
    // each rank knows the whole state
    sum(displacements, mesh.communicator);
    sum(resultants_of_layers, mesh.communicator);
    Utilities::MPI::sum(contacts, mesh.communicator, contacts);
  }


  Tensor<1, 3>
  GridState::displacement(const Point<2> &alpha, const unsigned int part) const
  {
    return interpolate(&displacements[part * contacts.size()], place(alpha));
  }


  double
  GridState::contact(const Point<2> &alpha) const
  {
    return interpolate(contacts.data(), place(alpha));
  }


  Modes::Vector
  GridState::resultants(const std::array<Point<2>, 4> &cell,
                        const unsigned int             layer) const
  {
    Point<2> center;
    for (const Point<2> &vertex : cell)
      center += vertex / 4;
    const GridIndex at          = place(center).cell;
    const auto      at_vertices = Modes::at_vertices(
      resultants_of_layers[n_layers * grid.cell_number(at) + layer]);

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
  GridState::interpolate(const T *values, const Place &place) const
  {
    T value{};
    for (unsigned int v = 0; v < 4; ++v)
      value += GeometryInfo<2>::d_linear_shape_function(place.xi, v) *
               values[grid.node_number(grid.node_of_cell(place.cell, v))];
    return value;
  }
} // namespace Biface
