// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_surface_joint_of_group_h
#define biface_surface_joint_of_group_h

#include <string>

namespace Biface
{
  /** How the parts of the surface are joined at the sides of a group. */
  struct JointOfGroup
  {
    /** The text of the user. */
    std::string text;
    std::string group;
    /** The moment per length and angle between the parts; infinite if they are
     * joined rigidly, zero at a hinge. Unit: force. */
    double stiffness;
  };
} // namespace Biface

#endif
