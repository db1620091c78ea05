// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_contact_rigid_plane_h
#define biface_contact_rigid_plane_h

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

namespace Biface
{
  /**
   * A rigid half-space @f$\mathbf n\cdot\mathbf x\ge d@f$ bounded by a plane.
   * Its normal points from the shell into the foundation.
   */
  class RigidPlane
  {
  public:
    /**
     * @param normal any vector but zero; its length does not matter.
     * @param offset the distance d of the plane from the origin, along the
     * normal. Unit: length.
     */
    RigidPlane(const dealii::Tensor<1, 3> &normal, const double offset)
      : unit_normal(normal / normal.norm()), offset(offset)
    {}

    /** The distance left between a point and the foundation; negative for a
     * point inside it. */
    double
    clearance(const dealii::Point<3> &x) const
    {
      return offset - height(x);
    }

    /** How far a point lies along the normal. */
    double
    height(const dealii::Point<3> &x) const
    {
      return unit_normal * x;
    }

    /** The normal @f$\mathbf n@f$, minus the gradient of the clearance. */
    const dealii::Tensor<1, 3> &
    normal() const
    {
      return unit_normal;
    }

    /** The plane moved against its normal, into the shell. */
    RigidPlane
    moved(const double travel) const
    {
      return RigidPlane(unit_normal, offset - travel);
    }

  private:
    dealii::Tensor<1, 3> unit_normal;
    double               offset;
  };
} // namespace Biface

#endif
