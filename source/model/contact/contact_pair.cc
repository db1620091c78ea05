// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <biface/base/errors.h>
#include <biface/contact/friction_by_bristles.h>
#include <biface/contact/friction_by_slip_velocity.h>
#include <biface/contact/friction_with_history.h>
#include <biface/model/contact/contact_pair.h>

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
          const bool slipping = slips(zone, &body, n);
          for (unsigned int v = 0; v < 4; ++v)
            {
              const Node  &node = mesh.nodes[cell.nodes[v]];
              const double area =
                points.on_cell()[i].forces[v] * cell.geometry.weight;
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


  void
  ContactPair::Parameters::add_parameters(EntryDeclarations &prm)
  {
    body.add_parameters(prm);
    condition.add_parameters(prm);
    friction.add_parameters(prm);
    tread.add_parameters(prm);
  }


  void
  ContactPair::Parameters::check() const
  {
    condition.check();
    friction.check();
    tread.check();
    body.check();
  }


  ContactPair::ContactPair(const ShellMesh   &mesh,
                           const Parameters  &parameters,
                           const unsigned int number)
    : mesh(mesh)
    , number(number)
    , name("foundation")
    , face(parameters.face)
    , tread(parameters.tread)
    , condition(tread.with_tread(parameters.condition), mesh.wall_stiffness())
    , points(mesh, face, parameters.condition.points_per_side, condition.mass())
    , flow_lines(mesh)
    , body_at_rest(parameters.body)
    , friction_parameters(tread.with_tread(parameters.friction))
  {}


  namespace
  {
    FrictionLaw::Parameters
    with_coefficient(FrictionLaw::Parameters friction,
                     const std::string      &coefficient)
    {
      friction.coefficient = coefficient;
      return friction;
    }
  } // namespace


  ContactPair::ContactPair(const ShellMesh      &mesh,
                           const Parameters     &ground,
                           const BodyParameters &body,
                           const unsigned int    number)
    : mesh(mesh)
    , number(number)
    , name(body.name)
    , face(body.touches_inner_face ? Resultants::inner : Resultants::outer)
    , tread(body.touches_tread() ? ground.tread : TreadParameters())
    , condition(tread.with_tread(ground.condition), mesh.wall_stiffness())
    , points(mesh, face, ground.condition.points_per_side, condition.mass())
    , flow_lines(mesh)
    , body_at_rest(body.make().behind(tread.height.value_or(0)))
    , friction_parameters(
        tread.with_tread(with_coefficient(ground.friction, body.friction)))
    , other_body(body)
  {}


  RigidBody
  ContactPair::taken_along(const RigidBody &body, const double travel) const
  {
    // the ground itself is below the tread
    BodyMotion motion;
    motion.translation = -body_at_rest.direction();
    motion.factor      = BodyMotion::travel_of_foundation;
    const double moved = travel - tread.height.value_or(0);
    return body.after_motions(
      {motion},
      [&](const unsigned int) { return moved; },
      body_at_rest.direction(),
      Point<3>());
  }


  RigidBody
  ContactPair::body_at(
    const std::vector<double>                         &factors,
    const std::function<RigidBody(const RigidBody &)> &with_foundation) const
  {
    Assert(other_body, ExcInternalError());
    const RigidBody body = body_at_rest.after_motions(
      other_body->motions,
      [&](const unsigned int position) { return factor_at(factors, position); },
      other_body->axis / other_body->axis.norm(),
      other_body->point);
    return moves_with_foundation() ? with_foundation(body) : body;
  }


  std::shared_ptr<const TangentialLaw>
  ContactPair::law(const std::string &entry,
                   const std::string &coefficient,
                   const bool         glued,
                   const bool         rolls) const
  {
    const FrictionLaw law =
      friction_parameters.of_stage(entry, coefficient, mesh.wall_stiffness());
    if (law.is_zero() && !glued)
      return std::make_shared<const TangentialLaw>();
    if (rolls && friction_parameters.rolling == RollingFriction::bristles)
      return std::make_shared<const FrictionByBristles>(law, condition);
    if (rolls)
      return std::make_shared<const FrictionBySlipVelocity>(law, condition);
    return std::make_shared<const FrictionWithHistory>(law, condition, glued);
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
    if (const auto &stencil = flow_lines.at(point))
      {
        const double per_neighbor = stencil->per_neighbor();
        at.particle               = {*loads.rolling,
                                     per_neighbor *
                                       (position(state, mesh.nodes[stencil->neighbors[1]]) -
                          position(state, mesh.nodes[stencil->neighbors[0]])),
                                     per_neighbor};
      }
    return at;
  }


  double
  ContactPair::touching_travel(const State &state) const
  {
    const double travel = minimum_travel(state, body_at_rest);
    if (travel == std::numeric_limits<double>::infinity())
      throw InputError("the foundation of the section 'Contact' misses the "
                       "shell; its path must meet a node.");

    // the shell may not fit into a hollow body
    const RigidBody touching = body_at(travel);
    bool            fits     = std::isfinite(travel);
    for (unsigned int n = 0; n < points.size(); ++n)
      if (points.may_touch(n))
        fits =
          fits && touching.clearance(points.position(state.displacement, n)) >
                    -1e-9 * mesh.size();
    if (Utilities::MPI::logical_or(!fits, mesh.communicator))
      throw InputError("the shell does not fit into the hollow foundation of "
                       "the section 'Contact'.");
    return travel;
  }


  Point<3>
  ContactPair::touched_point(const State &state,
                             const double touching_travel) const
  {
    // nodes that would touch together but for round-off
    const double tolerance = 1e-6 * mesh.thickness();

    std::vector<double> sums(4);
    for (unsigned int n = 0; n < points.size(); ++n)
      {
        if (!points.may_touch(n) || !points.is_owned(n))
          continue;
        const Point<3> x = points.position(state.displacement, n);
        if (body_at_rest.travel_to(x) > touching_travel + tolerance)
          continue;
        for (unsigned int i = 0; i < 3; ++i)
          sums[i] += x[i];
        sums[3] += 1;
      }
    Utilities::MPI::sum(sums, mesh.communicator, sums);
    return Point<3>(sums[0], sums[1], sums[2]) / sums[3];
  }


  ActiveSet
  ContactPair::pierced_nodes(const State &state, const Loads &loads) const
  {
    const double small = 1e-3 * mesh.thickness();
    ActiveSet    pierced(mesh.nodes.size(), 0);
    for (unsigned int n = 0; n < mesh.nodes.size(); ++n)
      pierced[n] =
        (!mesh.nodes[n].face_is_free[face] &&
         body(loads)->body.clearance(position(state, mesh.nodes[n])) < -small);
    return pierced;
  }


  double
  ContactPair::penetration(const State &state, const Loads &loads) const
  {
    double deepest = 0;
    for (unsigned int n = 0; n < points.size(); ++n)
      if (points.may_touch(n))
        deepest = std::max(deepest, -clearance(state, loads, n));
    return Utilities::MPI::max(deepest, mesh.communicator);
  }


  bool
  ContactPair::was_passed(const State &before,
                          const Loads &loads_before,
                          const State &after,
                          const Loads &loads_after) const
  {
    const double small = 1e-3 * mesh.thickness();
    // the cosine of 120 degrees; the sides of a corner may be orthogonal
    constexpr double opposite = -0.5;
    if (!body(loads_before) || !body(loads_after))
      return false;
    const RigidBody &start = body(loads_before)->body,
                    &end   = body(loads_after)->body;
    for (unsigned int n = 0; n < points.size(); ++n)
      {
        if (!points.may_touch(n))
          continue;
        const Point<3> from = points.position(before.displacement, n),
                       to   = points.position(after.displacement, n);
        double d            = start.clearance(from);
        if (d <= small)
          {
            // from contact to the other side
            if (start.evaluate(from).normal * end.evaluate(to).normal <
                opposite)
              return true;
            continue;
          }
        const Point<3>     rest   = start.at_rest(from);
        const Tensor<1, 3> way    = end.at_rest(to) - rest;
        const double       length = way.norm();
        if (length <= d + std::max(0., end.clearance(to)))
          continue;
        const auto at = [&](const double part) {
          return start.evaluate(start.present(rest + part * way));
        };
        // the clearance bounds the way to the surface
        double done = d;
        while (done < length && d > -small)
          {
            d = at(done / length).clearance;
            done += std::max(d, small);
          }
        // a node may enter and end on the same side
        if (d <= -small &&
            at(std::min(1., done / length)).normal * at(1).normal < 0)
          return true;
      }
    return false;
  }


  double
  ContactPair::remaining_travel(const State &state, const Loads &loads) const
  {
    return minimum_travel(state, body(loads)->body);
  }


  double
  ContactPair::way_to_shell(const State     &state,
                            const Loads     &loads,
                            const LoadRates &direction,
                            const double     depth) const
  {
    // the sine of the angle to the surface
    constexpr double glancing = 1e-3;

    const RigidBody &body = this->body(loads)->body;
    double           way  = std::numeric_limits<double>::infinity();
    for (unsigned int n = 0; n < points.size(); ++n)
      if (points.may_touch(n))
        {
          const Point<3>     x        = points.position(state.displacement, n);
          const BodyPoint    at       = body.evaluate(x);
          const Tensor<1, 3> velocity = direction.velocity_of(body, x);
          const double       approach = -(at.normal * velocity);
          if (approach > glancing * velocity.norm())
            way = std::min(way, (at.clearance + depth) / approach);
        }
    return Utilities::MPI::min(way, mesh.communicator);
  }


  double
  ContactPair::minimum_travel(const State &state, const RigidBody &body) const
  {
    double minimum = std::numeric_limits<double>::infinity();
    for (unsigned int n = 0; n < points.size(); ++n)
      if (points.may_touch(n))
        minimum = std::min(
          minimum, body.travel_to(points.position(state.displacement, n)));
    return Utilities::MPI::min(minimum, mesh.communicator);
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
        const Tensor<1, 3> last = zone.multipliers[n];
        const bool         active =
          placed && points.may_touch(n) &&
          ((!held.empty() && held[n]) ||
           condition.should_be_active(last[0], clearance(state, loads, n)));
        if (active != static_cast<bool>(zone.active[n]))
          {
            zone.active[n] = active;
            if (points.is_owned(n))
              ++n_changes;
          }
        zone.multipliers[n] = 0;
        if (!active)
          continue;
        // a node that enters has none until the next linear system is solved,
        // section 7 of doc/theory.md
        zone.multipliers[n][0] = last[0];
        if (!placed->law->acts_on(zone, n))
          continue;
        const PointInContact at = at_point(state, loads, n);
        if (placed->law->decide(zone, at, last) && points.is_owned(n))
          ++n_changes;
        set_tangential_multipliers(state, *placed->law, at);
      }
    set_multipliers_of_bristles(state, loads);
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
    ContactState &zone = state_of(state);
    for (unsigned int n = 0; n < points.size(); ++n)
      if (body(loads) && zone.active[n])
        {
          const Point<3>     x      = points.position(state.displacement, n);
          const Tensor<1, 3> motion = x - before[n].position;
          zone.multipliers[n][0]    = condition.multiplier(
            before[n].clearance -
            before[n].normal * (motion - before[n].of_body));
          if (!body(loads)->law->acts_on(zone, n))
            continue;
          // the same traction, with the tangents at the new place
          const RigidBody   &now      = body(loads)->body;
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
    if (body(loads))
      for (unsigned int n = 0; n < points.size(); ++n)
        if (points.may_touch(n))
          state_of(state).multipliers[n][0] =
            std::min(0., condition.multiplier(clearance(state, loads, n)));
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
        zone.multipliers[n][0] =
          condition.multiplier(before[n].clearance -
                               before[n].normal * (motion - before[n].of_body));
        if (placed->law->acts_on(zone, n))
          set_tangential_multipliers(
            state, *placed->law, at_point(state, loads, n));
      }
    set_multipliers_of_bristles(state, loads);
  }


  void
  ContactPair::set_multipliers_of_bristles(State       &state,
                                           const Loads &loads) const
  {
    if (!has_bristles(loads))
      return;
    const BristleLines lines     = bristle_lines(state, loads);
    const double       stiffness = body(loads)->law->stiffness_of_bristles();
    ContactState      &zone      = state_of(state);
    for (unsigned int n = 0; n < mesh.nodes.size(); ++n)
      if (const BristleLaw::Bristle *bristle = lines.at(n))
        {
          zone.statuses[n] =
            (bristle->slips() ? ContactStatus::slip : ContactStatus::stick);
          for (unsigned int i = 0; i < 2; ++i)
            zone.multipliers[n][1 + i] = -stiffness * bristle->deflection[i];
        }
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
  ContactPair::let_stick(State &state) const
  {
    for (ContactStatus &status : state_of(state).statuses)
      if (status == ContactStatus::slip)
        status = ContactStatus::stick;
  }


  void
  ContactPair::commit_step(State &state, const Loads &loads) const
  {
    ContactState &zone = state_of(state);
    for (unsigned int n = 0; n < points.size(); ++n)
      if (zone.active[n])
        body(loads)->law->commit_step(zone, at_point(state, loads, n));
      else
        zone.forget_stick_point(n);
  }


  bool
  ContactPair::release_glue(State &state, const ActiveSet &nodes) const
  {
    std::vector<ContactStatus> &statuses = state_of(state).statuses;
    AssertDimension(nodes.size(), statuses.size());
    bool any = false;
    for (unsigned int n = 0; n < nodes.size(); ++n)
      if (nodes[n] && statuses[n] == ContactStatus::glued)
        {
          statuses[n] = ContactStatus::none;
          any         = true;
        }
    return any;
  }


  unsigned int
  ContactPair::count_active(const State &state) const
  {
    unsigned int n = 0;
    for (unsigned int i = 0; i < points.size(); ++i)
      if (state_of(state).active[i] && points.is_owned(i))
        ++n;
    return Utilities::MPI::sum(n, mesh.communicator);
  }


  unsigned int
  ContactPair::count_slipping(const State &state, const Loads &loads) const
  {
    unsigned int n = 0;
    for (unsigned int i = 0; i < points.size(); ++i)
      if (points.is_owned(i) && slips(state_of(state), body(loads), i))
        ++n;
    return Utilities::MPI::sum(n, mesh.communicator);
  }


  LinearizedTraction
  ContactPair::traction(const State       &state,
                        const Loads       &loads,
                        const unsigned int point) const
  {
    const ContactState  &zone    = state_of(state);
    const PointInContact at      = at_point(state, loads, point);
    const Tensor<1, 3>  &n       = at.at_body.normal;
    const double         epsilon = condition.multiplier_stiffness();
    LinearizedTraction   result;
    result.value = condition.multiplier(at.at_body.clearance) * n;
    result.stiffness =
      epsilon * outer_product(n, n) -
      zone.multipliers[point][0] * Tensor<2, 3>(at.at_body.normal_gradient);
    body(loads)->law->linearize(zone, at, result);
    return result;
  }


  namespace
  {
    /** Call a function with the number of each active point of the cells of
     * this rank, and with its area on a cell. */
    template <typename Function>
    void
    for_active_points(const ContactPoints &points,
                      const ShellMesh     &mesh,
                      const ContactState  &zone,
                      const Function      &function)
    {
      for (const Cell &cell : mesh.wall_elements())
        for (unsigned int i = 0; i < points.on_cell().size(); ++i)
          {
            const unsigned int n = points.number(cell, i);
            if (zone.active[n])
              function(n, points.on_cell()[i].area * cell.geometry.weight);
          }
    }
  } // namespace


  double
  ContactPair::friction_work(const State &before,
                             const State &after,
                             const Loads &loads) const
  {
    double work = 0;
    if (has_friction(loads))
      for_active_points(
        points,
        mesh,
        state_of(after),
        [&](const unsigned int n, const double area) {
          work -=
            area * (traction_of_multipliers(after, loads, n).friction *
                    body(loads)->law->slip_in_step(
                      state_of(before), state_of(after), body(loads)->body, n));
        });
    return Utilities::MPI::sum(work, mesh.communicator);
  }


  namespace
  {
    /** The mean of a function of the pressures at the points, weighted by the
     * forces that they carry; zero if there are none. */
    template <typename Function>
    double
    mean_by_force(const ContactPoints &points,
                  const ShellMesh     &mesh,
                  const ContactState  &zone,
                  const Function      &function)
    {
      double force = 0, integral = 0;
      for_active_points(
        points, mesh, zone, [&](const unsigned int n, const double area) {
          const double pressure = zone.pressure(n);
          force += area * pressure;
          integral += area * pressure * function(pressure);
        });
      force    = Utilities::MPI::sum(force, mesh.communicator);
      integral = Utilities::MPI::sum(integral, mesh.communicator);
      return force > 0 ? integral / force : 0.;
    }
  } // namespace


  ContactSummary
  ContactPair::summarize(const State &state, const Loads &loads) const
  {
    const ContactState &zone = state_of(state);
    double force = 0, area = 0, slipping_area = 0, max_pressure = 0;
    if (body(loads))
      {
        const Tensor<1, 3> d = body(loads)->body.direction();
        for_active_points(
          points, mesh, zone, [&](const unsigned int n, const double part) {
            area += part;
            if (slips(zone, body(loads), n))
              slipping_area += part;
            force -=
              part * (traction_of_multipliers(state, loads, n).total * d);
          });
        // not over the cells, in which a node occurs several times
        for (unsigned int n = 0; n < points.size(); ++n)
          if (points.is_owned(n))
            max_pressure = std::max(max_pressure, zone.pressure(n));
      }

    const MPI_Comm communicator = mesh.communicator;
    ContactSummary summary;
    summary.force         = Utilities::MPI::sum(force, communicator);
    summary.area          = Utilities::MPI::sum(area, communicator);
    summary.slipping_area = Utilities::MPI::sum(slipping_area, communicator);
    summary.n_nodes       = count_active(state);
    summary.n_slipping    = count_slipping(state, loads);
    summary.max_pressure  = Utilities::MPI::max(max_pressure, communicator);
    // weighted by the force, so that nodes that enter or leave, without
    // pressure, change nothing
    if (summary.n_nodes > 0)
      {
        const double mean =
          mean_by_force(points, mesh, zone, [](const double p) { return p; });
        const double square =
          mean_by_force(points, mesh, zone, [&](const double p) {
            return (p - mean) * (p - mean);
          });
        summary.weighted_pressure = mean;
        if (mean > 0)
          summary.pressure_variation = std::sqrt(std::max(0., square)) / mean;
      }
    return summary;
  }
} // namespace Biface
