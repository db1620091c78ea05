// SPDX-License-Identifier: LGPL-2.1-or-later

// A node that slips has the traction mu(p) p along its trial traction, with the
// derivatives of differences, for a number and a formula; it slips if the trial
// traction is greater, and its elastic slip has the limit as trial traction. In
// rolling, a coefficient that falls with the slip velocity has the traction and
// the derivatives of theory, far below and above the critical velocity.

#include <biface/contact/friction.h>
#include <biface/contact/rolling.h>

#include <tests.h>

using namespace dealii;
using namespace Biface;

namespace
{
  void
  test(const std::string &coefficient, const double mu)
  {
    const double       p = 0.2, step = 1e-6;
    const FrictionLaw  law(FrictionCoefficient("Friction", coefficient), 50);
    const Tensor<1, 3> trial({0.3, -0.2, 0.1});
    const auto         slip = law.slip(trial, p);

    Tensor<2, 3> per_trial;
    for (unsigned int j = 0; j < 3; ++j)
      {
        Tensor<1, 3> e;
        e[j] = step;
        const auto change =
          (law.slip(trial + e, p).traction - law.slip(trial - e, p).traction) /
          (2 * step);
        for (unsigned int i = 0; i < 3; ++i)
          per_trial[i][j] = change[i];
      }
    const Tensor<1, 3> per_pressure = (law.slip(trial, p + step).traction -
                                       law.slip(trial, p - step).traction) /
                                      (2 * step);

    std::cout << coefficient << std::endl;
    check_small("  traction",
                (slip.traction - mu * p / trial.norm() * trial).norm(),
                1e-15);
    check_small(
      "  by the trial traction", (slip.per_trial - per_trial).norm(), 1e-9);
    check_small(
      "  by the pressure", (slip.per_pressure - per_pressure).norm(), 1e-8);
    check_small(
      "  elastic slip",
      (law.trial(law.elastic_slip(slip.traction)) - slip.traction).norm(),
      1e-16);
    const double limit = mu * p / trial.norm();
    check_true("  slips beyond the limit",
               law.should_slip(1.001 * limit * trial, p) &&
                 !law.should_slip(0.999 * limit * trial, p));
  }


  void
  test_slip_velocity(const double speed)
  {
    const double      p = 0.2, s_c = 0.5;
    const FrictionLaw law(
      FrictionCoefficient("Friction", "(1 + p)*exp(-s/10)"), 50, s_c);
    const Tensor<1, 3> direction({0.6, 0.8, 0});
    const Tensor<1, 3> across({-0.8, 0.6, 0});
    const auto         t = SlipVelocityLaw(law).traction(speed * direction, p);
    const double       root  = std::hypot(speed, s_c);
    const double       limit = (1 + p) * p * std::exp(-speed / 10);

    std::cout << "slip velocity " << speed << std::endl;
    check_small(
      "  traction", (t.value + limit * speed / root * direction).norm(), 1e-15);
    check_small("  by the slip velocity",
                direction * (t.per_slip * direction) +
                  limit *
                    (s_c * s_c / (root * root * root) - speed / root / 10),
                1e-9);
    check_small("  across it",
                (t.per_slip * across + limit / root * across).norm(),
                1e-15);
    check_small("  by the pressure",
                (t.per_pressure +
                 (1 + 2 * p) / (1 + p) / p * limit * speed / root * direction)
                  .norm(),
                1e-9);
  }
} // namespace


int
main()
{
  test("0.5", 0.5);
  test("0.8 - p", 0.6);
  test_slip_velocity(0.001);
  test_slip_velocity(20);
  const FrictionLaw law(FrictionCoefficient("Friction", "0.1 - p"), 50);
  check_true("no traction where the formula is negative",
             law.limit(0.2).value == 0 &&
               law.slip(Tensor<1, 3>({1, 0, 0}), 0.2).traction.norm() == 0);
  check_true("no traction in tension", law.limit(-0.01).value == 0);
}
