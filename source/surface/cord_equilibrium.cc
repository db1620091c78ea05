// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>

#include <biface/base/errors.h>
#include <biface/input/entry_declarations.h>
#include <biface/input/parameter_tools.h>
#include <biface/surface/cord_equilibrium.h>

#include <boost/math/quadrature/tanh_sinh.hpp>
#include <boost/math/tools/roots.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_fehlberg78.hpp>

namespace Biface
{
  using namespace dealii;

  namespace
  {
    const std::string section  = "Surface/Cord equilibrium/";
    const std::string no_angle = "from end half width";
    const std::string no_width = "from crown cord angle";
  } // namespace


  void
  CordEquilibrium::Parameters::add_parameters(EntryDeclarations &prm)
  {
    prm.add_parameter("Crown radius",
                      crown_radius,
                      "Largest radius of the curve, at alpha_1 = 0. Positive.",
                      Patterns::Double(),
                      Unit("length"));
    prm.add_parameter("Half width",
                      half_width,
                      "Largest distance of the curve from its plane of "
                      "symmetry y = 0. Positive.",
                      Patterns::Double(),
                      Unit("length"));
    prm.add_parameter("End radius",
                      end_radius,
                      "Radius at which the curve ends on both sides, such as "
                      "that of the rim flange. Positive, and less than the "
                      "crown radius.",
                      Patterns::Double(),
                      Unit("length"));
    add_optional_number(prm,
                        "Crown cord angle",
                        crown_cord_angle,
                        no_angle,
                        "Angle of the cords from the circumference at the "
                        "crown: above 0, at most 90 degrees, which is a "
                        "radial tire; or '" +
                          no_angle +
                          "' if the curve must end at 'End half width'.",
                        Unit::degrees());
    add_optional_number(prm,
                        "End half width",
                        end_half_width,
                        no_width,
                        "Distance of the ends of the curve from y = 0; '" +
                          no_width + "' if it follows from 'Crown cord angle'.",
                        Unit("length"));
  }


  double
  CordEquilibrium::Shape::one_minus_sine(const double depth) const
  {
    // From the depth below the crown, not from r: near the crown, where cos phi
    // vanishes, 1 - sin phi would be lost in round-off (section 1 of
    // doc/theory.md).
    const double r_c = crown_radius, cosine = std::cos(crown_cord_angle),
                 sine = std::sin(crown_cord_angle);
    const double drop = depth * (2 * r_c - depth); // r_c^2 - r^2
    const double a    = drop / (r_c * r_c - widest_radius * widest_radius);
    // sin beta / sin beta_c - 1
    const double q = drop * std::pow(cosine / (r_c * sine), 2);
    const double b = q / (1 + std::sqrt(1 + q));
    return a - b + a * b;
  }


  double
  CordEquilibrium::Shape::curvature(const double r) const
  {
    // k_1 = d(sin phi)/dr of section 1, where sin beta is 'sine'
    const double r_c = crown_radius, r_w = widest_radius;
    const double k    = std::cos(crown_cord_angle) / r_c;
    const double sine = std::sqrt(1 - k * k * r * r);
    return r * (2 - 3 * k * k * r * r + k * k * r_w * r_w) /
           (sine * std::sin(crown_cord_angle) * (r_c * r_c - r_w * r_w));
  }


  namespace
  {
    /** The integral of f(r)/cos phi from the radius @p r to the crown. The
     * substitution r_c - r = (r_c - r_0) t^2 removes the singularity at the
     * crown. */
    template <typename Function>
    double
    integrate_to_crown(const CordEquilibrium::Shape &shape,
                       const double                  r,
                       const Function               &f)
    {
      boost::math::quadrature::tanh_sinh<double> quadrature;
      const double                               depth = shape.crown_radius - r;
      return quadrature.integrate(
        [&](const double t) {
          const double d       = depth * t * t;
          const double lack    = shape.one_minus_sine(d);
          const double cosine2 = lack * (2 - lack);
          // cos^2 phi = (1 - sin phi)(1 + sin phi) keeps its digits at the
          // crown
          if (!(cosine2 > 0))
            return 0.;
          return f(1 - lack) * 2 * depth * t / std::sqrt(cosine2);
        },
        0.,
        1.,
        1e-13);
    }


    /** Whether the curve is convex at the crown and exists down to a radius. */
    bool
    reaches(const CordEquilibrium::Shape &shape, const double r)
    {
      // at sin phi = -1 the curve turns outward again
      return shape.curvature(shape.crown_radius) > 0 &&
             shape.one_minus_sine(shape.crown_radius - r) < 2;
    }


    /** A root of a function that changes its sign between @p a and @p b. */
    template <typename Function>
    double
    find_root(const Function &f, const double a, const double b)
    {
      std::uintmax_t max_iterations = 200;
      const auto     bracket        = boost::math::tools::toms748_solve(
        f, a, b, boost::math::tools::eps_tolerance<double>(50), max_iterations);
      return (bracket.first + bracket.second) / 2;
    }
  } // namespace


  double
  CordEquilibrium::Shape::half_width(const double r) const
  {
    if (!reaches(*this, r))
      return std::numeric_limits<double>::quiet_NaN();
    return integrate_to_crown(*this, r, [](const double sine) { return sine; });
  }


  namespace
  {
    using Shape = CordEquilibrium::Shape;

    /** The shape of the given half width at its widest point. If there is no
     * such shape, the result has a negative radius there.
     * @param max_half_width the largest half width of a shape. */
    Shape
    shape_of_width(const double crown_radius,
                   const double half_width,
                   const double crown_cord_angle,
                   double      &max_half_width)
    {
      Shape      shape{crown_radius, 0, crown_cord_angle};
      const auto excess = [&](const double r_w) {
        shape.widest_radius = r_w;
        return shape.half_width(r_w) - half_width;
      };
      // below, the crown would be concave
      const double cosine = std::cos(crown_cord_angle);
      const double square = 3 - 2 / (cosine * cosine);
      const double min_radius =
        crown_radius * (square > 0 ? std::sqrt(square) * (1 + 1e-10) : 1e-10);
      const double max_radius = crown_radius * (1 - 1e-10);
      max_half_width          = half_width + excess(min_radius);
      shape.widest_radius =
        (max_half_width > half_width && excess(max_radius) < 0
           ? find_root(excess, min_radius, max_radius)
           : -1);
      return shape;
    }


    constexpr double degree = numbers::PI / 180;


    Shape
    make_shape(const CordEquilibrium::Parameters &parameters)
    {
      const double r_c = parameters.crown_radius;
      check_positive(section + "Crown radius", r_c);
      check_positive(section + "Half width", parameters.half_width);
      check_positive(section + "End radius", parameters.end_radius);
      if (!(parameters.end_radius < r_c * (1 - 1e-6)))
        throw InputError(section + "End radius",
                         number_to_string(parameters.end_radius),
                         "it must be less than the crown radius");
      if (!(parameters.half_width > 1e-6 * r_c))
        throw InputError(section + "Half width",
                         number_to_string(parameters.half_width),
                         "it must be at least 1e-6 of the crown radius");
      if (parameters.crown_cord_angle && parameters.end_half_width)
        throw InputError(section + "End half width",
                         number_to_string(*parameters.end_half_width),
                         "it and 'Crown cord angle' must not both be "
                         "numbers: one of them must be '" +
                           no_width + "' or '" + no_angle + "'");
      if (!parameters.crown_cord_angle && !parameters.end_half_width)
        throw InputError(section + "Crown cord angle",
                         no_angle,
                         "then 'End half width' must be a number");

      double max_half_width = 0;
      if (parameters.crown_cord_angle)
        {
          const double angle = *parameters.crown_cord_angle;
          if (!(angle >= 1 && angle <= 90))
            throw InputError(section + "Crown cord angle",
                             number_to_string(angle),
                             "it must lie between 1 and 90 degrees");
          const Shape shape = shape_of_width(
            r_c, parameters.half_width, angle * degree, max_half_width);
          if (shape.widest_radius < 0)
            throw InputError(section + "Half width",
                             number_to_string(parameters.half_width),
                             "with this crown radius and cord angle it must "
                             "be less than " +
                               number_to_string(max_half_width));
          return shape;
        }

      check_positive(section + "End half width", *parameters.end_half_width);
      // how much wider the end is than it must be; NaN if there is no end
      double narrowest = std::numeric_limits<double>::infinity(), widest = 0;
      const auto excess = [&](const double angle) {
        const Shape shape = shape_of_width(
          r_c, parameters.half_width, angle * degree, max_half_width);
        if (shape.widest_radius < 0)
          return std::numeric_limits<double>::quiet_NaN();
        const double at_end = shape.half_width(parameters.end_radius);
        narrowest           = std::fmin(narrowest, std::max(at_end, 0.));
        widest              = std::fmax(widest, at_end);
        return at_end - *parameters.end_half_width;
      };
      // The end exists only for a part of the angles, so that a change of sign
      // is looked for degree by degree.
      constexpr double min_angle = 1;
      double           above = 90, before = excess(above);
      while (above > min_angle)
        {
          const double below = above - 1, after = excess(below);
          // false next to angles without an end, too
          if (before * after <= 0)
            return shape_of_width(r_c,
                                  parameters.half_width,
                                  find_root(excess, below, above) * degree,
                                  max_half_width);
          above  = below;
          before = after;
        }
      if (widest == 0)
        throw InputError(section + "Half width",
                         number_to_string(parameters.half_width),
                         "there is no crown cord angle from 1 to 90 degrees "
                         "for which the curve of this half width reaches the "
                         "end radius");
      throw InputError(section + "End half width",
                       number_to_string(*parameters.end_half_width),
                       "with crown cord angles from 1 to 90 degrees the curve "
                       "ends at half widths from " +
                         number_to_string(narrowest) + " to " +
                         number_to_string(widest));
    }
  } // namespace


  CordEquilibrium::CordEquilibrium(const Parameters &parameters)
    : shape(make_shape(parameters))
  {
    const double r_0 = parameters.end_radius;
    if (!reaches(shape, r_0))
      {
        const double r_c    = shape.crown_radius;
        const double lowest = find_root(
          [&](const double r) { return 2 - shape.one_minus_sine(r_c - r); },
          r_0,
          shape.widest_radius);
        throw InputError(section + "End radius",
                         number_to_string(r_0),
                         "it must be greater than " + number_to_string(lowest) +
                           ", where the curve turns outward again");
      }
    if (!(shape.half_width(r_0) > 0))
      throw InputError(section + "End radius",
                       number_to_string(r_0),
                       "the curve must end before it reaches y = 0");

    length = integrate_to_crown(shape, r_0, [](const double) { return 1.; });
    // The curve by arc length has no closed form. From the nearest of these
    // samples, evaluate() takes a single step.
    constexpr unsigned int n = 200;
    samples.push_back({{shape.crown_radius, 0, numbers::PI / 2}});
    for (unsigned int i = 0; i < n; ++i)
      samples.push_back(advance(samples.back(), length / n));
  }


  CordEquilibrium::Position
  CordEquilibrium::advance(const Position &position,
                           const double    distance) const
  {
    // as d(phi)/ds = -k_1(r), regular at the crown and at the widest point
    boost::numeric::odeint::runge_kutta_fehlberg78<Position> stepper;
    Position                                                 x = position;
    stepper.do_step(
      [this](const Position &at, Position &derivative, const double) {
        derivative = {
          {-std::cos(at[2]), std::sin(at[2]), -shape.curvature(at[0])}};
      },
      x,
      0.,
      distance);
    return x;
  }


  Meridian::PointOfCurve
  CordEquilibrium::evaluate(const double s) const
  {
    const double       spacing = length / (samples.size() - 1);
    const double       way     = std::min(std::abs(s), length);
    const unsigned int i       = std::lround(way / spacing);
    Position           x       = advance(samples[i], way - i * spacing);
    // the mirror image in the plane of symmetry
    if (s < 0)
      {
        x[1] = -x[1];
        x[2] = numbers::PI - x[2];
      }
    const double sine = std::sin(x[2]), cosine = std::cos(x[2]);
    return {Point<2>(x[0], x[1]),
            Tensor<1, 2>({-cosine, sine}),
            -shape.curvature(x[0]) * Tensor<1, 2>({sine, cosine})};
  }


  double
  CordEquilibrium::parameter_of(const Point<2> &point) const
  {
    // the nearest of the samples, then Newton's method for the foot of the
    // perpendicular
    const double   side = (point[1] < 0 ? -1 : 1);
    const Point<2> above(point[0], side * point[1]);
    const auto     nearest =
      std::min_element(samples.begin(),
                       samples.end(),
                       [&](const Position &a, const Position &b) {
                         return above.distance_square(Point<2>(a[0], a[1])) <
                                above.distance_square(Point<2>(b[0], b[1]));
                       }) -
      samples.begin();
    double s = length * nearest / (samples.size() - 1);
    for (unsigned int iteration = 0; iteration < 20; ++iteration)
      {
        const PointOfCurve curve  = evaluate(s);
        const Tensor<1, 2> offset = curve.position - above;
        const double       update = -(offset * curve.first_derivative) /
                              (1 + offset * curve.second_derivative);
        s = std::min(std::max(s + update, 0.), length);
        if (std::abs(update) < 1e-14 * length)
          break;
      }
    return side * s;
  }


  std::pair<double, double>
  CordEquilibrium::range() const
  {
    return {-length, length};
  }


  std::optional<double>
  CordEquilibrium::crown_cord_angle() const
  {
    return shape.crown_cord_angle / degree;
  }
} // namespace Biface
