// SPDX-License-Identifier: LGPL-2.1-or-later

#include <biface/contact/friction_with_history.h>

namespace Biface
{
  using namespace dealii;

  void
  FrictionWithHistory::start_stage(ContactState &state) const
  {
    // the glue of an earlier stage ends in any case
    TangentialLaw::start_stage(state);
    if (glued)
      stick_all(state);
  }


  void
  FrictionWithHistory::stick_all(ContactState &state) const
  {
    for (ContactStatus &status : state.statuses)
      // what does not touch has no place on the body to be glued to
      if (status != ContactStatus::none)
        status = ContactStatus::glued;
  }


  FrictionWithHistory::Slip
  FrictionWithHistory::slip(const ContactState &state, const PointInContact &at)
  {
    const Tensor<1, 3> &n = at.at_body.normal;
    const Tensor<1, 3>  total =
      at.x - at.body.present(state.stick_points[at.point]);
    return {total, total - (n * total) * n};
  }


  bool
  FrictionWithHistory::decide(ContactState         &state,
                              const PointInContact &at,
                              const Tensor<1, 3>   &last) const
  {
    ContactStatus &status = state.statuses[at.point];
    if (status == ContactStatus::glued)
      return false;
    const auto         tangents = at.body.tangents(at.at_body.normal);
    const Tensor<1, 3> trial    = law.trial(slip(state, at).tangential);
    // A node that slips meets no resistance along its traction and moves too
    // far. Where it has passed its stick point, the reversed traction would
    // throw it back, and so forth.
    const bool reversed =
      status == ContactStatus::slip &&
      trial * (last[1] * tangents[0] + last[2] * tangents[1]) < 0;
    const bool beyond = law.should_slip(trial, -last[0]);
    status = (beyond && !reversed ? ContactStatus::slip : ContactStatus::stick);
    // a node beyond its limit that sticks all the same asks for another
    // iteration, whose traction tells where it slips
    return beyond && reversed;
  }


  Tensor<1, 3>
  FrictionWithHistory::traction(const ContactState   &state,
                                const PointInContact &at) const
  {
    const Tensor<1, 3> trial = law.trial(slip(state, at).tangential);
    return state.statuses[at.point] == ContactStatus::slip
             ? law.slip(trial, -state.multipliers[at.point][0]).traction
             : trial;
  }


  void
  FrictionWithHistory::linearize(const ContactState   &state,
                                 const PointInContact &at,
                                 LinearizedTraction   &traction) const
  {
    if (!acts_on(state, at.point))
      return;
    const Tensor<1, 3> &n      = at.at_body.normal;
    const double        lambda = state.multipliers[at.point][0];
    const double        exact  = condition.multiplier(at.at_body.clearance);
    const Tensor<2, 3>  normal_gradient(at.at_body.normal_gradient);
    const Slip          slip = this->slip(state, at);
    Tensor<1, 3>        t    = law.trial(slip.tangential);
    // the derivative of the trial traction by the position of the node
    Tensor<2, 3> derivative =
      -law.tangential_stiffness() *
      (Tensor<2, 3>(unit_symmetric_tensor<3>()) - outer_product(n, n) -
       (n * slip.total) * normal_gradient -
       outer_product(n, normal_gradient * slip.total));
    if (state.statuses[at.point] == ContactStatus::slip)
      {
        const FrictionLaw::Slip limited = law.slip(t, -lambda);
        t          = limited.traction + (lambda - exact) * limited.per_pressure;
        derivative = limited.per_trial * derivative +
                     outer_product(limited.per_pressure,
                                   condition.penalty_stiffness() * n);
      }
    traction.value += t;
    // stiffnesses are minus the derivatives of tractions
    traction.stiffness -= derivative;
  }


  void
  FrictionWithHistory::commit_step(ContactState         &state,
                                   const PointInContact &at) const
  {
    if (!acts_on(state, at.point))
      // a node that has entered slid freely in this step: a stick point where
      // it was before would tear it back by a finite distance
      TangentialLaw::commit_step(state, at);
    else if (state.statuses[at.point] == ContactStatus::slip)
      // without slip there is no direction for the traction of a node that
      // slips
      state.stick_points[at.point] =
        at.body.at_rest(Point<3>(at.x - law.elastic_slip(traction(state, at))));
  }


  Tensor<1, 3>
  FrictionWithHistory::slip_in_step(const ContactState &before,
                                    const ContactState &after,
                                    const RigidBody    &body,
                                    const unsigned int  node) const
  {
    if (after.statuses[node] != ContactStatus::slip ||
        before.statuses[node] == ContactStatus::none)
      return {};
    // both on the body at its place after the step, so that its own motion is
    // no slip
    return body.present(after.stick_points[node]) -
           body.present(before.stick_points[node]);
  }
} // namespace Biface
