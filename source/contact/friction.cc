// SPDX-License-Identifier: LGPL-2.1-or-later

#include <algorithm>

#include <biface/contact/friction.h>
#include <biface/contact/friction_parameters.h>
#include <biface/input/entry_declarations.h>
#include <biface/input/parameter_tools.h>

namespace Biface
{
  using namespace dealii;

  void
  FrictionParameters::add_parameters(EntryDeclarations &prm)
  {
    // no number with a unit is built in: the tangential stiffness follows from
    // the wall, and a critical velocity must be given where a wheel needs one
    add_parsed(prm,
               "Friction",
               "0",
               coefficient,
               parse_friction,
               "Coefficient of Coulomb friction between the shell and "
               "the ground: a number, or a formula of the contact "
               "pressure p and of the slip velocity s, such as "
               "(0.8 - 0.5*p)*exp(-s/2000); below 0 it counts as 0. s "
               "is 0 unless the wheel rolls. Stages may have their own.",
               Unit::none());
    add_optional_number(
      prm,
      "Tangential regularization",
      tangential_stiffness,
      "automatic",
      "The tangential stiffness epsilon_t of friction: a node that sticks under "
      "a tangential traction t moves by t/epsilon_t. A positive number, or "
      "'automatic': 70 k with the stiffness k of 'Regularization'; in a shell "
      "as thin as a membrane, where k is limited, times the part of "
      "1/sum(h/E) that k is.",
      Unit("pressure/length"));
    add_choice(
      prm,
      "Rolling friction",
      in_rolling,
      {"slip velocity", "bristles"},
      "The law of the sliding friction of a rolling wheel, which is not its "
      "rolling resistance. 'bristles' is the law "
      "of the wheel that stands: what sticks to the ground is carried "
      "along, and the traction is 'Tangential regularization' times "
      "the way that the tread has moved over the ground since it "
      "entered the footprint, at most mu p. 'slip velocity' is a "
      "function of the velocity, see 'Critical velocity'.");
    prm.add_parameter(
      "Critical velocity",
      critical_velocity,
      "The velocity s_c in the law 'slip velocity' of a rolling "
      "wheel, t = -mu p s/sqrt(|s|^2 + s_c^2) with the slip "
      "velocity s: nodes that stick creep more slowly than "
      "s_c. About 5e-3 times the ground velocity; stages "
      "that roll with this law need it.",
      Patterns::Double(),
      Unit("length/time"));
  }


  void
  FrictionParameters::check() const
  {
    if (tangential_stiffness)
      check_positive("Contact/Tangential regularization",
                     *tangential_stiffness);
    check_not_negative("Contact/Critical velocity", critical_velocity);
  }


  double
  FrictionLaw::value(const double pressure, const double speed) const
  {
    if (!(pressure > 0))
      return 0;
    return part * coefficient.value(pressure, speed) * pressure;
  }


  FrictionLaw::Limit
  FrictionLaw::limit(const double pressure, const double speed) const
  {
    constexpr double small = 1e-5;

    Limit result;
    if (!(pressure > 0))
      return result;
    result.value = value(pressure, speed);
    if (coefficient.is_constant())
      {
        result.per_pressure = part * coefficient.value(pressure, speed);
        return result;
      }
    // relative, since the unit of the pressure is not known, and so that the
    // formula sees no pressure below 0
    const double step = small * pressure;
    result.per_pressure =
      (value(pressure + step, speed) - value(pressure - step, speed)) /
      (2 * step);
    if (speed > 0)
      {
        // formulas need no values below 0
        const double step  = small * std::max(speed, s_c);
        const double below = std::max(0., speed - step);
        const double above = speed + step;
        result.per_speed =
          (value(pressure, above) - value(pressure, below)) / (above - below);
      }
    return result;
  }


  FrictionLaw::Slip
  FrictionLaw::slip(const Tensor<1, 3> &trial, const double pressure) const
  {
    Slip         result;
    const double norm = trial.norm();
    // without a trial traction there is no direction of slip
    if (norm == 0)
      return result;
    // a longer trial traction is cut to the same one: only what is across it
    // counts in the derivative
    const Tensor<1, 3> direction = trial / norm;
    const Limit        limit     = this->limit(pressure);
    result.traction              = limit.value * direction;
    result.per_trial             = limit.value / norm *
                       (Tensor<2, 3>(unit_symmetric_tensor<3>()) -
                        outer_product(direction, direction));
    result.per_pressure = limit.per_pressure * direction;
    return result;
  }

} // namespace Biface
