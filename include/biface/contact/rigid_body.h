// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_contact_rigid_body_h
#define biface_contact_rigid_body_h

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <biface/contact/body_shapes.h>

namespace Biface
{
  struct BodyMotion;
  struct GroundParameters;


  /**
   * A rigid body at its present place: a ground at a given travel, which
   * may also have moved sideways and turned, or another body after its motions.
   * Queries move the point back; the shape itself never moves. Copies share the
   * shape.
   */
  class RigidBody
  {
  public:
    using Parameters = GroundParameters;

    /** The ground at zero travel. Throws InputError if the parameters are
     * invalid. */
    explicit RigidBody(const Parameters &parameters);

    explicit RigidBody(std::shared_ptr<const BodyShape> shape,
                       const double                     travel = 0)
      : shape(shape), travel(travel)
    {}

    /** A body that does not travel unless a motion says so. */
    static RigidBody
    without_travel(std::shared_ptr<const BodyShape> shape)
    {
      RigidBody result(shape);
      result.travels = false;
      return result;
    }

    /** The body after a further travel. */
    RigidBody
    moved(const double further) const
    {
      RigidBody result = *this;
      result.travel += further;
      return result;
    }

    /** The body after further motions: moved sideways by a vector and turned by
     * an angle in radians, right-handed about its direction at rest, or another
     * one. The axis of the turn passes through the given point before the body
     * slides, and slides with it. */
    RigidBody
    displaced(const dealii::Tensor<1, 3>                &slide,
              const double                               turn,
              const dealii::Point<3>                    &pivot,
              const std::optional<dealii::Tensor<1, 3>> &about = {}) const;

    /** The body after a further turn by an angle in radians, right-handed about
     * an axis of unit length through the origin. */
    RigidBody
    rotated(const dealii::Tensor<1, 3> &axis, const double angle) const;

    /** The body after further motions: their axes slide with the sum of their
     * translations.
     * @param factor_of gives the factor at a position.
     * @param axis of unit length, of turns without one of their own.
     * @param on_axis a point of all axes; both at the present place. */
    RigidBody
    after_motions(const std::vector<BodyMotion>                   &motions,
                  const std::function<double(const unsigned int)> &factor_of,
                  const dealii::Tensor<1, 3>                      &axis,
                  const dealii::Point<3> &on_axis) const;

    /** The body behind a layer that separates it from the shell: its clearances
     * are smaller by this distance. */
    RigidBody
    offset_by(const double distance) const
    {
      RigidBody result = *this;
      result.distance += distance;
      return result;
    }

    BodyPoint
    evaluate(const dealii::Point<3> &x) const;

    /** The velocity of the point of the body at @p x.
     * @param travel the rate of the travel of the ground.
     * @param rate_of gives the rate of the factor at a position. */
    dealii::Tensor<1, 3>
    velocity(const dealii::Point<3>                          &x,
             const double                                     travel,
             const std::function<double(const unsigned int)> &rate_of) const;

    /** The change of velocity() at a fixed point as the body moves by other
     * rates, with which its axes move along. */
    dealii::Tensor<1, 3>
    change_of_velocity(
      const dealii::Point<3>                          &x,
      const double                                     travel,
      const std::function<double(const unsigned int)> &rate_of,
      const double                                     other_travel,
      const std::function<double(const unsigned int)> &other_rate_of) const;

    /** The angular velocity of the body for the given rates, see velocity(). */
    dealii::Tensor<1, 3>
    angular_velocity(
      const double                                     travel,
      const std::function<double(const unsigned int)> &rate_of) const;

    /** The point of the ground at rest, before all motions, that is now at
     * @p x. */
    dealii::Point<3>
    at_rest(const dealii::Point<3> &x) const
    {
      return back(x) + travel * shape->direction;
    }

    /** The present position of a point of the ground at rest. */
    dealii::Point<3>
    present(const dealii::Point<3> &at_rest) const;

    /** Two unit vectors orthogonal to a normal and to each other, which turn
     * with the ground. With the normal along the direction of the
     * ground they are the axis that is farthest from it, made orthogonal to
     * it, and the cross product of the direction and the first; they are
     * rotated to other normals by the shortest rotation from the direction, or
     * from its opposite if that is closer by far. */
    std::array<dealii::Tensor<1, 3>, 2>
    tangents(const dealii::Tensor<1, 3> &normal) const;

    /** The derivatives of tangents() by the normal. */
    std::array<dealii::Tensor<2, 3>, 2>
    tangent_derivatives(const dealii::Tensor<1, 3> &normal) const;

    double
    clearance(const dealii::Point<3> &x) const
    {
      return evaluate(x).clearance;
    }

    /** The remaining travel to a point, see BodyShape::travel_to(). */
    double
    travel_to(const dealii::Point<3> &x) const
    {
      return shape->travel_to(back(x)) - travel;
    }

    /** The present place of the point of the ground on its line of
     * travel. */
    dealii::Point<3>
    apex() const
    {
      return present(shape->point);
    }

    /** The displacement of apex() from its place at rest. */
    dealii::Tensor<1, 3>
    displacement_of_point() const
    {
      return apex() - shape->point;
    }

    /** The rotation of the body as a vector along its axis, with an angle up to
     * pi. */
    dealii::Tensor<1, 3>
    rotation_vector() const;

    /** The cylinder with its present axis, see BodyShape::cylinder(). */
    std::optional<BodyShape::Cylinder>
    cylinder() const;

    /** The unit vector opposite to the direction of travel, which turns with
     * the ground. */
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

    /** The body after a further motion. */
    RigidBody
    after(Displacement further) const;

    /** The tangents where the normal is the direction of the ground. */
    std::array<dealii::Tensor<1, 3>, 2>
    tangents_of_direction() const;

    /** The direction or its opposite, whichever can be rotated to a normal, and
     * the tangents for it as the normal. */
    std::pair<dealii::Tensor<1, 3>, std::array<dealii::Tensor<1, 3>, 2>>
    reference_of_tangents(const dealii::Tensor<1, 3> &normal) const;

    /** The place of a point of the body before its displacement. */
    dealii::Point<3>
    back(const dealii::Point<3> &x) const;

    /** The velocity of the body per unit of the rate of a factor. */
    struct Screw
    {
      unsigned int         factor;
      dealii::Tensor<1, 3> translation;
      /** The angular velocity as a vector. */
      dealii::Tensor<1, 3> spin;
      /** A point of the axis. */
      dealii::Point<3> point;

      /** The rate of the factor, see RigidBody::velocity(). */
      double
      rate(const double                                     travel,
           const std::function<double(const unsigned int)> &rate_of) const;
    };

    std::shared_ptr<const BodyShape> shape;
    double                           travel;
    bool                             travels = true;
    /** The thickness of the layer in front of the body, see offset_by(). */
    double                      distance = 0;
    std::optional<Displacement> displacement;
    /** The motions of the body, of which the later ones take along the axes of
     * those before. */
    std::vector<Screw> screws;
  };
} // namespace Biface

#endif
