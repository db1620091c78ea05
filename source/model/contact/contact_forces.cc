// SPDX-License-Identifier: LGPL-2.1-or-later

#include <optional>

#include <biface/contact/tangential_law.h>
#include <biface/model/contact/bristle_lines.h>
#include <biface/model/contact/contact_forces.h>
#include <biface/model/contact/contact_over_step.h>
#include <biface/model/state/loads.h>
#include <biface/model/state/placed_body.h>

namespace Biface
{
  using namespace dealii;

  bool
  ContactForces::acts_on(const unsigned int cell,
                         const State       &state,
                         const Loads       &loads) const
  {
    if (!contact.body(loads) || !contact.mesh.cells[cell].is_wall)
      return false;
    // points may come or leave
    if (state.step)
      return true;
    const ContactPoints &points = contact.points;
    for (unsigned int i = 0; i < points.on_cell().size(); ++i)
      if (contact.state_of(state)
            .active[points.number(contact.mesh.cells[cell], i)])
        return true;
    return false;
  }


  void
  ContactForces::add(const CellState &at, CellForces &forces) const
  {
    const ContactPoints &points = contact.points;
    for (unsigned int i = 0; i < points.on_cell().size(); ++i)
      {
        const unsigned int point = points.number(at.cell, i);
        if (!contact.state_of(at.state).active[point])
          continue;
        const LinearizedTraction traction =
          contact.traction(at.state, at.loads, point);
        add_traction(at.cell, i, traction, forces);
        // of a law that has points at the nodes
        if (contact.body(at.loads)->laws.tangential().depends_on_velocity())
          add_neighbor(at.cell, i, traction, forces.tangent);
      }
  }


  void
  ContactForces::add_over_step(const CellState & /*start*/,
                               const CellState &end,
                               CellForces      &forces) const
  {
    const ContactPoints &points = contact.points;
    for (unsigned int i = 0; i < points.on_cell().size(); ++i)
      if (const auto traction = traction_over_step(
            contact, end.state, end.loads, points.number(end.cell, i)))
        add_traction(end.cell, i, *traction, forces);
  }


  void
  ContactForces::add_traction(const Cell               &cell,
                              const unsigned int        i,
                              const LinearizedTraction &traction,
                              CellForces               &forces) const
  {
    const ContactPoints::OnCell &on_cell = contact.points.on_cell()[i];
    const std::array<double, 4>  areas   = contact.points.areas(cell, i);
    const auto                   frame =
      [&](const unsigned int v) -> const std::array<Tensor<1, 3>, 3> & {
      return contact.mesh.nodes[cell.nodes[v]].surface.frame;
    };
    for (unsigned int r = 0; r < 4; ++r)
      {
        Tensor<1, 3> force;
        for (unsigned int k = 0; k < 3; ++k)
          force[k] = areas[r] * (frame(r)[k] * traction.value);
        MixedElement::add_force(
          force, r, cell.sign_of_face(r, contact.face), forces.force);
        // the force acts on the mean and on the half difference of the
        // faces
        forces.square += 2 * force.norm_square();
      }
    for (unsigned int s = 0; s < 4; ++s)
      {
        if (on_cell.position[s] == 0)
          continue;
        std::array<Tensor<1, 3>, 3> columns;
        for (unsigned int k = 0; k < 3; ++k)
          columns[k] = on_cell.position[s] * (traction.stiffness * frame(s)[k]);
        for (unsigned int r = 0; r < 4; ++r)
          {
            Tensor<2, 3> stiffness;
            for (unsigned int k = 0; k < 3; ++k)
              for (unsigned int l = 0; l < 3; ++l)
                stiffness[k][l] = areas[r] * (frame(r)[k] * columns[l]);
            MixedElement::add_stiffness(stiffness,
                                        r,
                                        cell.sign_of_face(r, contact.face),
                                        s,
                                        cell.sign_of_face(s, contact.face),
                                        forces.tangent);
          }
      }
  }


  void
  ContactForces::add_neighbor(const Cell                &cell,
                              const unsigned int         s,
                              const LinearizedTraction  &traction,
                              MixedElement::NodalMatrix &K) const
  {
    const ShellMesh &mesh    = contact.mesh;
    const auto      &stencil = contact.streamlines.at(cell.nodes[s]);
    if (!stencil)
      return;
    const unsigned int r    = s ^ 2;
    const unsigned int side = (r > s ? 1 : 0);
    // The node's area on both sides; on a surface of revolution areas are
    // proportional to angles
    const double area = cell.geometry.weight / 4 *
                        (stencil->angles[0] + stencil->angles[1]) /
                        stencil->angles[side];
    const auto  &own      = mesh.nodes[cell.nodes[s]].surface.frame;
    const auto  &neighbor = mesh.nodes[cell.nodes[r]].surface.frame;
    Tensor<2, 3> stiffness;
    for (unsigned int i = 0; i < 3; ++i)
      for (unsigned int j = 0; j < 3; ++j)
        stiffness[i][j] =
          area *
          (own[i] * (traction.stiffness_of_neighbors[side] * neighbor[j]));
    MixedElement::add_stiffness(stiffness,
                                s,
                                cell.sign_of_face(s, contact.face),
                                r,
                                cell.sign_of_face(r, contact.face),
                                K);
  }


  void
  ContactForces::add_coupled_forces(const State &state,
                                    const Loads &loads,
                                    LA::Vector  &nodal_forces) const
  {
    contact.bristle_lines(state, loads).add_forces(nodal_forces);
  }


  void
  ContactForces::add_couplings(const State           &state,
                               const Loads           &loads,
                               std::vector<Coupling> &couplings) const
  {
    contact.bristle_lines(state, loads).add_couplings(couplings);
  }


  void
  ContactForces::add_load_derivative_of_couplings(
    const State     &state,
    const Loads     &loads,
    const LoadRates &rates,
    LA::Vector      &nodal_forces) const
  {
    contact.bristle_lines(state, loads)
      .add_load_derivative(rates, nodal_forces);
  }


  void
  ContactForces::add_load_derivative(const CellState           &at,
                                     const LoadRates           &rates,
                                     MixedElement::NodalVector &force) const
  {
    const PlacedBody *body = contact.body(at.loads);
    if (!body)
      return;
    const ShellMesh     &mesh   = contact.mesh;
    const ContactPoints &points = contact.points;
    for (unsigned int i = 0; i < points.on_cell().size(); ++i)
      {
        const unsigned int                point = points.number(at.cell, i);
        std::optional<LinearizedTraction> traction;
        if (at.state.step)
          traction = traction_over_step(contact, at.state, at.loads, point);
        else if (contact.state_of(at.state).active[point])
          traction = contact.traction(at.state, at.loads, point);
        if (!traction)
          continue;
        // a motion of the body is equivalent to the opposite displacement of
        // the point, with a traction that turns with the body
        const Tensor<1, 3> change =
          traction->stiffness *
            rates.velocity_of(body->body,
                              points.position(at.state.displacement, point)) +
          cross_product_3d(rates.angular_velocity_of(body->body),
                           traction->value) +
          rates.angular_velocity * traction->per_angular_velocity;
        const std::array<double, 4> areas = points.areas(at.cell, i);
        for (unsigned int r = 0; r < 4; ++r)
          {
            const Tensor<1, 3> m =
              mesh.nodes[at.cell.nodes[r]].surface.to_frame(change);
            MixedElement::add_force(
              areas[r] * m, r, at.cell.sign_of_face(r, contact.face), force);
          }
      }
  }


  void
  ContactForces::start_stage(const Loads &loads, State &state) const
  {
    if (const PlacedBody *body = contact.body(loads))
      body->laws.tangential().start_stage(contact.state_of(state));
  }
} // namespace Biface
