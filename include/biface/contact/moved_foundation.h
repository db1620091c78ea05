// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_contact_moved_foundation_h
#define biface_contact_moved_foundation_h

#include <memory>

#include <biface/contact/rigid_foundation.h>

namespace Biface
{
  /**
   * A foundation somewhere on its way. To the shell, its travel against its
   * direction is as if the shell had traveled along it, and so is how the shape
   * is asked, which itself stays where it is.
   */
  class MovedFoundation
  {
  public:
    explicit MovedFoundation(std::shared_ptr<const RigidFoundation> shape,
                             const double                           travel = 0)
      : shape(shape), travel(travel)
    {}

    /** The same foundation, farther on its way. */
    MovedFoundation
    moved(const double further) const
    {
      return MovedFoundation(shape, travel + further);
    }

    FoundationPoint
    evaluate(const dealii::Point<3> &x) const
    {
      return shape->evaluate(x + travel * shape->direction);
    }

    double
    clearance(const dealii::Point<3> &x) const
    {
      return evaluate(x).clearance;
    }

    /** How far it still has to go, see RigidFoundation. */
    double
    travel_to(const dealii::Point<3> &x) const
    {
      return shape->travel_to(x) - travel;
    }

    /** The unit vector against which it travels. */
    const dealii::Tensor<1, 3> &
    direction() const
    {
      return shape->direction;
    }

  private:
    std::shared_ptr<const RigidFoundation> shape;
    double                                 travel;
  };
} // namespace Biface

#endif
