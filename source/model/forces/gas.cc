// SPDX-License-Identifier: LGPL-2.1-or-later

#include <cmath>
#include <limits>

#include <biface/base/errors.h>
#include <biface/input/parameter_tools.h>
#include <biface/model/forces/gas.h>

namespace Biface
{
  using namespace dealii;

  void
  Gas::Parameters::add_parameters(ParameterHandler &prm)
  {
    add_optional_number(
      prm,
      "Ambient pressure",
      ambient_pressure,
      "none",
      "Absolute pressure around the shell, which stages with 'Gas = sealed' "
      "need: 0.101325 MPa on the ground. If given, the volume of the cavity is "
      "a column of history.csv. Unit: force/area.");
    prm.add_parameter("Polytropic exponent",
                      exponent,
                      "n in (p + p_a) V^n = constant, with the gauge pressure "
                      "p, the ambient pressure p_a and the volume V of a "
                      "sealed gas: 1 if its temperature is constant, 1.4 for "
                      "air that exchanges no heat. No unit.",
                      Patterns::Double());
    cavity.add_parameters(prm);
  }


  void
  Gas::Parameters::check(const bool has_axis) const
  {
    check_positive("Gas/Polytropic exponent", exponent);
    if (!ambient_pressure)
      return;
    check_not_negative("Gas/Ambient pressure", *ambient_pressure);
    cavity.check(has_axis);
  }


  Gas::Gas(const ShellMesh       &mesh,
           const Parameters      &parameters,
           const Resultants::Face face)
    : cavity(mesh, parameters.cavity, face)
    , ambient_pressure(*parameters.ambient_pressure)
    , exponent(parameters.exponent)
  {}


  double
  Gas::content(const double pressure, const State &state) const
  {
    return (pressure + ambient_pressure) *
           std::pow(cavity.volume(state), exponent);
  }


  double
  Gas::Sealed::pressure(const State &state) const
  {
    const double volume = gas.cavity.volume(state);
    if (!(volume > 0))
      return std::numeric_limits<double>::quiet_NaN();
    return content / std::pow(volume, gas.exponent) - gas.ambient_pressure;
  }


  LA::Vector
  Gas::Sealed::pressure_gradient(const State &state) const
  {
    const double volume   = gas.cavity.volume(state);
    LA::Vector   gradient = gas.cavity.volume_gradient(state);
    gradient *= -gas.exponent * content / std::pow(volume, gas.exponent + 1);
    return gradient;
  }
} // namespace Biface
