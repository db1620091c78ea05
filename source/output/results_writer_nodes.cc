// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/mpi.h>
#include <deal.II/base/utilities.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include <biface/output/csv.h>
#include <biface/output/results_writer.h>

namespace Biface
{
  using namespace dealii;

  namespace
  {
    /** A node's coordinate as a person writes it. Free of round-off, so that
     * nodes of one coordinate line agree in it. */
    double
    chart_coordinate(const ReferenceSurface &surface,
                     const Node             &node,
                     const unsigned int      a)
    {
      return std::round(node.alpha[a] / surface.coordinate_unit(a) * 1e9) / 1e9;
    }
  } // namespace


  void
  ResultsWriter::write_contact(const StepReport &report,
                               const State      &state) const
  {
    const ShellMesh        &mesh    = equations.mesh;
    const ReferenceSurface &surface = mesh.get_surface();

    Rows rows;
    if (report.loads.foundation)
      for (unsigned int n = 0; n < mesh.nodes.size(); ++n)
        {
          const Node &node = mesh.nodes[n];
          bool        near = false;
          for (const unsigned int neighbor : mesh.neighbors[n])
            near = near || state.active[neighbor];
          if (!node.locally_owned || !near)
            continue;

          const Point<3> x =
            mesh.deformed_position(state.displacement, node, Resultants::outer);
          const double pressure = equations.pressure(state, report.loads, n);
          const ThicknessMetric metric(node.surface.curvature, node.faces);
          rows.push_back({chart_coordinate(surface, node, 0),
                          chart_coordinate(surface, node, 1),
                          x[0],
                          x[1],
                          x[2],
                          equations.clearance(state, report.loads, node),
                          pressure,
                          static_cast<double>(state.active[n]),
                          pressure * metric.area_ratio(Resultants::outer)});
        }
    write_csv(
      path("contact-" + Utilities::int_to_string(report.step, 4) + ".csv"),
      "alpha_1,alpha_2,x,y,z,clearance,pressure,active,face_pressure",
      rows,
      mesh.communicator);
  }


  void
  ResultsWriter::write_profile(const StepReport &report,
                               const State      &state) const
  {
    const ShellMesh        &mesh    = equations.mesh;
    const ReferenceSurface &surface = mesh.get_surface();

    const double period   = surface.get_periodicity()[1];
    const auto   distance = [&](const Node &node) {
      const double d =
        node.alpha[1] - parameters.profile * surface.coordinate_unit(1);
      return std::abs(period > 0 ? std::remainder(d, period) : d);
    };
    double nearest = std::numeric_limits<double>::max();
    for (const Node &node : mesh.nodes)
      nearest = std::min(nearest, distance(node));
    nearest = Utilities::MPI::min(nearest, mesh.communicator);

    // of two lines equally near, the one with the lesser coordinate
    double line = std::numeric_limits<double>::max();
    for (const Node &node : mesh.nodes)
      if (distance(node) <= nearest + 1e-9)
        line = std::min(line, node.alpha[1]);
    line = Utilities::MPI::min(line, mesh.communicator);

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
        row.push_back(report.loads.foundation
                        ? equations.pressure(state, report.loads, n)
                        : 0.);
        rows.push_back(row);
      }
    write_csv(
      path("profile-" + Utilities::int_to_string(report.step, 4) + ".csv"),
      "alpha_1,alpha_2,outer_x,outer_y,outer_z,inner_x,inner_y,"
      "inner_z,pressure",
      rows,
      mesh.communicator);
  }
} // namespace Biface
