// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_stepping_controls_resultant_equations_h
#define biface_stepping_controls_resultant_equations_h

#include <memory>
#include <string>
#include <vector>

#include <biface/stepping/controls/controlled_resultant.h>

namespace Biface
{
  using ControlledResultants =
    std::vector<std::shared_ptr<const ControlledResultant>>;


  /** Check that all resultants fit the mesh. Throws InputError.
   * @param section that of the stage. */
  void
  check(const ControlledResultants &resultants,
        const std::string          &section,
        const ShellMesh            &mesh);

  /** The loads that resultants find, of a level. */
  LoadParameters
  found_loads(const ControlledResultants &resultants, const LoadLevel &level);

  /** A level with other values of the loads that resultants find. */
  LoadLevel
  with_found_loads(const ControlledResultants &resultants,
                   const LoadLevel            &level,
                   const LoadParameters       &values);

  /** What is known before the run at the end of a stage that finds the loads of
   * given resultants, so that later stages cannot be checked against them. */
  Control::KnownStart
  without_found_loads(const ControlledResultants &resultants,
                      const Control::KnownStart  &end);


  /** The equations by which resultants have prescribed values: as many as
   * unknown loads, see section 7 of doc/theory.md. */
  class ResultantEquations : public ControlEquations
  {
  public:
    /** @param contact kept by reference, where the iteration knows nothing of
     * it, as in time; otherwise null. */
    ResultantEquations(const ControlledResultants &resultants,
                       const std::vector<double>  &values,
                       const ContactInteraction   *contact = nullptr);

    LoadParameters
    parameter_changes(const Iteration               &iteration,
                      const LA::Vector              &dV_R,
                      const std::vector<LA::Vector> &dV_q) const override;

    LoadParameters
    parameter_changes_about(const Iteration               &about,
                            const Iteration               &iteration,
                            const LA::Vector              &dV_R,
                            const std::vector<LA::Vector> &dV_q) const override;

    std::string
    remedies() const override;

    double
    violation(const Iteration &iteration) const override;

  private:
    LoadedShell
    with_contact(const LoadedShell &shell) const;

    const ControlledResultants      resultants;
    const std::vector<double>       values;
    const ContactInteraction *const contact;
  };
} // namespace Biface

#endif
