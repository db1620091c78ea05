// SPDX-License-Identifier: LGPL-2.1-or-later

// The meridian 'cord equilibrium' passes through crown radius, half width and
// end radius; the membrane forces of pantographing cords are in equilibrium
// with the pressure everywhere; position and derivatives agree; the limits are
// those of radial cords; and the crown angle follows from the end, too.


#include <biface/surface/cord_equilibrium.h>
#include <biface/surface/surface_of_revolution.h>

#include <tests.h>

using namespace dealii;
using namespace Biface;

namespace
{
  constexpr double degree = numbers::PI / 180;


  CordEquilibrium::Parameters
  parameters(const double crown_radius,
             const double half_width,
             const double end_radius,
             const double angle)
  {
    CordEquilibrium::Parameters p;
    p.crown_radius     = crown_radius;
    p.half_width       = half_width;
    p.end_radius       = end_radius;
    p.crown_cord_angle = angle;
    return p;
  }


  void
  check_curve(const std::string &name, const CordEquilibrium::Parameters &p)
  {
    std::cout << name << std::endl;
    const auto                curve = std::make_shared<CordEquilibrium>(p);
    const SurfaceOfRevolution surface(curve);
    const double r_c = p.crown_radius, r_w = curve->widest_radius(),
                 beta_c = *curve->crown_cord_angle() * degree;
    const double end    = curve->range().second;
    const double h      = 1e-4 * end;

    double width = 0, normal = 0, axial = 0, first = 0, second = 0, inverse = 0,
           symmetry = 0;
    for (int i = -500; i <= 500; ++i)
      {
        const double s     = end * i / 500;
        const auto   point = curve->evaluate(s);
        const double r     = point.position[0];
        width              = std::max(width, point.position[1]);

        // forces per length along and across the meridian under p = 1
        const double beta = std::acos(std::cos(beta_c) * r / r_c);
        const double N_1 =
          (r_c * r_c - r_w * r_w) * std::sin(beta_c) / (2 * r * std::sin(beta));
        const double       N_2 = N_1 / std::pow(std::tan(beta), 2);
        const SurfacePoint at  = surface.evaluate(Point<2>(s, 0.7));
        normal                 = std::max(
          normal, std::abs(N_1 * at.curvature[0] + N_2 * at.curvature[1] - 1));
        axial = std::max(axial,
                         std::abs(N_1 * r * point.first_derivative[1] -
                                  (r * r - r_w * r_w) / 2));

        inverse =
          std::max(inverse, std::abs(curve->parameter_of(point.position) - s));
        const auto mirror = curve->evaluate(-s);
        symmetry          = std::max(
          symmetry, mirror.position.distance(Point<2>(r, -point.position[1])));
        if (std::abs(i) == 500)
          continue;
        const auto before = curve->evaluate(s - h),
                   after  = curve->evaluate(s + h);
        first             = std::max(first,
                         ((after.position - before.position) / (2 * h) -
                          point.first_derivative)
                           .norm());
        second            = std::max(
          second,
          r_c * ((after.first_derivative - before.first_derivative) / (2 * h) -
                 point.second_derivative)
                  .norm());
      }
    check_small("  crown radius", curve->evaluate(0).position[0] - r_c, 0);
    if (r_w > p.end_radius)
      check_small("  half width", width - p.half_width, 1e-4, p.half_width);
    check_small("  end radius",
                curve->evaluate(end).position[0] - p.end_radius,
                1e-12,
                r_c);
    check_small("  equilibrium along the normal", normal, 1e-11);
    check_small("  equilibrium along the axis", axial, 1e-12, r_c * r_c);
    check_small("  first derivative", first, 1e-7);
    check_small("  second derivative", second, 1e-6);
    check_small("  parameter of a point", inverse, 1e-12, end);
    check_small("  symmetry", symmetry, 0);
    const double at_widest =
      CordEquilibrium::Shape{r_c, r_w, beta_c}.half_width(r_w);
    check_small("  half width at the widest radius",
                at_widest - p.half_width,
                1e-12,
                p.half_width);

    // the same curve from where it ends
    CordEquilibrium::Parameters by_end = p;
    by_end.crown_cord_angle.reset();
    by_end.end_half_width = curve->evaluate(end).position[1];
    check_small("  crown cord angle from the end",
                *CordEquilibrium(by_end).crown_cord_angle() * degree - beta_c,
                1e-11);
  }
} // namespace


int
main()
{
  check_curve("an aircraft tire", parameters(590, 202, 298, 39));
  check_curve("a bicycle tire", parameters(340, 20, 305, 45));
  check_curve("it ends above the widest point", parameters(250, 60, 230, 36));
  check_curve("a flat crown", parameters(250, 60, 180, 33));

  // with radial cords, sin phi = (r^2 - r_w^2)/(r_c^2 - r_w^2)
  std::cout << "radial cords" << std::endl;
  const CordEquilibrium radial(parameters(300, 100, 180, 90));
  const double          r_w  = radial.widest_radius();
  double                sine = 0;
  for (int i = -100; i <= 100; ++i)
    {
      const auto   point = radial.evaluate(radial.range().second * i / 100);
      const double r     = point.position[0];
      sine               = std::max(sine,
                      std::abs(point.first_derivative[1] -
                               (r * r - r_w * r_w) / (300. * 300 - r_w * r_w)));
    }
  check_small("  sine of the normal", sine, 1e-13);
  // whose half width for r_w = 0 is a constant of the lemniscate
  check_small("  largest half width",
              CordEquilibrium::Shape{1, 0, 90 * degree}.half_width(0) -
                0.5990701173677961,
              1e-13);
  // tan^2 = 2 of the cylinder: the crown is straight in the limit
  check_small(
    "  a cylinder's angle",
    CordEquilibrium::Shape{1, 0, std::atan(std::sqrt(0.5))}.curvature(1),
    1e-14);
}
