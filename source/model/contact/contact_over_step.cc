// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include <biface/contact/contact_laws.h>
#include <biface/contact/friction.h>
#include <biface/model/contact/contact_over_step.h>
#include <biface/model/contact/contact_pair.h>
#include <biface/model/state/placed_body.h>
#include <biface/model/state/step_in_time.h>

namespace Biface
{
  using namespace dealii;

  namespace
  {
    /** The multiplier over a step, and its derivative by the clearance at the
     * end. */
    struct Multiplier
    {
      double value, derivative;
    };

    /** @param c_0, c_1 the clearances at the ends, not both positive.
     * @param damping see DampingInTime::of_contact. */
    Multiplier
    multiplier_over_step(const double c_0,
                         const double c_1,
                         const double epsilon,
                         const double damping)
    {
      const double change = c_1 - c_0;
      Multiplier   result;
      // without differences of squares
      if (c_0 <= 0 && c_1 <= 0)
        result = {(c_0 + c_1) / 2, 0.5};
      else if (c_1 <= 0)
        result = {c_1 * c_1 / (2 * change),
                  c_1 / change - c_1 * c_1 / (2 * change * change)};
      else
        result = {-c_0 * c_0 / (2 * change), c_0 * c_0 / (2 * change * change)};
      result.value += damping / 2 * (std::min(c_1, 0.) - std::min(c_0, 0.));
      if (c_1 <= 0)
        result.derivative += damping / 2;
      // dashpots do not pull
      if (result.value > 0)
        return {0, 0};
      return {epsilon * result.value, epsilon * result.derivative};
    }


    /** Where a point has been at the start of the step, carried along with the
     * body to its end. */
    Point<3>
    carried_along(const ContactPair &contact,
                  const StepInTime  &step,
                  const RigidBody   &body_at_end,
                  const Point<3>    &x)
    {
      const PlacedBody *at_start = contact.body(step.loads_at_start);
      return at_start ? body_at_end.present(at_start->body.at_rest(x)) : x;
    }


    /** What happens at a point that touches a body in a step. */
    struct OverStep
    {
      /** The place of the point at the end, its clearance there, and the normal
       * along which the multiplier acts. */
      Point<3>     x;
      double       clearance;
      Tensor<1, 3> normal;
      Multiplier   lambda;
      /** The derivative of the normal of the body halfway. */
      SymmetricTensor<2, 3> normal_gradient;

      /** How the body holds the point sideways. */
      struct Friction
      {
        /** The normal at the end, the stick point on the body there, and the
         * trial traction. */
        Tensor<1, 3>      normal;
        Point<3>          stick;
        Tensor<1, 3>      trial;
        ContactStatus     status;
        FrictionLaw::Slip slip;

        Tensor<1, 3>
        traction() const
        {
          return status == ContactStatus::slip ? slip.traction : trial;
        }
      };
      std::optional<Friction> friction;
    };


    std::optional<OverStep>
    over_step(const ContactPair &contact,
              const State       &state,
              const Loads       &loads,
              const unsigned int point)
    {
      if (!contact.points.may_touch(point))
        return {};
      const StepInTime &step = *state.step;
      const PlacedBody &body = *contact.body(loads);
      const Point<3> x_1 = contact.points.position(state.displacement, point),
                     x_0 = carried_along(
                       contact,
                       step,
                       body.body,
                       contact.points.position(step.start.displacement, point));
      const BodyPoint end = body.body.evaluate(x_1);
      const double    c_0 = body.body.clearance(x_0), c_1 = end.clearance;
      if (c_0 > 0 && c_1 > 0)
        return {};

      OverStep result;
      result.x         = x_1;
      result.clearance = c_1;
      result.lambda =
        multiplier_over_step(c_0,
                             c_1,
                             body.laws.condition().penalty_stiffness(),
                             step.damping.of_contact);
      const Tensor<1, 3> motion  = x_1 - x_0;
      const BodyPoint    halfway = body.body.evaluate(x_0 + motion / 2);
      result.normal              = halfway.normal;
      result.normal_gradient     = halfway.normal_gradient;
      const double missing       = c_0 - c_1 - halfway.normal * motion;
      // what round-off of the positions leaves is no curvature
      constexpr double roundoff = 64 * std::numeric_limits<double>::epsilon();
      if (std::abs(missing) > roundoff * (x_1.norm() + std::abs(c_1)))
        result.normal += missing / motion.norm_square() * motion;
      if (!contact.has_friction(loads))
        return result;

      // a point that comes sticks where it touches, whose friction in an impact
      // of one step would be lost otherwise
      const FrictionLaw  &law    = body.laws.friction();
      const ContactState &before = contact.state_of(step.start);
      const bool          stuck = before.statuses[point] != ContactStatus::none;
      OverStep::Friction  friction;
      friction.normal = end.normal;
      friction.stick  = (stuck ? body.body.present(before.stick_points[point])
                         : c_0 > 0 ? x_0 + c_0 / (c_0 - c_1) * motion
                                   : x_0);
      const Tensor<1, 3> from_stick = x_1 - friction.stick;
      friction.trial =
        law.trial(from_stick - (end.normal * from_stick) * end.normal);
      const double pressure = -result.lambda.value;
      friction.status =
        (before.statuses[point] == ContactStatus::glued && stuck
           ? ContactStatus::glued
         : law.should_slip(friction.trial, pressure) ? ContactStatus::slip
                                                     : ContactStatus::stick);
      if (friction.status == ContactStatus::slip)
        friction.slip = law.slip(friction.trial, pressure);
      result.friction = friction;
      return result;
    }


    /** The stick point on the body at the end of the step. */
    Point<3>
    new_stick_point(const OverStep &at, const FrictionLaw &law)
    {
      const OverStep::Friction &friction = *at.friction;
      return friction.status == ContactStatus::slip
               ? Point<3>(at.x - law.elastic_slip(friction.slip.traction))
               : friction.stick;
    }


    /** The sum over the points of this pair on all ranks of a function of each,
     * times its area on a cell. */
    template <typename Function>
    double
    sum_over_points(const ContactPair &contact, const Function &function)
    {
      double sum = 0;
      for (const Cell &cell : contact.mesh.wall_elements())
        for (unsigned int i = 0; i < contact.points.on_cell().size(); ++i)
          sum += contact.points.area(cell, i) *
                 function(contact.points.number(cell, i));
      return Utilities::MPI::sum(sum, contact.mesh.communicator);
    }
  } // namespace


  std::optional<LinearizedTraction>
  traction_over_step(const ContactPair &contact,
                     const State       &state,
                     const Loads       &loads,
                     const unsigned int point)
  {
    const auto at = over_step(contact, state, loads, point);
    if (!at)
      return {};
    LinearizedTraction result;
    result.value = at->lambda.value * at->normal;
    result.stiffness =
      at->lambda.derivative * outer_product(at->normal, at->normal) -
      at->lambda.value / 2 * Tensor<2, 3>(at->normal_gradient);
    if (!at->friction)
      return result;

    const OverStep::Friction &friction = *at->friction;
    const Tensor<1, 3>       &n        = friction.normal;
    const double              epsilon_t =
      contact.body(loads)->laws.friction().tangential_stiffness();
    Tensor<2, 3> derivative =
      -epsilon_t *
      (Tensor<2, 3>(unit_symmetric_tensor<3>()) - outer_product(n, n));
    if (friction.status == ContactStatus::slip)
      derivative =
        (state.step->secant_of_friction
           ? friction.slip.traction.norm() / friction.trial.norm() * derivative
           : friction.slip.per_trial * derivative) +
        outer_product(friction.slip.per_pressure,
                      at->lambda.derivative * at->normal);
    result.value += friction.traction();
    // stiffnesses are minus the derivatives of tractions
    result.stiffness -= derivative;
    return result;
  }


  void
  settle_friction_over_step(const ContactPair &contact,
                            const Loads       &loads,
                            State             &state)
  {
    if (!contact.has_friction(loads))
      return;
    const PlacedBody &body = *contact.body(loads);
    ContactState     &zone = contact.state_of(state);
    for (unsigned int n = 0; n < contact.points.size(); ++n)
      {
        const auto at = over_step(contact, state, loads, n);
        // in time there is no active set: what penetrates over the step touches
        zone.active[n]   = at && at->clearance < 0;
        zone.statuses[n] = ContactStatus::none;
        for (unsigned int i = 1; i < 3; ++i)
          zone.multipliers[n][i] = 0;
        if (!zone.active[n])
          continue;
        const OverStep::Friction &friction = *at->friction;
        zone.statuses[n]                   = friction.status;
        zone.stick_points[n] =
          body.body.at_rest(new_stick_point(*at, body.laws.friction()));
        const auto tangents = body.body.tangents(friction.normal);
        for (unsigned int i = 0; i < 2; ++i)
          zone.multipliers[n][1 + i] = friction.traction() * tangents[i];
      }
  }


  double
  friction_work_over_step(const ContactPair &contact,
                          const State       &state,
                          const Loads       &loads)
  {
    if (!contact.has_friction(loads))
      return 0;
    const FrictionLaw &law = contact.body(loads)->laws.friction();
    return sum_over_points(contact, [&](const unsigned int point) {
      const auto at = over_step(contact, state, loads, point);
      if (!at || at->friction->status != ContactStatus::slip)
        return 0.;
      return -(at->friction->traction() *
               (new_stick_point(*at, law) - at->friction->stick));
    });
  }


  double
  contact_energy(const ContactPair &contact,
                 const State       &state,
                 const Loads       &loads)
  {
    const PlacedBody *body = contact.body(loads);
    if (!body)
      return 0;
    return sum_over_points(contact, [&](const unsigned int point) {
      const double depth =
        (contact.points.may_touch(point)
           ? std::min(contact.clearance(state, loads, point), 0.)
           : 0.);
      return body->laws.condition().penalty_stiffness() * depth * depth / 2;
    });
  }


  double
  work_of_body_over_step(const ContactPair &contact,
                         const State       &state,
                         const Loads       &loads)
  {
    const PlacedBody *body = contact.body(loads);
    if (!body || !contact.body(state.step->loads_at_start))
      return 0;
    return sum_over_points(contact, [&](const unsigned int point) {
      const auto traction = traction_over_step(contact, state, loads, point);
      if (!traction)
        return 0.;
      const Point<3> x_0 =
        contact.points.position(state.step->start.displacement, point);
      return traction->value *
             (carried_along(contact, *state.step, body->body, x_0) - x_0);
    });
  }
} // namespace Biface
