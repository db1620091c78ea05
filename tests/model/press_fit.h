// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_tests_model_press_fit_h
#define biface_tests_model_press_fit_h

#include <deal.II/base/numbers.h>

#include <cmath>

/** The force that pushes the cone of press_fit.prm into the ring, whose radius
 * it increases by 0.01: the radial one, 2 pi int E t w/R ds, times tan(5 + atan
 * mu). */
inline double
press_fit_force(const double friction)
{
  const double angle = 5 * dealii::numbers::PI / 180, radius = 50, length = 10,
               stiffness = 2e5, expansion = 0.01, sector = 2. / 360;
  const double radial =
    2 * dealii::numbers::PI * sector * stiffness * expansion *
    std::log(1 + length * std::tan(angle) / radius) / std::sin(angle);
  return radial * std::tan(angle + std::atan(friction));
}

#endif
