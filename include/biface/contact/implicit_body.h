// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_contact_implicit_body_h
#define biface_contact_implicit_body_h

#include <deal.II/base/point.h>
#include <deal.II/base/symmetric_tensor.h>
#include <deal.II/base/tensor.h>

#include <functional>
#include <memory>

#include <biface/contact/body_shapes.h>

namespace Biface
{
  /** A surface where a smooth function, which is negative in a body, is zero.
   * Positions are measured from the point of the body. No function throws. */
  class ImplicitSurface
  {
  public:
    struct Derivatives
    {
      dealii::Tensor<1, 3>          gradient;
      dealii::SymmetricTensor<2, 3> hessian;
    };

    virtual ~ImplicitSurface() = default;

    virtual double
    value(const dealii::Point<3> &x) const = 0;

    virtual Derivatives
    derivatives(const dealii::Point<3> &x) const = 0;

    /** A length over which the surface changes little. Unit: length. */
    virtual double
    length() const = 0;

    /** A function that searches the closest point of the surface from a point
     * of the surface, and returns the closest one that any call has found. */
    using Search =
      std::function<const dealii::Point<3> &(const dealii::Point<3> &)>;

    /** Call a search from at least one point, and from all that may lead to the
     * point of the surface that is closest to @p x. */
    virtual void
    search_closest(const dealii::Point<3> &x, const Search &search) const = 0;
  };


  /**
   * A body that is bounded by an ImplicitSurface. The clearance is the distance
   * from the closest point of the surface, in which the curvature of the
   * surface gives the second derivative: a principal curvature @f$\kappa@f$ of
   * the surface is that of the clearance, @f$\kappa/(1+c\,\kappa)@f$, at the
   * clearance @f$c@f$.
   *
   * It is exact if one of the starts of the surface leads to the closest point;
   * else it is the distance of another point of the surface. The sign is always
   * right. Where two points are closest, one of them counts, and the second
   * derivative at a center of curvature is any finite one.
   */
  class ImplicitBody : public BodyShape
  {
  public:
    ImplicitBody(const TravelLine                      &line,
                 std::shared_ptr<const ImplicitSurface> surface)
      : BodyShape(line), surface(std::move(surface))
    {}

    BodyPoint
    evaluate(const dealii::Point<3> &x) const override;

  private:
    /** The point of the surface at the smallest distance from @p x that is
     * found downhill from the point @p y of the surface. */
    dealii::Point<3>
    closest_point(const dealii::Point<3> &x, dealii::Point<3> y) const;

    /** Move a point close to the surface along its normal @p n to the surface.
     * @param slope the derivative along the normal.
     * @return whether the surface has been found. */
    bool
    move_to_surface(dealii::Point<3>           &y,
                    const dealii::Tensor<1, 3> &n,
                    double                      slope) const;

    const std::shared_ptr<const ImplicitSurface> surface;
  };
} // namespace Biface

#endif
