// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/symmetric_tensor.h>

#include <biface/contact/contact_laws.h>
#include <biface/contact/tangential_law.h>
#include <biface/model/contact/contact_pair.h>
#include <biface/model/contact/friction_over_step.h>
#include <biface/model/state/placed_body.h>

namespace Biface
{
  using namespace dealii;

  Point<3>
  FrictionOverStep::new_stick_point(const FrictionLaw &law) const
  {
    return status == ContactStatus::slip
             ? Point<3>(x - law.elastic_slip(slip.traction))
             : stick;
  }


  void
  FrictionOverStep::add_to(LinearizedTraction &result,
                           const FrictionLaw  &law,
                           const bool          secant,
                           const Tensor<1, 3> &per_position) const
  {
    Tensor<2, 3> derivative =
      -law.tangential_stiffness() * (Tensor<2, 3>(unit_symmetric_tensor<3>()) -
                                     outer_product(normal, normal));
    if (status == ContactStatus::slip)
      derivative = (secant ? slip.traction.norm() / trial.norm() * derivative
                           : slip.per_trial * derivative) +
                   outer_product(slip.per_pressure, per_position);
    result.value += traction();
    // stiffnesses are minus the derivatives of tractions
    result.stiffness -= derivative;
  }


  std::optional<FrictionOverStep>
  friction_over_step(const ContactPair  &contact,
                     const ContactState &before,
                     const Loads        &loads,
                     const unsigned int  point,
                     const Point<3>     &x,
                     const Point<3>     &touching,
                     const Tensor<1, 3> &normal,
                     const double        pressure)
  {
    // bristles have tractions at the end of the step, all at once
    if (!contact.has_friction(loads) || contact.body(loads)->laws.bristles())
      return {};
    const PlacedBody  &body  = *contact.body(loads);
    const FrictionLaw &law   = body.laws.friction();
    const bool         stuck = before.statuses[point] != ContactStatus::none;
    FrictionOverStep   result;
    result.x      = x;
    result.normal = normal;
    // a point that comes sticks where it touches, whose friction in an impact
    // of one step would be lost otherwise
    result.stick =
      (stuck ? body.body.present(before.stick_points[point]) : touching);
    const Tensor<1, 3> from_stick = x - result.stick;
    result.trial = law.trial(from_stick - (normal * from_stick) * normal);
    result.status =
      (before.statuses[point] == ContactStatus::glued && stuck
         ? ContactStatus::glued
       : law.should_slip(result.trial, pressure) ? ContactStatus::slip
                                                 : ContactStatus::stick);
    if (result.status == ContactStatus::slip)
      result.slip = law.slip(result.trial, pressure);
    return result;
  }
} // namespace Biface
