// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_contact_rigid_body_h
#define biface_contact_rigid_body_h

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <array>
#include <memory>
#include <optional>

#include <biface/contact/body_shapes.h>

namespace Biface
{
  /**
   * A rigid foundation at a given travel, which may also have moved sideways
   * and turned. Queries move the point back; the shape itself never moves.
   * Copies share the shape.
   */
  class RigidBody
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

      Shape                   shape = Shape::plane;
      BodyShape::TravelLine   line;
      RigidDrum::Parameters   drum;
      RigidSphere::Parameters sphere;

      void
      add_parameters(dealii::ParameterHandler &prm);

      /** Throws InputError if a value is invalid. */
      void
      check() const;
    };

    /** The foundation at zero travel. Throws InputError if the parameters are
     * invalid. */
    explicit RigidBody(const Parameters &parameters);

    explicit RigidBody(std::shared_ptr<const BodyShape> shape,
                       const double                     travel = 0)
      : shape(shape), travel(travel)
    {}

    /** The same foundation after a further travel. */
    RigidBody
    moved(const double further) const
    {
      RigidBody result = *this;
      result.travel += further;
      return result;
    }

    /** The same foundation after further motions: moved sideways by a vector
     * and turned by an angle in radians, right-handed about its direction. The
     * axis of the turn passes through the given point before the foundation
     * slides, and slides with it. */
    RigidBody
    displaced(const dealii::Tensor<1, 3> &slide,
              const double                turn,
              const dealii::Point<3>     &pivot) const;

    /** The same foundation after a further turn by an angle in radians,
     * right-handed about an axis of unit length through the origin. */
    RigidBody
    around(const dealii::Tensor<1, 3> &axis, const double angle) const;

    BodyPoint
    evaluate(const dealii::Point<3> &x) const;

    /** The point of the foundation at rest, before all motions, that is now at
     * @p x. */
    dealii::Point<3>
    at_rest(const dealii::Point<3> &x) const
    {
      return back(x) + travel * shape->direction;
    }

    /** The present position of a point of the foundation at rest. */
    dealii::Point<3>
    present(const dealii::Point<3> &at_rest) const;

    /** Two unit vectors orthogonal to a normal and to each other, which turn
     * with the foundation. With the normal along the direction of the
     * foundation they are the axis that is farthest from it, made orthogonal to
     * it, and the cross product of the direction and the first; they are
     * rotated to other normals by the shortest rotation. */
    std::array<dealii::Tensor<1, 3>, 2>
    tangents(const dealii::Tensor<1, 3> &normal) const;

    /** Their derivatives by the normal. */
    std::array<dealii::Tensor<2, 3>, 2>
    tangent_derivatives(const dealii::Tensor<1, 3> &normal) const;

    double
    clearance(const dealii::Point<3> &x) const
    {
      return evaluate(x).clearance;
    }

    /** The remaining travel to a point, see BodyShape. */
    double
    travel_to(const dealii::Point<3> &x) const
    {
      return shape->travel_to(back(x)) - travel;
    }

    /** The present place of the point of the foundation on its line of
     * travel. */
    dealii::Point<3>
    apex() const
    {
      return present(shape->point);
    }

    /** With its present axis, see BodyShape::cylinder(). */
    std::optional<BodyShape::Cylinder>
    cylinder() const;

    /** The unit vector opposite to the direction of travel, which turns with
     * the foundation. */
    dealii::Tensor<1, 3>
    direction() const
    {
      return displacement ? displacement->rotation * shape->direction
                          : shape->direction;
    }

  private:
    /** The motion other than the travel. */
    struct Displacement
    {
      dealii::Tensor<1, 3> slide;
      dealii::Tensor<2, 3> rotation;
      dealii::Point<3>     pivot;
    };

    /** The same foundation after a further motion. */
    RigidBody
    after(Displacement further) const;

    /** The tangents where the normal is the direction of the foundation. */
    std::array<dealii::Tensor<1, 3>, 2>
    tangents_of_direction() const;

    /** A point before this motion. */
    dealii::Point<3>
    back(const dealii::Point<3> &x) const;

    std::shared_ptr<const BodyShape> shape;
    double                           travel;
    std::optional<Displacement>      displacement;
  };
} // namespace Biface

#endif
