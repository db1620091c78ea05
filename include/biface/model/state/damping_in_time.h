// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_model_state_damping_in_time_h
#define biface_model_state_damping_in_time_h

namespace Biface
{
  /** The damping of a shell that moves. */
  struct DampingInTime
  {
    /** The force per mass and velocity. Unit: 1/time. */
    double of_mass = 0;
    /** The stress of a strain rate, divided by the stress of that strain. Unit:
     * time. */
    double of_stiffness = 0;
    /** The stress of a strain rate, divided by the stress of that strain and by
     * half the length of a step: @f$\chi@f$. */
    double numerical = 0;
    /** The part of the pressure of contact by which it is larger on the way in
     * than on the way out, 0 to 1. */
    double of_contact = 0;

    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &of_mass &of_stiffness &numerical &of_contact;
    }
  };
} // namespace Biface

#endif
