// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include <biface/output/csv.h>
#include <biface/output/profile_file.h>

namespace Biface
{
  using namespace dealii;

  void
  ProfileFile::Parameters::add_parameters(ParameterHandler &prm)
  {
    prm.add_parameter("Profile alpha_2",
                      alpha_2,
                      "Coordinate line whose deformed contour is written to "
                      "profile-NNNN.csv; the nearest grid line is used. "
                      "Unit: degrees for an angle, length otherwise.",
                      Patterns::Double());
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

    // of two equally near lines, the one with the smaller coordinate
    double line = std::numeric_limits<double>::max();
    for (const Node &node : mesh.nodes)
      if (distance(node) <= nearest + 1e-9)
        line = std::min(line, node.alpha[1]);
    return Utilities::MPI::min(line, communicator);
  }


  void
  ProfileFile::write(const StepReport &report, const State &state)
  {
    const ShellMesh        &mesh    = equations.mesh;
    const ReferenceSurface &surface = mesh.get_surface();

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
        row.push_back(state.contact_pressure(n));
        rows.push_back(row);
      }
    write_csv(path(report.step),
              "alpha_1,alpha_2,outer_x,outer_y,outer_z,inner_x,inner_y,"
              "inner_z,pressure",
              rows,
              communicator);
  }
} // namespace Biface
