// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_stepping_controls_load_control_h
#define biface_stepping_controls_load_control_h

#include <biface/stepping/controls/equal_steps.h>

namespace Biface
{
  /** All loads and the travel of the ground are prescribed in every step.
   * The load parameter is the fraction of the stage. */
  class LoadControl : public EqualSteps
  {
  public:
    using EqualSteps::EqualSteps;

    Trial
    propose(const Equilibrium &from) const override;

  protected:
    void
    change_path(const Stage &now, const LoadLevel &reached) override;
  };
} // namespace Biface

#endif
