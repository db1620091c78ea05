// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_contact_suspension_h
#define biface_contact_suspension_h

namespace Biface
{
  /** What resists a motion that a force finds, beside the shell; all zero for
   * nothing. Those of a motion that only turns have moments and angles. */
  struct Suspension
  {
    /** The stiffness of a spring without force at the factor 0. Unit:
     * force/length, or force*length per radian. */
    double spring = 0;
    /** Unit: force*time/length, or force*length*time per radian. */
    double damper = 0;
    /** The mass, or the moment of inertia. Unit: mass, or mass*length². */
    double mass = 0;

    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &spring &damper &mass;
    }
  };
} // namespace Biface

#endif
