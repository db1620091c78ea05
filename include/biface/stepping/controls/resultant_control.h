// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_stepping_controls_resultant_control_h
#define biface_stepping_controls_resultant_control_h

#include <vector>

#include <biface/stepping/controls/equal_steps.h>
#include <biface/stepping/controls/resultant_equations.h>

namespace Biface
{
  /** Resultants of the ground and of bodies are prescribed in every step,
   * together with all loads but one for each of them, which is unknown. */
  class ResultantControl : public EqualSteps
  {
  public:
    ResultantControl(const Stage                &stage,
                     const Parameters           &parameters,
                     const ControlledResultants &resultants);

    void
    check(const std::string &section, const KnownStart &start) const override;

    void
    check(const std::string &section, const ShellMesh &mesh) const override;

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
    change_path(const Stage &now, const LoadLevel &reached) override;

  private:
    /** The prescribed resultants at a fraction of the stage. */
    std::vector<double>
    values_at(const double fraction) const;

    const ControlledResultants resultants;
    std::vector<double>        start_values;
  };
} // namespace Biface

#endif
