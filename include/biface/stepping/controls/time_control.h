// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_stepping_controls_time_control_h
#define biface_stepping_controls_time_control_h

#include <biface/stepping/controls/load_control.h>

namespace Biface
{
  /** All loads are prescribed in every step of a stage with inertia, as
   * functions of time. The load parameter is the completed fraction of the
   * duration of the stage. Steps are equal or follow the error in time, see
   * StageMotion::time_error. */
  class TimeControl : public LoadControl
  {
  public:
    using LoadControl::LoadControl;

    Trial
    propose(const Equilibrium &from) const override;

    void
    accept(const Step &step) override;

    bool
    shorten(const double error_in_time) override;

  private:
    /** The loads at a fraction of the stage, with StageMotion::histories. */
    LoadLevel
    level_in_time(const double fraction) const;
  };
} // namespace Biface

#endif
