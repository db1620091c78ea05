// SPDX-License-Identifier: LGPL-2.1-or-later

#include <map>
#include <string>

#include <biface/model/contact/contact_pair.h>
#include <biface/model/equations/shell_equations.h>
#include <biface/model/quantities/face_stretch.h>
#include <biface/model/state/loads.h>
#include <biface/model/state/placed_body.h>
#include <biface/output/contact_file.h>
#include <biface/output/csv.h>
#include <biface/stepping/step_report.h>
#include <biface/surface/reference_surface.h>

namespace Biface
{
  using namespace dealii;

  namespace
  {
    const std::string header =
      "alpha_1,alpha_2,x,y,z,clearance,pressure,active,face_pressure,"
      "slipping,friction_x,friction_y,friction_z,true_pressure";
  }


  ContactFile::ContactFile(ResultsDirectory     &directory,
                           const ShellEquations &equations)
    : ResultFile("contact-*.csv", directory, equations)
  {}


  void
  ContactFile::write(const StepReport &report, const State &state)
  {
    const ShellMesh        &mesh    = equations.mesh;
    const ReferenceSurface &surface = mesh.get_surface();
    // of a stage without ground, the table is empty
    const auto bodies = report.loads->bodies;
    if (bodies.count(0) == 0)
      write_csv(path(report.step), header, {}, communicator);
    for (const auto &[number, placed] : bodies)
      {
        const PlacedBody  &body = *placed;
        const ContactState zone = contact_at_nodes(mesh, state, number, body);
        const LA::Vector   stretch =
          area_stretch(mesh, state.displacement, body.face);
        Rows rows;
        for (unsigned int n = 0; n < mesh.nodes.size(); ++n)
          {
            const Node &node = mesh.nodes[n];
            bool        near = false;
            // with the nodes around the zone, whose clearances are small
            for (const unsigned int neighbor : mesh.neighbors[n])
              near = near || zone.active[neighbor];
            if (!node.locally_owned || !near)
              continue;

            const Point<3> x =
              mesh.deformed_position(state.displacement, node, body.face);
            const double       pressure = zone.pressure(n);
            const Tensor<1, 3> friction =
              contact_traction(zone, &body, n, x).friction;
            // multipliers are per area of the middle surface; then per area of
            // the face before and after the deformation
            const ThicknessMetric metric(node.surface.curvature,
                                         node.face_heights);
            const double          face_pressure =
              pressure * metric.area_ratio(body.face);
            rows.push_back(
              {chart_coordinate(surface, node, 0),
               chart_coordinate(surface, node, 1),
               x[0],
               x[1],
               x[2],
               body.body.clearance(x),
               pressure,
               static_cast<double>(zone.active[n]),
               face_pressure,
               slips(zone, &body, n) ? 1. : 0.,
               friction[0],
               friction[1],
               friction[2],
               face_pressure / stretch(node.dof(2, MixedElement::mean))});
          }
        write_csv(number == 0 ? path(report.step)
                              : path(report.step, body.name),
                  header,
                  rows,
                  communicator);
      }
  }
} // namespace Biface
