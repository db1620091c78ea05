// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include <biface/model/contact/contact_over_step.h>
#include <biface/model/contact/contact_pair.h>
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
  } // namespace


  std::optional<LinearizedTraction>
  traction_over_step(const ContactPair &contact,
                     const State       &state,
                     const Loads       &loads,
                     const unsigned int point)
  {
    if (!contact.points.may_touch(point))
      return {};
    const StepInTime &step = *state.step;
    const PlacedBody &body = *contact.body(loads);
    const Point<3>    x_1  = contact.points.position(state.displacement, point),
                   x_0     = carried_along(
                     contact,
                     step,
                     body.body,
                     contact.points.position(step.start.displacement, point));
    const double c_0 = body.body.clearance(x_0), c_1 = body.body.clearance(x_1);
    if (c_0 > 0 && c_1 > 0)
      return {};

    const auto lambda =
      multiplier_over_step(c_0,
                           c_1,
                           body.laws.condition().penalty_stiffness(),
                           step.damping.of_contact);
    const Tensor<1, 3> motion  = x_1 - x_0;
    const BodyPoint    halfway = body.body.evaluate(x_0 + motion / 2);
    Tensor<1, 3>       normal  = halfway.normal;
    const double       missing = c_0 - c_1 - normal * motion,
                 square        = motion.norm_square();
    // what round-off of the positions leaves is no curvature
    constexpr double roundoff = 64 * std::numeric_limits<double>::epsilon();
    if (std::abs(missing) > roundoff * (x_1.norm() + std::abs(c_1)))
      normal += missing / square * motion;

    LinearizedTraction result;
    result.value     = lambda.value * normal;
    result.stiffness = lambda.derivative * outer_product(normal, normal) -
                       lambda.value / 2 * Tensor<2, 3>(halfway.normal_gradient);
    // what holds the point sideways at the end of the step
    if (contact.has_friction(loads) && contact.state_of(state).active[point])
      {
        LinearizedTraction with = contact.traction(state, loads, point);
        const BodyPoint    end  = body.body.evaluate(x_1);
        result.value += with.value - (with.value * end.normal) * end.normal;
        result.stiffness += with.stiffness -
                            body.laws.condition().penalty_stiffness() *
                              outer_product(end.normal, end.normal) +
                            contact.state_of(state).multipliers[point][0] *
                              Tensor<2, 3>(end.normal_gradient);
      }
    return result;
  }


  double
  contact_energy(const ContactPair &contact,
                 const State       &state,
                 const Loads       &loads)
  {
    double            sum  = 0;
    const PlacedBody *body = contact.body(loads);
    if (body)
      for (const Cell &cell : contact.mesh.wall_elements())
        for (unsigned int i = 0; i < contact.points.on_cell().size(); ++i)
          {
            const unsigned int point = contact.points.number(cell, i);
            if (!contact.points.may_touch(point))
              continue;
            const double depth =
              std::min(contact.clearance(state, loads, point), 0.);
            sum += contact.points.area(cell, i) * depth * depth / 2 *
                   body->laws.condition().penalty_stiffness();
          }
    return Utilities::MPI::sum(sum, contact.mesh.communicator);
  }


  double
  work_of_body_over_step(const ContactPair &contact,
                         const State       &state,
                         const Loads       &loads)
  {
    double            sum  = 0;
    const PlacedBody *body = contact.body(loads);
    if (body && contact.body(state.step->loads_at_start))
      for (const Cell &cell : contact.mesh.wall_elements())
        for (unsigned int i = 0; i < contact.points.on_cell().size(); ++i)
          {
            const unsigned int point = contact.points.number(cell, i);
            const auto         traction =
              traction_over_step(contact, state, loads, point);
            if (!traction)
              continue;
            const Point<3> x_0 =
              contact.points.position(state.step->start.displacement, point);
            sum +=
              contact.points.area(cell, i) *
              (traction->value *
               (carried_along(contact, *state.step, body->body, x_0) - x_0));
          }
    return Utilities::MPI::sum(sum, contact.mesh.communicator);
  }
} // namespace Biface
