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
    /** @param c_0, c_1 the clearances at the ends, not both positive.
     * @param damping see DampingInTime::of_contact. */
    OverStep::Multiplier
    multiplier_over_step(const double c_0,
                         const double c_1,
                         const double epsilon,
                         const double damping)
    {
      const double         change = c_1 - c_0;
      OverStep::Multiplier result;
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
    const Point<3>    x_1  = contact.points.position(state.displacement, point),
                   x_0     = carried_along(
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
    result.friction =
      friction_over_step(contact,
                         contact.state_of(step.start),
                         loads,
                         point,
                         x_1,
                         c_0 > 0 ? x_0 + c_0 / (c_0 - c_1) * motion : x_0,
                         end.normal,
                         -result.lambda.value);
    return result;
  }


  double
  sum_over_points(const ContactPair                               &contact,
                  const std::function<double(const unsigned int)> &function)
  {
    double sum = 0;
    for (const Cell &cell : contact.mesh.wall_elements())
      for (unsigned int i = 0; i < contact.points.on_cell().size(); ++i)
        sum += contact.points.area(cell, i) *
               function(contact.points.number(cell, i));
    return Utilities::MPI::sum(sum, contact.mesh.communicator);
  }


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
    if (at->friction)
      at->friction->add_to(result,
                           contact.body(loads)->laws.friction(),
                           state.step->secant_of_friction,
                           at->lambda.derivative * at->normal);
    return result;
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
