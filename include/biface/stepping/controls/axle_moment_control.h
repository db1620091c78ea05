// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_stepping_controls_axle_moment_control_h
#define biface_stepping_controls_axle_moment_control_h

#include <biface/stepping/controls/equal_steps.h>

namespace Biface
{
  /** The moment of the axle on a rolling wheel and all loads are prescribed in
   * every step, zero for free rolling. The load parameter, the angular
   * velocity, is unknown. */
  class AxleMomentControl : public EqualSteps
  {
  public:
    using EqualSteps::check;
    using EqualSteps::EqualSteps;

    void
    check(const std::string &section, const KnownStart &start) const override;

    KnownStart
    known_end(const KnownStart &start) const override;

    void
    begin(const Equilibrium &from) override;

    Trial
    propose(const Equilibrium &from) const override;

    Memory
    get_memory() const override;

    void
    restore(const Memory &memory) override;

  protected:
    void
    change_way(const Stage &now, const LoadLevel &reached) override;

  private:
    /** The moment at a fraction of the stage. */
    double
    moment_at(const double fraction) const;

    double start_moment = 0;
  };
} // namespace Biface

#endif
