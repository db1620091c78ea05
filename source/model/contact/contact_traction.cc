// SPDX-License-Identifier: LGPL-2.1-or-later

#include <biface/contact/contact_state.h>
#include <biface/model/contact/contact_traction.h>
#include <biface/model/mesh/shell_mesh.h>
#include <biface/model/state/contact_points.h>
#include <biface/model/state/placed_body.h>
#include <biface/model/state/state.h>

namespace Biface
{
  using namespace dealii;

  ContactTraction
  contact_traction(const ContactState &state,
                   const PlacedBody   *body,
                   const unsigned int  point,
                   const Point<3>     &x)
  {
    ContactTraction result;
    if (!body || !state.active[point])
      return result;
    const Tensor<1, 3> &lambda   = state.multipliers[point];
    const Tensor<1, 3>  normal   = body->body.evaluate(x).normal;
    const auto          tangents = body->body.tangents(normal);
    for (unsigned int i = 0; i < 2; ++i)
      result.friction += lambda[1 + i] * tangents[i];
    result.total = lambda[0] * normal + result.friction;
    return result;
  }


  bool
  slips(const ContactState &state,
        const PlacedBody   *body,
        const unsigned int  point)
  {
    return body && body->laws.has_friction() && state.slips(point);
  }


  ContactState
  contact_at_nodes(const ShellMesh   &mesh,
                   const State       &state,
                   const unsigned int number,
                   const PlacedBody  &body)
  {
    const ContactState &zone = state.contacts[number];
    const ContactPoints points(mesh, body.face, zone);
    if (points.at_nodes())
      return zone;
    // tractions by node, for files and figures: such that the nodal forces are
    // those of the points
    ContactState result(mesh.nodes.size());

    // Of each node: its force, and its area, that in contact, and that of
    // points that slip
    LA::Vector forces = mesh.owned_vector(), areas = mesh.owned_vector();
    for (const Cell &cell : mesh.wall_elements())
      for (unsigned int i = 0; i < points.on_cell().size(); ++i)
        {
          const unsigned int n = points.number(cell, i);
          const Tensor<1, 3> traction =
            contact_traction(
              zone, &body, n, points.position(state.displacement, n))
              .total;
          const bool slipping    = slips(zone, &body, n);
          const auto of_vertices = points.areas(cell, i);
          for (unsigned int v = 0; v < 4; ++v)
            {
              const Node  &node = mesh.nodes[cell.nodes[v]];
              const double area = of_vertices[v];
              areas(node.dof(0, MixedElement::mean)) += area;
              if (!zone.active[n])
                continue;
              areas(node.dof(1, MixedElement::mean)) += area;
              if (slipping)
                areas(node.dof(2, MixedElement::mean)) += area;
              for (unsigned int c = 0; c < 3; ++c)
                forces(node.dof(c, MixedElement::mean)) += area * traction[c];
            }
        }
    const auto with_ghosts = [&](LA::Vector &owned) {
      owned.compress(VectorOperation::add);
      LA::Vector all = mesh.ghosted_vector();
      all            = owned;
      return all;
    };
    const LA::Vector all_forces = with_ghosts(forces),
                     all_areas  = with_ghosts(areas);
    const auto vector_of        = [](const LA::Vector &all, const Node &node) {
      Tensor<1, 3> values;
      for (unsigned int c = 0; c < 3; ++c)
        values[c] = all(node.dof(c, MixedElement::mean));
      return values;
    };
    for (unsigned int n = 0; n < mesh.nodes.size(); ++n)
      {
        const Tensor<1, 3> area = vector_of(all_areas, mesh.nodes[n]);
        if (!(area[1] > 0))
          continue;
        const Tensor<1, 3> traction =
          vector_of(all_forces, mesh.nodes[n]) / area[0];
        const Tensor<1, 3> normal =
          body.body
            .evaluate(mesh.deformed_position(
              state.displacement, mesh.nodes[n], body.face))
            .normal;
        const auto tangents   = body.body.tangents(normal);
        result.active[n]      = 1;
        result.multipliers[n] = Tensor<1, 3>(
          {traction * normal, traction * tangents[0], traction * tangents[1]});
        result.statuses[n] =
          (2 * area[2] > area[1] ? ContactStatus::slip : ContactStatus::stick);
      }
    return result;
  }
} // namespace Biface
