// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_contact_contact_laws_of_stage_h
#define biface_contact_contact_laws_of_stage_h

#include <memory>
#include <optional>

namespace Biface
{
  class FrictionCoefficient;


  /** What a stage sets of the laws of contact; what is not set is that of the
   * section 'Contact'. */
  struct ContactLawsOfStage
  {
    /** The coefficient of friction of the ground; null if it is not set. */
    std::shared_ptr<const FrictionCoefficient> friction;
    /** The parameters @f$\varepsilon@f$ of ContactCondition and
     * @f$\varepsilon_t@f$ of FrictionLaw, of all bodies; a tread is in series
     * with them. Unit: pressure/length. */
    std::optional<double> penalty_stiffness, tangential_stiffness;
    /** Whether the nodes in contact with the ground at the start of the
     * stage cannot slip. */
    bool glued = false;
  };
} // namespace Biface

#endif
