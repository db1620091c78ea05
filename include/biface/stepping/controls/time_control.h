// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_stepping_controls_time_control_h
#define biface_stepping_controls_time_control_h

#include <vector>

#include <biface/stepping/controls/load_control.h>
#include <biface/stepping/controls/resultant_equations.h>

namespace Biface
{
  /** All loads are prescribed in every step of a stage with inertia, as
   * functions of time, but for the factors of motions that forces find: these
   * are the load parameters, or else the completed fraction of the duration of
   * the stage. Steps are equal or follow the error in time, see
   * StageMotion::time_error. */
  class TimeControl : public LoadControl
  {
  public:
    TimeControl(const Stage                &stage,
                const Parameters           &parameters,
                const ControlledResultants &forces);

    void
    check(const std::string &section, const KnownStart &start) const override;

    void
    check(const std::string &section, const ShellMesh &mesh) const override;

    KnownStart
    known_end(const KnownStart &start) const override;

    Trial
    propose(const Equilibrium &from) const override;

    void
    accept(const Step &step) override;

    bool
    shorten(const double error_in_time) override;

  protected:
    void
    change_path(const Stage &now, const LoadLevel &reached) override;

  private:
    /** The loads at a fraction of the stage, with StageMotion::histories. */
    LoadLevel
    level_in_time(const double fraction) const;

    /** The forces on the motions that they find, at a fraction of the stage. */
    std::vector<double>
    forces_at(const double fraction) const;

    const ControlledResultants forces;
  };
} // namespace Biface

#endif
