// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/numbers.h>

#include <cmath>

#include <biface/input/parameter_tools.h>
#include <biface/laminate/surface_of_plies.h>

namespace Biface
{
  std::string
  PlyPlace::in_words() const
  {
    return position ? "(" + vector_to_string(*position) + ")"
                    : "alpha_1 = " + number_to_string(alpha_1);
  }


  double
  lift(const double         crown_angle,
       const double         ratio,
       const AngleReference reference)
  {
    constexpr double degree = dealii::numbers::PI / 180;
    const double     angle  = std::remainder(crown_angle, 180);
    // the pantograph of section 1 of doc/theory.md: the cosine of the angle
    // from the circumference, the sine of that from the meridian, grows as the
    // radius
    if (reference == AngleReference::meridian)
      return std::asin(ratio * std::sin(angle * degree)) / degree;
    return std::copysign(std::acos(ratio * std::cos(angle * degree)) / degree,
                         angle);
  }
} // namespace Biface
