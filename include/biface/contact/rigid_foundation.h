// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_contact_rigid_foundation_h
#define biface_contact_rigid_foundation_h

#include <deal.II/base/point.h>
#include <deal.II/base/symmetric_tensor.h>
#include <deal.II/base/tensor.h>

namespace Biface
{
  /** What a point near a foundation has to know of it. */
  struct FoundationPoint
  {
    /** The signed distance left to the surface of the foundation, negative
     * inside it. Its gradient is a unit vector. Unit: length. */
    double clearance;

    /** The unit normal @f$\mathbf n@f$, into the foundation: minus the gradient
     * of the clearance. */
    dealii::Tensor<1, 3> normal;

    /** The derivative of the normal, minus the second one of the clearance: by
     * it the foundation's curvature enters the tangent. Unit: 1/length. */
    dealii::SymmetricTensor<2, 3> normal_gradient;
  };


  /**
   * The shape of a rigid foundation, as it stands at the travel 0, where it
   * touches the point of its path with the normal that is the direction of the
   * path. MovedFoundation has it travel.
   */
  class RigidFoundation
  {
  public:
    /** The line on which a foundation travels. */
    struct Path
    {
      /** From the shell toward the foundation, which travels against it: any
       * vector but zero; its length does not matter. */
      dealii::Tensor<1, 3> direction{{1, 0, 0}};
      dealii::Point<3>     point;
    };

    explicit RigidFoundation(const Path &path)
      : direction(path.direction / path.direction.norm()), point(path.point)
    {}

    virtual ~RigidFoundation() = default;

    virtual FoundationPoint
    evaluate(const dealii::Point<3> &x) const = 0;

    /** How far the foundation travels until its surface comes to a point that
     * was apart from it; negative where it goes back. Plus infinity for a point
     * that it passes by, minus infinity for one that is never apart from it.
     * Unit: length. */
    virtual double
    travel_to(const dealii::Point<3> &x) const = 0;

    /** Of the path, of unit length. */
    const dealii::Tensor<1, 3> direction;
    const dealii::Point<3>     point;
  };
} // namespace Biface

#endif
