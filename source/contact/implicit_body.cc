// SPDX-License-Identifier: LGPL-2.1-or-later

#include <algorithm>
#include <cmath>
#include <limits>

#include <biface/contact/implicit_body.h>

namespace Biface
{
  using namespace dealii;

  namespace
  {
    /** The outward normal of a surface and its derivative along the surface. */
    struct SurfaceNormal
    {
      double                slope;
      Tensor<1, 3>          normal;
      SymmetricTensor<2, 3> curvature;

      explicit SurfaceNormal(const ImplicitSurface::Derivatives &at)
        : slope(at.gradient.norm())
        , normal(slope > 0 ? at.gradient / slope : Tensor<1, 3>({1., 0., 0.}))
      {
        if (!(slope > 0))
          return;
        // S of section 6 of doc/theory.md: the Hessian without its parts along
        // the normal, over the length of the gradient
        const Tensor<1, 3> of_slope = at.hessian * normal;
        curvature =
          (at.hessian - 2 * symmetrize(outer_product(normal, of_slope)) +
           (normal * of_slope) * symmetrize(outer_product(normal, normal))) /
          slope;
      }

      /** The Hessian, along the surface, of half the squared distance of a
       * point at the given clearance; the identity along the normal. */
      SymmetricTensor<2, 3>
      stretch(const double clearance) const
      {
        return unit_symmetric_tensor<3>() + clearance * curvature;
      }
    };


    /** The step of Newton's method toward a minimum; where the function is not
     * convex, a shorter one downhill. */
    Tensor<1, 3>
    downhill_step(SymmetricTensor<2, 3> hessian,
                  const Tensor<1, 3>   &minus_gradient)
    {
      constexpr double least = 0.05;

      // one eigenvalue is 1, that of the normal
      const double sum = trace(hessian) - 1, product = determinant(hessian);
      const double lowest =
        (sum - std::sqrt(std::max(0., sum * sum - 4 * product))) / 2;
      // shifted until it is positive definite: else the step would go to a
      // maximum of the distance, or very far
      if (lowest < least)
        hessian +=
          (least - 2 * std::min(lowest, 0.)) * unit_symmetric_tensor<3>();
      return invert(hessian) * minus_gradient;
    }
  } // namespace


  BodyPoint
  ImplicitBody::evaluate(const Point<3> &x) const
  {
    const Point<3> y(x - point);
    const bool     is_inside = (surface->value(y) < 0);
    double         distance  = std::numeric_limits<double>::infinity();
    Point<3>       closest;
    // the distance may have several local minima, one for each start
    surface->search_closest(y, [&](const Point<3> &start) -> const Point<3> & {
      const Point<3> found = closest_point(y, start);
      if (found.distance(y) < distance)
        {
          distance = found.distance(y);
          closest  = found;
        }
      return closest;
    });

    const SurfaceNormal at(surface->derivatives(closest));
    const double        sign     = (is_inside ? -1 : 1);
    Tensor<1, 3>        gradient = at.normal;
    // no foot of a perpendicular, such as an edge; at the surface, round-off
    if (at.normal * (y - closest) * sign <
        0.9 * distance - 1e-8 * surface->length())
      gradient = sign / distance * (y - closest);
    // close to a center of curvature the derivative of the normal is unbounded;
    // that at the surface keeps the tangent finite
    const SymmetricTensor<2, 3> stretch = at.stretch(sign * distance);
    return {sign * distance,
            -gradient,
            determinant(stretch) > 1e-8
              ? -symmetrize(Tensor<2, 3>(invert(stretch)) *
                            Tensor<2, 3>(at.curvature))
              : -at.curvature};
  }


  Point<3>
  ImplicitBody::closest_point(const Point<3> &x, Point<3> y) const
  {
    for (unsigned int iteration = 0; iteration < 50; ++iteration)
      {
        const SurfaceNormal at(surface->derivatives(y));
        const Tensor<1, 3>  way       = x - y;
        const double        clearance = way * at.normal;
        const Tensor<1, 3>  step =
          downhill_step(at.stretch(clearance), way - clearance * at.normal);
        if (!std::isfinite(step.norm()))
          break;
        // the next error is its square
        const bool is_last =
          (step.norm() <= 1e-7 * (surface->length() + way.norm()));
        // a step that leads away from the point is halved; whether the last one
        // does is a matter of round-off
        double   part = 1;
        Point<3> next;
        for (; part > 1e-3; part /= 2)
          {
            next = y + part * step;
            if (move_to_surface(next, at.normal, at.slope) &&
                (is_last || next.distance_square(x) < way.norm_square()))
              break;
          }
        if (part <= 1e-3)
          break;
        y = next;
        if (is_last)
          break;
      }
    return y;
  }


  bool
  ImplicitBody::move_to_surface(Point<3>           &y,
                                const Tensor<1, 3> &n,
                                double              slope) const
  {
    const double small = 1e-8 * surface->length();
    const double round_off =
      4 * std::numeric_limits<double>::epsilon() * (small + y.norm());
    // the method of secants
    double value = surface->value(y);
    double last  = std::numeric_limits<double>::infinity();
    for (unsigned int iteration = 0; iteration < 30; ++iteration)
      {
        const double step = -value / slope;
        if (!std::isfinite(step))
          return false;
        // differences become round-off
        if (std::abs(step) <= round_off ||
            (std::abs(last) <= small && std::abs(step) > std::abs(last) / 2))
          return true;
        y += step * n;
        const double next = surface->value(y);
        // over a shorter way the slope would be that of round-off
        if (std::abs(step) > small)
          slope = (next - value) / step;
        value = next;
        last  = step;
      }
    return false;
  }
} // namespace Biface
