// SPDX-License-Identifier: LGPL-2.1-or-later

#include <biface/model/contact/friction_with_history.h>

namespace Biface
{
  using namespace dealii;

  void
  FrictionWithHistory::start_stage(State &state) const
  {
    TangentialLaw::start_stage(state);
    if (glued)
      hold(state);
  }


  void
  FrictionWithHistory::hold(State &state) const
  {
    for (Grip &grip : state.grips)
      if (grip != Grip::none)
        grip = Grip::glued;
  }


  FrictionWithHistory::Slip
  FrictionWithHistory::slip(const State         &state,
                            const Loads         &loads,
                            const NodeInContact &at)
  {
    const Tensor<1, 3> &n = at.foundation.normal;
    const Tensor<1, 3>  total =
      at.x - loads.foundation->present(state.stick_points[at.node]);
    return {total, total - (n * total) * n};
  }


  bool
  FrictionWithHistory::decide(State               &state,
                              const Loads         &loads,
                              const NodeInContact &at,
                              const Tensor<1, 3>  &last) const
  {
    Grip &grip = state.grips[at.node];
    if (grip == Grip::glued)
      return false;
    const auto tangents      = loads.foundation->tangents(at.foundation.normal);
    const Tensor<1, 3> trial = law.trial(slip(state, loads, at).tangential);
    // A node that slips meets no resistance along its traction and moves too
    // far. Where it has passed its stick point, the reversed traction would
    // throw it back, and so forth.
    const bool reversed =
      grip == Grip::slip &&
      trial * (last[1] * tangents[0] + last[2] * tangents[1]) < 0;
    const bool beyond = law.should_slip(trial, -last[0]);
    grip              = (beyond && !reversed ? Grip::slip : Grip::stick);
    return beyond && reversed;
  }


  Tensor<1, 3>
  FrictionWithHistory::traction(const State         &state,
                                const Loads         &loads,
                                const NodeInContact &at) const
  {
    const Tensor<1, 3> trial = law.trial(slip(state, loads, at).tangential);
    return state.grips[at.node] == Grip::slip
             ? law.slip(trial, -state.multipliers[at.node][0]).traction
             : trial;
  }


  void
  FrictionWithHistory::linearize(const State         &state,
                                 const Loads         &loads,
                                 const NodeInContact &at,
                                 LinearizedTraction  &traction) const
  {
    if (!acts_on(state, at.node))
      return;
    const Tensor<1, 3> &n      = at.foundation.normal;
    const double        lambda = state.multipliers[at.node][0];
    const double        exact  = condition.multiplier(at.foundation.clearance);
    const Tensor<2, 3>  normal_gradient(at.foundation.normal_gradient);
    const Slip          slip = this->slip(state, loads, at);
    Tensor<1, 3>        t    = law.trial(slip.tangential);
    // the derivative of the trial traction by the position of the node
    Tensor<2, 3> derivative =
      -law.stiffness() *
      (Tensor<2, 3>(unit_symmetric_tensor<3>()) - outer_product(n, n) -
       (n * slip.total) * normal_gradient -
       outer_product(n, normal_gradient * slip.total));
    if (state.grips[at.node] == Grip::slip)
      {
        const FrictionLaw::Slip limited = law.slip(t, -lambda);
        t          = limited.traction + (lambda - exact) * limited.per_pressure;
        derivative = limited.per_trial * derivative +
                     outer_product(limited.per_pressure,
                                   condition.multiplier_stiffness() * n);
      }
    traction.value += t;
    traction.stiffness -= derivative;
  }


  void
  FrictionWithHistory::commit_step(State               &state,
                                   const Loads         &loads,
                                   const NodeInContact &at) const
  {
    if (!acts_on(state, at.node))
      TangentialLaw::commit_step(state, loads, at);
    else if (state.grips[at.node] == Grip::slip)
      // without slip there is no direction for the traction of a node that
      // slips
      state.stick_points[at.node] = loads.foundation->at_rest(
        Point<3>(at.x - law.elastic_slip(traction(state, loads, at))));
  }


  Tensor<1, 3>
  FrictionWithHistory::slip_in_step(const State       &before,
                                    const State       &after,
                                    const Loads       &loads,
                                    const unsigned int node) const
  {
    if (after.grips[node] != Grip::slip || before.grips[node] == Grip::none)
      return {};
    return loads.foundation->present(after.stick_points[node]) -
           loads.foundation->present(before.stick_points[node]);
  }
} // namespace Biface
