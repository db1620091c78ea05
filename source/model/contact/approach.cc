// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <biface/base/errors.h>
#include <biface/contact/tangential_law.h>
#include <biface/model/contact/approach.h>
#include <biface/model/contact/contact_pair.h>
#include <biface/model/state/loads.h>
#include <biface/model/state/placed_body.h>

namespace Biface
{
  using namespace dealii;

  namespace
  {
    /** The travel until a body touches a free node of the face. */
    double
    minimum_travel(const ContactPair &pair,
                   const State       &state,
                   const RigidBody   &body)
    {
      double minimum = std::numeric_limits<double>::infinity();
      for (unsigned int n = 0; n < pair.points.size(); ++n)
        if (pair.points.may_touch(n))
          minimum = std::min(
            minimum,
            body.travel_to(pair.points.position(state.displacement, n)));
      return Utilities::MPI::min(minimum, pair.mesh.communicator);
    }
  } // namespace


  double
  travel_at_first_contact(const ContactPair &pair, const State &state)
  {
    const double travel =
      minimum_travel(pair, state, pair.moving_body.at_rest());
    if (travel == std::numeric_limits<double>::infinity())
      throw InputError("the ground of the section 'Contact' misses the "
                       "shell; its path must meet a node.");

    // the shell may not fit into a hollow body
    const RigidBody touching = pair.moving_body.after_travel(travel);
    bool            fits     = std::isfinite(travel);
    for (unsigned int n = 0; n < pair.points.size(); ++n)
      if (pair.points.may_touch(n))
        fits = fits &&
               touching.clearance(pair.points.position(state.displacement, n)) >
                 -1e-9 * pair.mesh.size();
    if (Utilities::MPI::logical_or(!fits, pair.mesh.communicator))
      throw InputError("the shell does not fit into the hollow ground of "
                       "the section 'Contact'.");
    return travel;
  }


  Point<3>
  first_contact_point(const ContactPair &pair,
                      const State       &state,
                      const double       travel_at_first_contact)
  {
    // nodes that would touch together but for round-off
    const double tolerance = 1e-6 * pair.mesh.thickness();

    std::vector<double> sums(4);
    for (unsigned int n = 0; n < pair.points.size(); ++n)
      {
        if (!pair.points.may_touch(n) || !pair.points.is_owned(n))
          continue;
        const Point<3> x = pair.points.position(state.displacement, n);
        if (pair.moving_body.at_rest().travel_to(x) >
            travel_at_first_contact + tolerance)
          continue;
        for (unsigned int i = 0; i < 3; ++i)
          sums[i] += x[i];
        sums[3] += 1;
      }
    Utilities::MPI::sum(sums, pair.mesh.communicator, sums);
    return Point<3>(sums[0], sums[1], sums[2]) / sums[3];
  }


  ActiveSet
  pierced_nodes(const ContactPair &pair, const State &state, const Loads &loads)
  {
    const double small = 1e-3 * pair.mesh.thickness();
    ActiveSet    pierced(pair.mesh.nodes.size(), 0);
    for (unsigned int n = 0; n < pair.mesh.nodes.size(); ++n)
      pierced[n] =
        (!pair.mesh.nodes[n].face_is_free[pair.face] &&
         pair.body(loads)->body.clearance(pair.mesh.deformed_position(
           state.displacement, pair.mesh.nodes[n], pair.face)) < -small);
    return pierced;
  }


  double
  penetration(const ContactPair &pair, const State &state, const Loads &loads)
  {
    double deepest = 0;
    for (unsigned int n = 0; n < pair.points.size(); ++n)
      if (pair.points.may_touch(n))
        deepest = std::max(deepest, -pair.clearance(state, loads, n));
    return Utilities::MPI::max(deepest, pair.mesh.communicator);
  }


  double
  largest_angle_of_normals(const ContactPair &pair,
                           const State       &state,
                           const Loads       &loads)
  {
    double lowest_cosine = 1;
    for (unsigned int n = 0; pair.body(loads) && n < pair.points.size(); ++n)
      if (pair.state_of(state).pressure(n) > 0)
        {
          const Tensor<1, 3> thickness =
            pair.points.interpolate(n, [&](const Node &node) {
              return pair.mesh.deformed_position(
                       state.displacement, node, Resultants::outer) -
                     pair.mesh.deformed_position(
                       state.displacement, node, Resultants::inner);
            });
          const Tensor<1, 3> normal =
            pair.at_point(state, loads, n).at_body.normal;
          lowest_cosine = std::min(
            lowest_cosine, std::abs(normal * thickness) / thickness.norm());
        }
    return std::acos(
      Utilities::MPI::min(lowest_cosine, pair.mesh.communicator));
  }


  bool
  was_passed(const ContactPair &pair,
             const State       &before,
             const Loads       &loads_before,
             const State       &after,
             const Loads       &loads_after)
  {
    const double small = 1e-3 * pair.mesh.thickness();
    // the cosine of 120 degrees; the sides of a corner may be orthogonal
    constexpr double opposite = -0.5;
    if (!pair.body(loads_before) || !pair.body(loads_after))
      return false;
    const RigidBody &start = pair.body(loads_before)->body,
                    &end   = pair.body(loads_after)->body;
    for (unsigned int n = 0; n < pair.points.size(); ++n)
      {
        if (!pair.points.may_touch(n))
          continue;
        const Point<3> from = pair.points.position(before.displacement, n),
                       to   = pair.points.position(after.displacement, n);
        double d            = start.clearance(from);
        if (d <= small)
          {
            // from contact to the other side
            if (start.evaluate(from).normal * end.evaluate(to).normal <
                opposite)
              return true;
            continue;
          }
        // the way relative to the body, which itself moves in the step
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
  remaining_travel(const ContactPair &pair,
                   const State       &state,
                   const Loads       &loads)
  {
    return minimum_travel(pair, state, pair.body(loads)->body);
  }


  double
  distance_to_contact(
    const ContactPair                                   &pair,
    const State                                         &state,
    const Loads                                         &loads,
    const std::function<Tensor<1, 3>(const Point<3> &)> &velocity,
    const double                                         depth)
  {
    // the sine of the angle to the surface
    constexpr double glancing = 1e-3;

    const RigidBody &body = pair.body(loads)->body;
    double           way  = std::numeric_limits<double>::infinity();
    for (unsigned int n = 0; n < pair.points.size(); ++n)
      if (pair.points.may_touch(n))
        {
          const Point<3>     x  = pair.points.position(state.displacement, n);
          const BodyPoint    at = body.evaluate(x);
          const Tensor<1, 3> v  = velocity(x);
          const double       approach = -(at.normal * v);
          // what moves along the surface never arrives, but for round-off
          if (approach > glancing * v.norm())
            way = std::min(way, (at.clearance + depth) / approach);
        }
    return Utilities::MPI::min(way, pair.mesh.communicator);
  }
} // namespace Biface
