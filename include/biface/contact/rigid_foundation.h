// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_contact_rigid_foundation_h
#define biface_contact_rigid_foundation_h

#include <deal.II/base/parameter_handler.h>

#include <memory>

#include <biface/contact/foundation_shapes.h>

namespace Biface
{
  /**
   * A rigid foundation at a given travel. Queries shift the point by the
   * travel; the shape itself never moves. Copies share the shape.
   */
  class RigidFoundation
  {
  public:
    /** The foundation on which the shell is pressed. */
    struct Parameters
    {
      enum class Shape
      {
        plane,
        drum,
        sphere
      };

      Shape                       shape = Shape::plane;
      FoundationShape::TravelLine line;
      RigidDrum::Parameters       drum;
      RigidSphere::Parameters     sphere;

      void
      add_parameters(dealii::ParameterHandler &prm);

      /** Throws InputError if a value is invalid. */
      void
      check() const;
    };

    /** The foundation at zero travel. Throws InputError if the parameters are
     * invalid. */
    explicit RigidFoundation(const Parameters &parameters);

    explicit RigidFoundation(std::shared_ptr<const FoundationShape> shape,
                             const double                           travel = 0)
      : shape(shape), travel(travel)
    {}

    /** The same foundation after a further travel. */
    RigidFoundation
    moved(const double further) const
    {
      return RigidFoundation(shape, travel + further);
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

    /** The remaining travel to a point, see FoundationShape. */
    double
    travel_to(const dealii::Point<3> &x) const
    {
      return shape->travel_to(x) - travel;
    }

    /** The unit vector opposite to the direction of travel. */
    const dealii::Tensor<1, 3> &
    direction() const
    {
      return shape->direction;
    }

  private:
    std::shared_ptr<const FoundationShape> shape;
    double                                 travel;
  };
} // namespace Biface

#endif
