// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_stepping_controls_equal_steps_h
#define biface_stepping_controls_equal_steps_h

#include <optional>

#include <biface/stepping/controls/control.h>

namespace Biface
{
  /** A control whose steps are equal fractions of the stage, or larger ones
   * with adaptive steps. If a step is halved, the end of the equal step is
   * still reached. */
  class EqualSteps : public Control
  {
  public:
    using Control::Control;

    void
    begin(const Equilibrium &from) override;

    void
    accept(const Step &step) override;

    double
    done() const override
    {
      return fraction;
    }

    bool
    has_equal_steps() const override
    {
      return !stage.adaptive;
    }

    void
    restore(const Memory &memory) override;

  protected:
    /** The completed fraction of the stage after the next step. */
    double
    next() const;

    /** Continue from a fraction of the stage, if given, or start again.
     * @return whether it was given. */
    bool
    go_on_from(const std::optional<double> &part, const LoadLevel &reached);

    double
    step_size() const override
    {
      return next() - fraction;
    }

    double fraction = 0;

  private:
    /** The next end of an equal step or of the stage. */
    double
    next_target() const;
  };
} // namespace Biface

#endif
