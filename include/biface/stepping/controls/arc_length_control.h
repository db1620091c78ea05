// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_stepping_controls_arc_length_control_h
#define biface_stepping_controls_arc_length_control_h

#include <biface/stepping/controls/control.h>

namespace Biface
{
  /**
   * The norm of the change of all displacements is prescribed in every step.
   * The load parameter, the fraction of the loads of the stage, is unknown and
   * may pass limit points until it reaches 1. The first step prescribes the
   * size of the change of the loads and thereby sets the length of the later
   * steps, which adapt.
   *
   * It moves toward the loads of the stage if the equilibrium is stable.
   * Otherwise, it moves in the direction of the last step, whatever controlled
   * it, or, from rest, toward the loads if the number of negative pivots is
   * even.
   */
  class ArcLengthControl : public Control
  {
  public:
    using Control::Control;

    void
    check(const std::string &section, const KnownStart &start) const override;

    void
    check(const std::string &section, const ShellMesh &mesh) const override;

    void
    begin(const Equilibrium &from) override;

    Trial
    propose(const Equilibrium &from) const override;

    /** A step that ends at the loads of the stage, if a step went beyond
     * them. */
    std::optional<Trial>
    replace(const Trial &trial, const LoadParameters &mu) const override;

    void
    accept(const Step &step) override;

    double
    done() const override
    {
      return load_fraction;
    }

    std::string
    stop_reason() const override;

    Memory
    get_memory() const override;

    void
    restore(const Memory &memory) override;

  protected:
    void
    change_path(const Stage &now, const LoadLevel &reached) override;

    void
    change_size() override;

  private:
    double       load_fraction = 0;
    unsigned int n_steps       = 0;
    double       first_length  = 0;
  };
} // namespace Biface

#endif
