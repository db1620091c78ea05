// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include <biface/input/entry_declarations.h>
#include <biface/laminate/layup.h>
#include <biface/model/equations/shell_equations.h>
#include <biface/model/mesh/strip.h>
#include <biface/output/csv.h>
#include <biface/output/fiber_tension.h>
#include <biface/output/ply_results.h>
#include <biface/output/profile_file.h>
#include <biface/stepping/step_report.h>
#include <biface/surface/reference_surface.h>

namespace Biface
{
  using namespace dealii;

  void
  ProfileFile::Parameters::add_parameters(EntryDeclarations &prm)
  {
    prm.add_parameter("Profile alpha_2",
                      alpha_2,
                      "Coordinate line whose deformed contour is written to "
                      "profile-NNNN.csv; the nearest grid line is used.",
                      Patterns::Double(),
                      Unit("degrees for an angle, length otherwise"));
  }


  ProfileFile::ProfileFile(const Parameters     &parameters,
                           ResultsDirectory     &directory,
                           const ShellEquations &equations)
    : ResultFile("profile-*.csv", directory, equations)
    , parameters(parameters)
    , line(find_line())
  {}


  double
  ProfileFile::find_line() const
  {
    const ShellMesh        &mesh    = equations.mesh;
    const ReferenceSurface &surface = mesh.get_surface();

    // beyond the seam of a closed surface the line is as near as before it
    const double period   = surface.get_periodicity()[1];
    const auto   distance = [&](const Node &node) {
      const double d =
        node.alpha[1] - parameters.alpha_2 * surface.coordinate_unit(1);
      return std::abs(period > 0 ? std::remainder(d, period) : d);
    };
    double nearest = std::numeric_limits<double>::max();
    for (const Node &node : mesh.nodes)
      nearest = std::min(nearest, distance(node));
    nearest = Utilities::MPI::min(nearest, communicator);

    // if two lines are equally near, the one with the smaller coordinate
    double line = std::numeric_limits<double>::max();
    for (const Node &node : mesh.nodes)
      if (distance(node) <= nearest + 1e-9)
        line = std::min(line, node.alpha[1]);
    return Utilities::MPI::min(line, communicator);
  }


  template <typename Function>
  void
  ProfileFile::for_corners(const State &state, const Function &function) const
  {
    const ShellMesh &mesh = equations.mesh;
    for (const unsigned int c : mesh.layers)
      {
        const Cell &cell = mesh.cells[c];
        if (std::none_of(
              cell.nodes.begin(), cell.nodes.end(), [&](const unsigned int n) {
                return mesh.nodes[n].alpha[1] == line;
              }))
          continue;
        // strains belong to the vertices of cells and differ between the cells
        // around a node
        const auto E =
          equations.internal_forces().strains_at_vertices(state, c);
        for (unsigned int v = 0; v < 4; ++v)
          {
            const Node &node = mesh.nodes[cell.nodes[v]];
            if (node.alpha[1] == line)
              function(cell.layer,
                       node,
                       *mesh.strips[cell.strip].at_vertices[v],
                       E[v]);
          }
      }
  }


  std::vector<double>
  ProfileFile::tensions(const State &state) const
  {
    const ShellMesh     &mesh = equations.mesh;
    const TensionMembers members(mesh.get_layup());
    const unsigned int   n_plies = mesh.get_layup().get_plies().size();

    // number of plies, which may be parts, and sum by node and ply
    std::vector<double> sums(2 * mesh.grid.n_nodes(0) * n_plies);
    for_corners(state,
                [&](const unsigned int,
                    const Node           &node,
                    const Laminate       &laminate,
                    const StrainsOfPlies &E) {
                  for (unsigned int p = 0; p < laminate.get_plies().size(); ++p)
                    {
                      // parts of a ply in several layers add up to one ply
                      const Ply &ply = laminate.get_plies()[p];
                      double    *sum =
                        &sums[2 * (node.grid_index[0] * n_plies + ply.number)];
                      sum[0] += ply.end - ply.begin;
                      sum[1] +=
                        members.tension(mesh.get_layup(), laminate, p, E);
                    }
                });
    Utilities::MPI::sum(sums, communicator, sums);
    std::vector<double> means(sums.size() / 2);
    for (unsigned int i = 0; i < means.size(); ++i)
      means[i] = (sums[2 * i] > 0 ? sums[2 * i + 1] / sums[2 * i]
                                  : std::numeric_limits<double>::quiet_NaN());
    return means;
  }


  std::vector<double>
  ProfileFile::stresses(const State &state) const
  {
    const ShellMesh       &mesh    = equations.mesh;
    const unsigned int     n_nodes = mesh.grid.n_nodes(0);
    constexpr unsigned int n       = 6; // components of a tensor

    // the number of cells around each node, then the sums of both stresses of
    // both faces
    std::vector<double> sums((1 + 4 * n) * n_nodes);
    for_corners(state,
                [&](const unsigned int    layer,
                    const Node           &node,
                    const Laminate       &laminate,
                    const StrainsOfPlies &E) {
                  double    *sum = &sums[(1 + 4 * n) * node.grid_index[0]];
                  const auto add = [&](const Resultants::Face face,
                                       double                *to) {
                    const FaceStress of_cell(laminate, face, E);
                    for (unsigned int i = 0; i < n; ++i)
                      {
                        to[i] += of_cell.stress.access_raw_entry(i);
                        to[n + i] += of_cell.true_stress.access_raw_entry(i);
                      }
                  };
                  if (layer + 1 == mesh.n_layers())
                    add(Resultants::outer, sum + 1);
                  // each wall has one innermost layer, by which it is counted
                  // once
                  if (layer == 0)
                    {
                      add(Resultants::inner, sum + 1 + 2 * n);
                      sum[0] += 1;
                    }
                });
    Utilities::MPI::sum(sums, communicator, sums);
    std::vector<double> means;
    for (unsigned int i = 0; i < n_nodes; ++i)
      for (unsigned int face = 0; face < 2; ++face)
        {
          const double *of_node = &sums[(1 + 4 * n) * i];
          FaceStress    mean;
          for (unsigned int k = 0; k < n; ++k)
            {
              const double *of_face           = of_node + 1 + 2 * n * face;
              mean.stress.access_raw_entry(k) = of_face[k] / of_node[0];
              mean.true_stress.access_raw_entry(k) =
                of_face[n + k] / of_node[0];
            }
          for (const double value : mean.values())
            means.push_back(value);
        }
    return means;
  }


  double
  ProfileFile::carcass_height(const Node &node) const
  {
    const ShellMesh &mesh = equations.mesh;
    double           sum = 0, n_sides = 0;
    // from both sides if a ply ends here
    for (unsigned int side = 0; side < 2; ++side)
      {
        const unsigned int i = node.grid_index[0] + side;
        if (i == 0 || i > mesh.n_strips())
          continue;
        const Laminate &laminate = *mesh.strips[i - 1].at_vertices[1 - side];
        const double    bottom   = laminate.face_heights()[0];
        double          low = laminate.thickness(), high = 0, height = 0;
        for (const Ply &ply : laminate.get_plies())
          {
            if (mesh.get_layup().get_plies()[ply.number].material.has_fibers)
              {
                low  = std::min(low, height);
                high = std::max(high, height + ply.thickness);
              }
            height += ply.thickness;
          }
        // without fibers, the middle of the wall
        sum += bottom + (high > 0 ? (low + high) / 2 : height / 2);
        n_sides += 1;
      }
    return sum / n_sides;
  }


  void
  ProfileFile::write(const StepReport &report, const State &state)
  {
    const ShellMesh        &mesh    = equations.mesh;
    const ReferenceSurface &surface = mesh.get_surface();

    // means of cells around a node need all ranks, also those without a node of
    // the line
    const TensionMembers members(mesh.get_layup());
    const unsigned int   n_plies = mesh.get_layup().get_plies().size();
    const auto           tensions =
      (members.exist() ? this->tensions(state) : std::vector<double>());
    const std::vector<double> stresses   = this->stresses(state);
    constexpr unsigned int    n_stresses = 2 * FaceStress::names.size();

    Rows rows;
    for (unsigned int n = 0; n < mesh.nodes.size(); ++n)
      {
        const Node &node = mesh.nodes[n];
        if (!node.locally_owned || node.alpha[1] != line)
          continue;

        std::vector<double> row{chart_coordinate(surface, node, 0),
                                chart_coordinate(surface, node, 1)};
        for (const unsigned int face : {Resultants::outer, Resultants::inner})
          {
            const Point<3> x =
              mesh.deformed_position(state.displacement, node, face);
            row.insert(row.end(), {x[0], x[1], x[2]});
          }
        row.push_back(state.ground().pressure(n));
        const Point<3> carcass = mesh.position_at_height(
          state.displacement, node, carcass_height(node));
        row.insert(row.end(), {carcass[0], carcass[1], carcass[2]});
        if (members.exist())
          {
            const auto begin = tensions.begin() + node.grid_index[0] * n_plies;
            row.insert(row.end(), begin, begin + n_plies);
          }
        const auto stress = stresses.begin() + node.grid_index[0] * n_stresses;
        row.insert(row.end(), stress, stress + n_stresses);
        rows.push_back(row);
      }
    std::string header =
      "alpha_1,alpha_2,outer_x,outer_y,outer_z,inner_x,inner_y,inner_z,"
      "pressure,carcass_x,carcass_y,carcass_z";
    if (members.exist())
      for (unsigned int p = 1; p <= n_plies; ++p)
        header += ',' + members.name() + '_' + std::to_string(p);
    for (const std::string face : {"outer", "inner"})
      for (const std::string name : FaceStress::names)
        header += ',' + face + '_' + name;
    write_csv(path(report.step), header, rows, communicator);
  }
} // namespace Biface
