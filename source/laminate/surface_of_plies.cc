// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/numbers.h>

#include <cmath>

#include <biface/laminate/surface_of_plies.h>

namespace Biface
{
  double
  lift(const double         crown_angle,
       const double         ratio,
       const AngleReference reference)
  {
    constexpr double degree = dealii::numbers::PI / 180;
    const double     angle  = std::remainder(crown_angle, 180);
    if (reference == AngleReference::meridian)
      return std::asin(ratio * std::sin(angle * degree)) / degree;
    return std::copysign(std::acos(ratio * std::cos(angle * degree)) / degree,
                         angle);
  }
} // namespace Biface
