// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_model_contact_friction_over_step_h
#define biface_model_contact_friction_over_step_h

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <optional>

#include <biface/contact/contact_state.h>
#include <biface/contact/friction.h>

namespace Biface
{
  class ContactPair;
  struct LinearizedTraction;
  struct Loads;


  /** How a body holds a point sideways over a StepInTime: friction at the place
   * at the end of the step, limited by the pressure over the step. */
  struct FrictionOverStep
  {
    /** The place of the point at the end, the normal of the body there, and the
     * stick point on the body. Unit: length. */
    dealii::Point<3>     x;
    dealii::Tensor<1, 3> normal;
    dealii::Point<3>     stick;
    /** The traction if the point sticks. Unit: force/area. */
    dealii::Tensor<1, 3> trial;
    ContactStatus        status;
    /** How the point slips, if it does. */
    FrictionLaw::Slip slip;

    /** The traction on the shell. Unit: force/area. */
    dealii::Tensor<1, 3>
    traction() const
    {
      return status == ContactStatus::slip ? slip.traction : trial;
    }

    /** The stick point on the body after the step. */
    dealii::Point<3>
    new_stick_point(const FrictionLaw &law) const;

    /** Add the traction and its stiffness.
     * @param secant whether to take the secant of a point that slips.
     * @param per_position the derivative of minus the pressure by the position
     * at the end. Unit: pressure/length. */
    void
    add_to(LinearizedTraction         &result,
           const FrictionLaw          &law,
           const bool                  secant,
           const dealii::Tensor<1, 3> &per_position) const;
  };


  /** The friction of a point; nothing if the body has none.
   * @param before the contact at the start of the step.
   * @param x the place at the end of the step.
   * @param touching where a point that comes has touched the body, or has been
   * at the start.
   * @param normal that of the body at the end.
   * @param pressure that over the step. Unit: force/area. */
  std::optional<FrictionOverStep>
  friction_over_step(const ContactPair          &contact,
                     const ContactState         &before,
                     const Loads                &loads,
                     const unsigned int          point,
                     const dealii::Point<3>     &x,
                     const dealii::Point<3>     &touching,
                     const dealii::Tensor<1, 3> &normal,
                     const double                pressure);
} // namespace Biface

#endif
