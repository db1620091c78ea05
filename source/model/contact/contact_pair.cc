// SPDX-License-Identifier: LGPL-2.1-or-later

#include <algorithm>
#include <array>

#include <biface/base/errors.h>
#include <biface/contact/body_parameters.h>
#include <biface/contact/contact_laws.h>
#include <biface/contact/contact_laws_of_stage.h>
#include <biface/contact/friction.h>
#include <biface/contact/friction_parameters.h>
#include <biface/contact/tangential_law.h>
#include <biface/model/contact/bristle_lines.h>
#include <biface/model/contact/contact_pair.h>
#include <biface/model/contact/contact_parameters.h>
#include <biface/model/state/loads.h>
#include <biface/model/state/placed_body.h>

namespace Biface
{
  using namespace dealii;

  ContactPair::ContactPair(const ShellMesh         &mesh,
                           const ContactParameters &parameters,
                           const unsigned int       number)
    : mesh(mesh)
    , number(number)
    , name("foundation")
    , face(parameters.face)
    , tread(parameters.tread)
    , mortar_matrix(parameters.condition.mortar_matrix)
    , points(mesh, face, parameters.condition.points_per_side, mortar_matrix)
    , moving_body(RigidBody(parameters.body), tread)
    , streamlines(mesh)
    , condition_parameters(parameters.condition)
    , friction_parameters(
        std::make_shared<const FrictionParameters>(parameters.friction))
  {}


  namespace
  {
    std::shared_ptr<const FrictionParameters>
    with_coefficient(FrictionParameters         friction,
                     const FrictionCoefficient &coefficient)
    {
      friction.coefficient = coefficient;
      return std::make_shared<const FrictionParameters>(friction);
    }
  } // namespace


  ContactPair::ContactPair(const ShellMesh         &mesh,
                           const ContactParameters &ground,
                           const BodyParameters    &body,
                           const unsigned int       number)
    : mesh(mesh)
    , number(number)
    , name(body.name)
    , face(body.touches_inner_face ? Resultants::inner : Resultants::outer)
    , tread(body.touches_tread() ? ground.tread : TreadParameters())
    , mortar_matrix(ground.condition.mortar_matrix)
    , points(mesh, face, ground.condition.points_per_side, mortar_matrix)
    , moving_body(body, tread)
    , streamlines(mesh)
    , condition_parameters(ground.condition)
    , friction_parameters(with_coefficient(ground.friction, body.friction))
  {}


  const PlacedBody *
  ContactPair::body(const Loads &loads) const
  {
    return loads.body(number);
  }


  bool
  ContactPair::has_friction(const Loads &loads) const
  {
    return body(loads) && body(loads)->laws.has_friction();
  }


  double
  ContactPair::clearance(const State       &state,
                         const Loads       &loads,
                         const unsigned int point) const
  {
    return body(loads)->body.clearance(
      points.position(state.displacement, point));
  }


  ContactLaws
  ContactPair::laws(const ContactLawsOfStage &of_stage, const bool rolls) const
  {
    ContactCondition::Parameters across   = condition_parameters;
    FrictionParameters           sideways = *friction_parameters;
    if (of_stage.penalty_stiffness)
      across.penalty_stiffness = of_stage.penalty_stiffness;
    if (of_stage.friction)
      sideways.coefficient = *of_stage.friction;
    across.penalty_stiffness = tread.across(across.penalty_stiffness);
    const ContactCondition condition(across, mesh.wall_stiffness());
    // without tangential tractions nodes need no history, and with the lumped
    // mass the tangent is symmetric
    if (sideways.coefficient.is_zero() && !of_stage.glued)
      return ContactLaws(condition);

    FrictionKind kind =
      (of_stage.glued ? FrictionKind::glued : FrictionKind::with_history);
    // at a node of a rolling wheel there is always another particle, so that
    // stick points of nodes mean nothing
    if (rolls)
      kind = (sideways.in_rolling == FrictionInRolling::bristles
                ? FrictionKind::by_bristles
                : FrictionKind::by_slip_velocity);
    return ContactLaws(condition,
                       FrictionLaw(sideways.coefficient,
                                   tangential_stiffness(of_stage),
                                   sideways.critical_velocity),
                       kind);
  }


  ContactLaws
  ContactPair::laws() const
  {
    return laws(ContactLawsOfStage());
  }


  double
  ContactPair::tangential_stiffness(const ContactLawsOfStage &of_stage) const
  {
    FrictionParameters sideways = *friction_parameters;
    if (of_stage.tangential_stiffness)
      sideways.tangential_stiffness = of_stage.tangential_stiffness;
    sideways.tangential_stiffness = tread.along(sideways.tangential_stiffness);
    return sideways.tangential_stiffness_on(mesh.wall_stiffness_sideways());
  }


  ContactState
  ContactPair::zone_at_clearances(const State &state, const Loads &loads) const
  {
    ContactState            zone      = state_of(state);
    const ContactCondition &condition = body(loads)->laws.condition();
    for (unsigned int n = 0; n < points.size(); ++n)
      {
        const double clearance =
          (points.may_touch(n) ? this->clearance(state, loads, n) : 0.);
        zone.active[n] = clearance < 0;
        zone.multipliers[n][0] =
          (zone.active[n] ? condition.multiplier(clearance) : 0.);
      }
    return zone;
  }


  BristleLines
  ContactPair::bristle_lines(const State &state, const Loads &loads) const
  {
    const auto lines = [&](const ContactState &zone) {
      return BristleLines(mesh,
                          streamlines,
                          face,
                          number,
                          state,
                          zone,
                          body(loads),
                          loads.rolling.get());
    };
    // in time there is no active set
    return state.step && loads.rolling && body(loads) &&
               body(loads)->laws.bristles()
             ? lines(zone_at_clearances(state, loads))
             : lines(state_of(state));
  }


  void
  ContactPair::keep_tangential_tractions(State       &state,
                                         const Loads &loads,
                                         const double ratio) const
  {
    ContactState &zone = state_of(state);
    for (unsigned int n = 0; n < points.size(); ++n)
      if (zone.active[n] && zone.statuses[n] != ContactStatus::none)
        {
          // section 7 of doc/theory.md: stick points move such that the product
          // of slip and stiffness remains as the stiffness changes
          const PointInContact at    = at_point(state, loads, n);
          const Tensor<1, 3>  &n_at  = at.at_body.normal;
          const Point<3>       stick = at.body.present(zone.stick_points[n]);
          const Tensor<1, 3>   slip  = at.x - stick;
          zone.stick_points[n]       = at.body.at_rest(
            stick + (1 - ratio) * (slip - (n_at * slip) * n_at));
        }
  }


  PointInContact
  ContactPair::at_point(const State       &state,
                        const Loads       &loads,
                        const unsigned int point) const
  {
    const RigidBody &body = this->body(loads)->body;
    const Point<3>   x    = points.position(state.displacement, point);
    PointInContact   at{point, x, body, body.evaluate(x)};
    if (!loads.rolling || !points.at_nodes())
      return at;
    // x' is the difference of both neighbors on the line: inside a cell, one
    // segment would have two slip velocities
    if (const auto &stencil = streamlines.at(point))
      {
        const double per_neighbor = stencil->per_neighbor();
        at.particle               = {
                        *loads.rolling,
                        per_neighbor *
                          (points.position(state.displacement, stencil->neighbors[1]) -
             points.position(state.displacement, stencil->neighbors[0])),
                        per_neighbor};
      }
    return at;
  }


  unsigned int
  ContactPair::update_active_set(State           &state,
                                 const Loads     &loads,
                                 const ActiveSet &held) const
  {
    Assert(held.empty() || held.size() == points.size(),
           ExcDimensionMismatch(held.size(), points.size()));
    const PlacedBody *placed    = body(loads);
    ContactState     &zone      = state_of(state);
    unsigned int      n_changes = 0;
    for (unsigned int n = 0; n < points.size(); ++n)
      {
        // section 7 of doc/theory.md: an active point leaves if its multiplier
        // pulls, another one enters if it is beyond the surface
        const Tensor<1, 3> last   = zone.multipliers[n];
        const bool         active = placed && points.may_touch(n) &&
                            ((!held.empty() && held[n]) ||
                             placed->laws.condition().should_be_active(
                               last[0], clearance(state, loads, n)));
        if (active != static_cast<bool>(zone.active[n]))
          {
            zone.active[n] = active;
            // ghosts are decided here as on their own rank, from the same
            // numbers, and are not counted twice
            if (points.is_owned(n))
              ++n_changes;
          }
        zone.multipliers[n] = 0;
        if (!active)
          continue;
        // a point that enters has the multiplier 0 until the next linear system
        // is solved
        zone.multipliers[n][0]   = last[0];
        const TangentialLaw &law = placed->laws.tangential();
        if (!law.acts_on(zone, n))
          continue;
        const PointInContact at = at_point(state, loads, n);
        if (law.decide(zone, at, last) && points.is_owned(n))
          ++n_changes;
        set_tangential_multipliers(state, law, at);
      }
    bristle_lines(state, loads).set_multipliers(state_of(state));
    return n_changes;
  }


  ContactPair::Linearizations
  ContactPair::linearize(const State     &state,
                         const Loads     &loads,
                         const LoadRates &change) const
  {
    Linearizations result(points.size());
    if (body(loads))
      for (unsigned int n = 0; n < points.size(); ++n)
        if (state_of(state).active[n])
          {
            const PointInContact at = at_point(state, loads, n);
            result[n]               = {at.x,
                                       at.at_body.clearance,
                                       at.at_body.normal,
                                       change.velocity_of(at.body, at.x)};
          }
    return result;
  }


  void
  ContactPair::predict_multipliers(State                &state,
                                   const Loads          &loads,
                                   const Linearizations &before) const
  {
    AssertDimension(before.size(), points.size());
    const PlacedBody *placed = body(loads);
    ContactState     &zone   = state_of(state);
    for (unsigned int n = 0; n < points.size(); ++n)
      if (placed && zone.active[n])
        {
          // the linearized clearance, epsilon (c - n.dx) with the motion
          // against the body: multipliers of forces that balance in the linear
          // system are as large as the loads
          const Point<3>     x      = points.position(state.displacement, n);
          const Tensor<1, 3> motion = x - before[n].position;
          zone.multipliers[n][0]    = placed->laws.condition().multiplier(
            before[n].clearance -
            before[n].normal * (motion - before[n].of_body));
          if (!placed->laws.tangential().acts_on(zone, n))
            continue;
          // the same traction, with the tangents at the new place
          const RigidBody   &now      = placed->body;
          const auto         old      = now.tangents(before[n].normal);
          const auto         tangents = now.tangents(now.evaluate(x).normal);
          const Tensor<1, 3> traction =
            zone.multipliers[n][1] * old[0] + zone.multipliers[n][2] * old[1];
          for (unsigned int i = 0; i < 2; ++i)
            zone.multipliers[n][1 + i] = tangents[i] * traction;
        }
      else
        zone.multipliers[n] = 0;
  }


  unsigned int
  ContactPair::settle(State &state, const Loads &loads) const
  {
    // at the end of a step multipliers are those of the clearances; if this
    // changes the active set, the iteration goes on
    if (const PlacedBody *placed = body(loads))
      for (unsigned int n = 0; n < points.size(); ++n)
        if (points.may_touch(n))
          state_of(state).multipliers[n][0] = std::min(
            0.,
            placed->laws.condition().multiplier(clearance(state, loads, n)));
    return update_active_set(state, loads);
  }


  void
  ContactPair::compute_multipliers(State                &state,
                                   const Loads          &loads,
                                   const Linearizations &before,
                                   const LA::Vector     &increment) const
  {
    AssertDimension(before.size(), points.size());
    const PlacedBody *placed = body(loads);
    ContactState     &zone   = state_of(state);
    for (unsigned int n = 0; n < points.size(); ++n)
      {
        zone.multipliers[n] = 0;
        if (!zone.active[n])
          continue;
        const Tensor<1, 3> motion = points.motion(increment, n);
        zone.multipliers[n][0]    = placed->laws.condition().multiplier(
          before[n].clearance -
          before[n].normal * (motion - before[n].of_body));
        if (placed->laws.tangential().acts_on(zone, n))
          set_tangential_multipliers(
            state, placed->laws.tangential(), at_point(state, loads, n));
      }
    bristle_lines(state, loads).set_multipliers(state_of(state));
  }


  void
  ContactPair::set_tangential_multipliers(State                &state,
                                          const TangentialLaw  &law,
                                          const PointInContact &at) const
  {
    ContactState      &zone     = state_of(state);
    const auto         tangents = at.body.tangents(at.at_body.normal);
    const Tensor<1, 3> traction = law.traction(zone, at);
    for (unsigned int i = 0; i < 2; ++i)
      zone.multipliers[at.point][1 + i] = tangents[i] * traction;
  }


  void
  ContactPair::commit_step(State &state, const Loads &loads) const
  {
    ContactState &zone = state_of(state);
    for (unsigned int n = 0; n < points.size(); ++n)
      if (zone.active[n])
        body(loads)->laws.tangential().commit_step(zone,
                                                   at_point(state, loads, n));
      else
        // what leaves the body loses its history
        zone.forget_stick_point(n);
  }


  LinearizedTraction
  ContactPair::traction(const State       &state,
                        const Loads       &loads,
                        const unsigned int point) const
  {
    const ContactState  &zone    = state_of(state);
    const PointInContact at      = at_point(state, loads, point);
    const Tensor<1, 3>  &n       = at.at_body.normal;
    const ContactLaws   &laws    = body(loads)->laws;
    const double         epsilon = laws.condition().penalty_stiffness();
    LinearizedTraction   result;
    // the residual has the pressure of the clearance, the tangent the
    // multiplier of the last linear system, section 7 of doc/theory.md
    result.value = laws.condition().multiplier(at.at_body.clearance) * n;
    result.stiffness =
      epsilon * outer_product(n, n) -
      zone.multipliers[point][0] * Tensor<2, 3>(at.at_body.normal_gradient);
    laws.tangential().linearize(zone, at, result);
    return result;
  }
} // namespace Biface
