// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_contact_rigid_plane_h
#define biface_contact_rigid_plane_h

#include <biface/contact/rigid_foundation.h>

namespace Biface
{
  /** A rigid half-space bounded by a plane, which travels against its normal.
   */
  class RigidPlane : public RigidFoundation
  {
  public:
    using RigidFoundation::RigidFoundation;

    FoundationPoint
    evaluate(const dealii::Point<3> &x) const override
    {
      return {direction * (point - x), direction, {}};
    }

    double
    travel_to(const dealii::Point<3> &x) const override
    {
      return direction * (point - x);
    }
  };
} // namespace Biface

#endif
