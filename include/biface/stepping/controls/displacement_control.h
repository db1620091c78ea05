// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_stepping_controls_displacement_control_h
#define biface_stepping_controls_displacement_control_h

#include <biface/stepping/controls/equal_steps.h>

namespace Biface
{
  /** One component of the displacement of a named point is prescribed in every
   * step. The load parameter, the fraction of the change of the loads, is
   * unknown and may have any final value. */
  class DisplacementControl : public EqualSteps
  {
  public:
    using EqualSteps::EqualSteps;

    void
    check(const std::string &section, const KnownStart &start) const override;

    KnownStart
    known_end(const KnownStart &start) const override;

    void
    check(const std::string &section, const ShellMesh &mesh) const override;

    void
    begin(const Equilibrium &from) override;

    Trial
    propose(const Equilibrium &from) const override;

    void
    accept(const Step &step) override;

    std::optional<std::pair<std::string, double>>
    controlled() const override;

    Memory
    get_memory() const override;

    void
    restore(const Memory &memory) override;

  protected:
    void
    change_path(const Stage &now, const LoadLevel &reached) override;

  private:
    /** The prescribed displacement at a fraction of the stage. */
    double
    value_at(const double fraction) const;

    /** Refuse a stage that would change nothing. Throws InputError. */
    void
    check_value(const double start_value) const;

    double start_value   = 0;
    double load_fraction = 0;
  };
} // namespace Biface

#endif
