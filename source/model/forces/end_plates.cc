// SPDX-License-Identifier: LGPL-2.1-or-later

#include <biface/model/forces/dead_loads.h>
#include <biface/model/forces/end_plates.h>

namespace Biface
{
  using namespace dealii;

  EndPlates::EndPlates(const ShellMesh &mesh, const PressureLoad &pressure)
  {
    const Tensor<1, 3> axis = mesh.get_surface().axis();
    DeadLoads          loads;
    for (const Edge edge : pressure.end_plates)
      {
        const bool         at_end  = (edge == Edge::alpha_1_max);
        const auto        &lines   = mesh.grid.lines;
        const SurfacePoint surface = mesh.get_surface().evaluate(Point<2>(
          at_end ? lines[0].back() : lines[0].front(), lines[1].front()));
        const Strip &strip = mesh.strips[at_end ? mesh.n_strips() - 1 : 0];
        const double height =
          strip.at_lines[at_end].face_heights()[pressure.face];
        const Point<3> x = surface.position + height * surface.frame[2];
        const double   r = (x - (x * axis) * axis).norm();

        // away from the cavity, which is on the side of the face
        const Tensor<1, 3> arm =
          surface.position - (surface.position * axis) * axis;
        const double around =
          cross_product_3d(axis, Tensor<1, 3>(arm)) * surface.frame[1];
        const double outward = ((around > 0) == at_end ? -1. : 1.) *
                               (pressure.face == Resultants::inner ? 1. : -1.);
        EdgeForce force;
        force.edge             = edge;
        force.force.components = outward * r * r / (2 * surface.lame[1]) * axis;
        loads.edge_forces.push_back(force);
      }
    at_unit_pressure = loads.assemble(mesh, pressure.area)[0];
  }
} // namespace Biface
