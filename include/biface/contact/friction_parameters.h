// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_contact_friction_parameters_h
#define biface_contact_friction_parameters_h

#include <optional>

#include <biface/contact/friction_coefficient.h>

namespace Biface
{
  class EntryDeclarations;


  /** The law of the sliding friction between the ground and a shell that rolls,
   * which is not its rolling resistance. */
  enum class FrictionInRolling
  {
    /** Friction by the slip velocity, see SlipVelocityLaw. */
    slip_velocity,
    /** Friction by the deflection of bristles, see BristleLaw. */
    bristles
  };


  /** The parameters of FrictionLaw and of friction in rolling. */
  struct FrictionParameters
  {
    FrictionCoefficient coefficient;
    /** The parameter @f$\varepsilon_t@f$; if not set, it follows from the
     * stiffness of the wall. Unit: pressure/length. */
    std::optional<double> tangential_stiffness;
    FrictionInRolling     in_rolling = FrictionInRolling::slip_velocity;
    /** The critical velocity, see FrictionLaw::critical_velocity(); 0 if not
     * given. Unit: length/time. */
    double critical_velocity = 0;

    void
    add_parameters(EntryDeclarations &prm);

    /** Throws InputError if a value is invalid. */
    void
    check() const;

    /** The parameter @f$\varepsilon_t@f$ on a wall of the given stiffness,
     * see ShellMesh::wall_stiffness_sideways(): a hundredth of the
     * @f$\varepsilon@f$ that follows from it, for far fewer iterations. */
    double
    tangential_stiffness_on(const double wall_stiffness) const
    {
      return tangential_stiffness.value_or(70 * wall_stiffness);
    }
  };
} // namespace Biface

#endif
