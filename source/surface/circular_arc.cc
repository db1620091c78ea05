// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/numbers.h>

#include <cmath>

#include <biface/base/errors.h>
#include <biface/input/entry_declarations.h>
#include <biface/input/parameter_tools.h>
#include <biface/surface/circular_arc.h>

namespace Biface
{
  using namespace dealii;

  void
  CircularArc::Parameters::add_parameters(EntryDeclarations &prm)
  {
    prm.add_parameter("Radius",
                      radius,
                      "Radius R_1 of the arc. Positive.",
                      Patterns::Double(),
                      Unit("length"));
    prm.add_parameter("Center radius",
                      center_radius,
                      "Distance of the center of the arc from the axis of "
                      "revolution (R_0 - R_1 for a torus of outer radius R_0; "
                      "0 for a sphere). Not negative.",
                      Patterns::Double(),
                      Unit("length"));
  }


  CircularArc::CircularArc(const Parameters &parameters)
    : radius(parameters.radius), center_radius(parameters.center_radius)
  {
    check_positive("Surface/Circular arc/Radius", radius);
    check_not_negative("Surface/Circular arc/Center radius", center_radius);
  }


  Meridian::PointOfCurve
  CircularArc::evaluate(const double s) const
  {
    const Tensor<1, 2> outward({std::cos(s), std::sin(s)});
    const Tensor<1, 2> along({-std::sin(s), std::cos(s)});
    return {Point<2>(center_radius, 0) + radius * outward,
            radius * along,
            -radius * outward};
  }


  double
  CircularArc::parameter_of(const Point<2> &point) const
  {
    return std::atan2(point[1], point[0] - center_radius);
  }


  std::pair<double, double>
  CircularArc::range() const
  {
    return {-numbers::PI, numbers::PI};
  }


  double
  CircularArc::coordinate_unit() const
  {
    return numbers::PI / 180;
  }
} // namespace Biface
