// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_contact_body_shapes_h
#define biface_contact_body_shapes_h

#include <deal.II/base/point.h>
#include <deal.II/base/symmetric_tensor.h>
#include <deal.II/base/tensor.h>

#include <memory>
#include <optional>

namespace Biface
{
  class BodySection;
  struct DrumParameters;
  struct SphereParameters;
  struct TravelLine;


  /** The geometry of a body at a point near it. */
  struct BodyPoint
  {
    /** The signed distance from the surface of the body, negative inside it.
     * Its gradient is a unit vector. Unit: length. */
    double clearance;

    /** The unit normal @f$\mathbf n@f$ into the body: minus the gradient of
     * the clearance. */
    dealii::Tensor<1, 3> normal;

    /** The derivative of the normal, minus the second derivative of the
     * clearance, by which the curvature of the body enters the tangent.
     * Unit: 1/length. */
    dealii::SymmetricTensor<2, 3> normal_gradient;
  };


  /**
   * The shape of a rigid body at rest. A ground, at zero travel, touches
   * the point of its line of travel with a normal along the direction of this
   * line.
   */
  class BodyShape
  {
  public:
    using TravelLine = Biface::TravelLine;

    explicit BodyShape(const TravelLine &line);

    virtual ~BodyShape() = default;

    virtual BodyPoint
    evaluate(const dealii::Point<3> &x) const = 0;

    /** The travel until the surface of a ground touches a point from
     * outside, negative if it must move back. Plus infinity for a point that it
     * misses, minus infinity for a point that is always inside. Must not be
     * called for shapes that are never the ground. Unit: length. */
    virtual double
    travel_to(const dealii::Point<3> &x) const;

    /** The cylinder that can turn about its axis under a wheel. */
    struct Cylinder
    {
      /** The unit vector along the axis, to the left of a wheel with the y
       * axis as its axle: its y component is not negative. */
      dealii::Tensor<1, 3> axis;
      /** The radius; negative if the cylinder is hollow. Unit: length. */
      double radius;
    };

    /** The cylinder of a drum; none for other shapes. */
    virtual std::optional<Cylinder>
    cylinder() const
    {
      return {};
    }

    /** The unit vector along the line of travel, and its point. */
    const dealii::Tensor<1, 3> direction;
    const dealii::Point<3>     point;
  };


  /** A half-space bounded by a plane, which travels against its normal. */
  class RigidPlane : public BodyShape
  {
  public:
    using BodyShape::BodyShape;

    BodyPoint
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


  /** A ball; with a negative radius, the space around a hollow ball. */
  class RigidSphere : public BodyShape
  {
  public:
    using Parameters = SphereParameters;

    /** Throws InputError if the parameters are invalid. */
    RigidSphere(const TravelLine &line, const Parameters &parameters);

    /** A sphere of a given radius.
     * @param radius any nonzero number. */
    RigidSphere(const TravelLine &line, const double radius)
      : BodyShape(line), radius(radius)
    {}

    BodyPoint
    evaluate(const dealii::Point<3> &x) const override;

    double
    travel_to(const dealii::Point<3> &x) const override;

  private:
    const double radius;
  };


  /** An infinitely long cylinder: in the section normal to its axis it is a
   * RigidSphere. */
  class RigidDrum : public BodyShape
  {
  public:
    using Parameters = DrumParameters;

    /** Throws InputError if the parameters are invalid. */
    RigidDrum(const TravelLine &line, const Parameters &parameters);

    BodyPoint
    evaluate(const dealii::Point<3> &x) const override;

    double
    travel_to(const dealii::Point<3> &x) const override;

    std::optional<Cylinder>
    cylinder() const override
    {
      return Cylinder{axis[1] < 0 ? -axis : axis, radius};
    }

  private:
    const dealii::Tensor<1, 3> axis;
    const double               radius;
    const RigidSphere          section;
  };


  /** A body with the same section along an axis, without ends. The coordinates
   * of the section are, from the point of the line of travel, that along the
   * cross product of axis and height, and the height, which is measured against
   * the direction of the line. */
  class ExtrudedBody : public BodyShape
  {
  public:
    /** The body with a section, extruded along an axis.
     * @param axis a unit vector, orthogonal to the direction. */
    ExtrudedBody(const TravelLine                  &line,
                 const dealii::Tensor<1, 3>        &axis,
                 std::shared_ptr<const BodySection> section);

    BodyPoint
    evaluate(const dealii::Point<3> &x) const override;

  private:
    /** The unit vectors of the coordinates of the section. */
    const dealii::Tensor<1, 3>               across, up;
    const std::shared_ptr<const BodySection> section;
  };


  /** A body of revolution. The coordinates of the section are that along the
   * axis, from the point of the line of travel, and the distance from the axis,
   * which is not negative. */
  class RevolvedBody : public BodyShape
  {
  public:
    /** The body with a section, revolved about an axis.
     * @param axis a unit vector. */
    RevolvedBody(const TravelLine                  &line,
                 const dealii::Tensor<1, 3>        &axis,
                 std::shared_ptr<const BodySection> section);

    BodyPoint
    evaluate(const dealii::Point<3> &x) const override;

  private:
    const dealii::Tensor<1, 3>               axis;
    const std::shared_ptr<const BodySection> section;
  };
} // namespace Biface

#endif
