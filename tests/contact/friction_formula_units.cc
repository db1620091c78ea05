// SPDX-License-Identifier: LGPL-2.1-or-later

// A formula of the coefficient of friction that holds for the pressures of a
// run alone is accepted in any unit.

#include <biface/contact/friction.h>

#include <tests.h>

using namespace Biface;

int
main()
{
  const double in_MPa =
    FrictionLaw(FrictionCoefficient("Friction", "sqrt(1 - p)"), 1)
      .limit(0.19)
      .value;
  const double in_Pa =
    FrictionLaw(FrictionCoefficient("Friction", "sqrt(1 - 1e-6*p)"), 1)
      .limit(0.19e6)
      .value;
  check_small("in MPa", in_MPa - 0.9 * 0.19, 1e-15);
  check_small("in Pa", 1e-6 * in_Pa - in_MPa, 1e-15);
}
