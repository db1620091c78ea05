// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_model_contact_contact_over_step_h
#define biface_model_contact_contact_over_step_h

#include <deal.II/base/point.h>
#include <deal.II/base/symmetric_tensor.h>

#include <functional>
#include <optional>

#include <biface/contact/tangential_law.h>
#include <biface/model/contact/friction_over_step.h>

namespace Biface
{
  class ContactPair;
  struct Loads;
  struct State;


  /** What happens over a StepInTime at a point that touches a body. */
  struct OverStep
  {
    /** The place of the point at the end, its clearance there, and the normal
     * along which the multiplier acts. Unit: length. */
    dealii::Point<3>     x;
    double               clearance;
    dealii::Tensor<1, 3> normal;

    /** The multiplier, and its derivative by the clearance at the end. */
    struct Multiplier
    {
      double value, derivative;
    };
    Multiplier lambda;

    /** The derivative of the normal of the body halfway. Unit: 1/length. */
    dealii::SymmetricTensor<2, 3> normal_gradient;
    /** How the body holds the point sideways; not set without friction. */
    std::optional<FrictionOverStep> friction;
  };

  /** What happens at a point; nothing if it touches at neither end of the step.
   * @param state, loads those at the end of the step. */
  std::optional<OverStep>
  over_step(const ContactPair &contact,
            const State       &state,
            const Loads       &loads,
            const unsigned int point);

  /** The sum over the points of a pair on all ranks of a function of each,
   * times its area on a cell. */
  double
  sum_over_points(const ContactPair                               &contact,
                  const std::function<double(const unsigned int)> &function);


  /**
   * The traction of a body at a point over a StepInTime. With the clearances
   * c at its ends and @f$\varphi=\frac12\min(c,0)^2@f$, the multiplier is
   * @f$\varepsilon\,(\varphi_1-\varphi_0)/(c_1-c_0)@f$, so that its work is the
   * change of the energy of the spring, and what
   * DampingInTime::of_contact adds. On a curved body, the normal halfway is
   * corrected such that its product with the motion against the body is the
   * change of the clearance. Friction is that of the place at the end of the
   * step, limited by the pressure over the step; a point that comes sticks
   * where it touches.
   *
   * @param state, loads those at the end of the step.
   * @return nothing if the point touches at neither end.
   */
  std::optional<LinearizedTraction>
  traction_over_step(const ContactPair &contact,
                     const State       &state,
                     const Loads       &loads,
                     const unsigned int point);


  /** The energy in the springs of a pair on all ranks,
   * @f$\sum A\,\varepsilon\,\varphi@f$. Unit: force times length. */
  double
  contact_energy(const ContactPair &contact,
                 const State       &state,
                 const Loads       &loads);


  /** The work of a body on the springs of a pair over the StepInTime of a
   * state, on all ranks: that of the tractions on the motion of the body. Unit:
   * force times length. */
  double
  work_of_body_over_step(const ContactPair &contact,
                         const State       &state,
                         const Loads       &loads);
} // namespace Biface

#endif
