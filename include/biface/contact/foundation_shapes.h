// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_contact_foundation_shapes_h
#define biface_contact_foundation_shapes_h

#include <deal.II/base/parameter_handler.h>
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
   * touches the point of its line of travel with the normal that is the
   * direction of that line.
   */
  class FoundationShape
  {
  public:
    /** The line along which a foundation travels. */
    struct TravelLine
    {
      /** From the shell toward the foundation, which travels against it: any
       * vector but zero; its length does not matter. */
      dealii::Tensor<1, 3> direction{{1, 0, 0}};
      dealii::Point<3>     point;
    };

    explicit FoundationShape(const TravelLine &line)
      : direction(line.direction / line.direction.norm()), point(line.point)
    {}

    virtual ~FoundationShape() = default;

    virtual FoundationPoint
    evaluate(const dealii::Point<3> &x) const = 0;

    /** How far the foundation travels until its surface comes to a point that
     * was apart from it; negative where it goes back. Plus infinity for a point
     * that it passes by, minus infinity for one that is never apart from it.
     * Unit: length. */
    virtual double
    travel_to(const dealii::Point<3> &x) const = 0;

    /** Of the line of travel, of unit length. */
    const dealii::Tensor<1, 3> direction;
    const dealii::Point<3>     point;
  };


  /** A half-space bounded by a plane, which travels against its normal. */
  class RigidPlane : public FoundationShape
  {
  public:
    using FoundationShape::FoundationShape;

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


  /** A ball; where its radius is negative, what is around a hollow one. */
  class RigidSphere : public FoundationShape
  {
  public:
    struct Parameters
    {
      double radius = 100;

      void
      add_parameters(dealii::ParameterHandler &prm);
    };

    /** Throws InputError where the parameters are not those of a sphere. */
    RigidSphere(const TravelLine &line, const Parameters &parameters);

    /** @param radius any number but 0. */
    RigidSphere(const TravelLine &line, const double radius)
      : FoundationShape(line), radius(radius)
    {}

    FoundationPoint
    evaluate(const dealii::Point<3> &x) const override;

    double
    travel_to(const dealii::Point<3> &x) const override;

  private:
    const double radius;
  };


  /** A cylinder without end: across its axis it is a RigidSphere. */
  class RigidDrum : public FoundationShape
  {
  public:
    struct Parameters
    {
      double               radius = 854;
      dealii::Tensor<1, 3> axis{{0, 1, 0}};

      void
      add_parameters(dealii::ParameterHandler &prm);
    };

    /** Throws InputError where the parameters are not those of a drum. */
    RigidDrum(const TravelLine &line, const Parameters &parameters);

    FoundationPoint
    evaluate(const dealii::Point<3> &x) const override;

    double
    travel_to(const dealii::Point<3> &x) const override;

  private:
    const dealii::Tensor<1, 3> axis;
    const RigidSphere          section;
  };
} // namespace Biface

#endif
