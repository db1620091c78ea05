// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/quadrature_lib.h>

#include <cmath>
#include <limits>

#include <biface/base/errors.h>
#include <biface/input/entry_declarations.h>
#include <biface/input/parameter_tools.h>
#include <biface/model/forces/dependent_loads.h>
#include <biface/model/forces/gas.h>
#include <biface/model/state/loads.h>
#include <biface/model/state/state.h>
#include <biface/model/state/step_in_time.h>

namespace Biface
{
  using namespace dealii;

  void
  Gas::Parameters::add_parameters(EntryDeclarations &prm)
  {
    add_optional_number(
      prm,
      "Ambient pressure",
      ambient_pressure,
      "none",
      "Absolute pressure around the shell, which stages with 'Gas = sealed' "
      "need: 0.101325 MPa on the ground. If given, the volume of the cavity is "
      "a column of history.csv.",
      Unit("force/area"));
    prm.add_parameter("Polytropic exponent",
                      exponent,
                      "n in (p + p_a) V^n = constant, with the gauge pressure "
                      "p, the ambient pressure p_a and the volume V of a "
                      "sealed gas: 1 if its temperature is constant, 1.4 for "
                      "air that exchanges no heat.",
                      Patterns::Double(),
                      Unit::none());
    cavity.add_parameters(prm);
    air.add_parameters(prm);
  }


  void
  Gas::Parameters::check(const bool is_known) const
  {
    check_positive("Gas/Polytropic exponent", exponent);
    air.check();
    if (air.sound_speed && !ambient_pressure)
      throw InputError("Gas/Ambient pressure",
                       "none",
                       "it must be a number with a 'Sound speed'");
    if (!ambient_pressure)
      return;
    check_not_negative("Gas/Ambient pressure", *ambient_pressure);
    cavity.check(is_known);
  }


  Gas::Gas(const Parameters &parameters, const Cavity &cavity)
    : cavity(cavity)
    , ambient_pressure(*parameters.ambient_pressure)
    , exponent(parameters.exponent)
  {}


  void
  Gas::start_stage(const Loads &loads, State &state) const
  {
    // gas flows in and out until a stage seals it with the content that it then
    // has
    state.terms.erase(name());
    if (loads.sealed_gas)
      state.terms[name()].numbers = {(loads.pressure + ambient_pressure) *
                                     std::pow(cavity.volume(state), exponent)};
  }


  void
  Gas::set_dependent_loads(const State &state, Loads &loads) const
  {
    const auto sealed = state.terms.find(name());
    if (sealed == state.terms.end())
      return;
    const double content = sealed->second.numbers[0];
    loads.pressure       = (state.step ? mean_pressure(state, content).value
                                       : pressure(cavity.volume(state), content));
  }


  double
  Gas::pressure(const double volume, const double content) const
  {
    return volume > 0 ? content / std::pow(volume, exponent) - ambient_pressure
                      : std::numeric_limits<double>::quiet_NaN();
  }


  Gas::MeanPressure
  Gas::mean_pressure(const State &state, const double content) const
  {
    // exact to round-off for changes of the volume by a part of it; the energy
    // of the gas over the change of the volume would lose digits
    const QGauss<1> rule(6);
    const double    start = cavity.volume(state.step->start),
                 end      = cavity.volume(state);
    MeanPressure result{0, 0};
    for (unsigned int q = 0; q < rule.size(); ++q)
      {
        const double part = rule.point(q)[0], weight = rule.weight(q);
        const double volume = start + part * (end - start),
                     p      = pressure(volume, content);
        result.value += weight * p;
        result.per_volume -=
          weight * part * exponent * (p + ambient_pressure) / volume;
      }
    return result;
  }


  void
  Gas::add_dependent_loads(const State                 &state,
                           const Loads                 &loads,
                           std::vector<DependentLoads> &dependent) const
  {
    if (!loads.sealed_gas)
      return;
    // a term of rank one in the tangent, which would fill the matrix, section 5
    // of doc/theory.md
    DependentLoads pressure;
    pressure.rates.pressure = 1;
    pressure.gradient       = cavity.volume_gradient(state);
    pressure.gradient *=
      (state.step
         ? mean_pressure(state, state.terms.at(name()).numbers[0]).per_volume
         : -exponent * (loads.pressure + ambient_pressure) /
             cavity.volume(state));
    dependent.push_back(pressure);
  }
} // namespace Biface
