// SPDX-License-Identifier: LGPL-2.1-or-later

#include <algorithm>
#include <cmath>
#include <utility>

#include <biface/solver/gas_stiffness.h>
#include <biface/solver/held_tangent.h>

namespace Biface
{
  namespace
  {
    LoadRates
    unit_pressure()
    {
      LoadRates rates;
      rates.pressure = 1;
      return rates;
    }
  } // namespace


  GasStiffness::GasStiffness(const ShellEquations &equations,
                             const State          &state,
                             const Loads          &loads,
                             const Gas::Sealed    &gas)
    : forces(equations.load_direction(
        state, HeldTangent::without_foundation(loads), unit_pressure()))
    , pressure_gradient(gas.pressure_gradient(state))
  {
    equations.mesh.condense(pressure_gradient);
  }


  bool
  GasStiffness::is_symmetric() const
  {
    constexpr double parallel = 1e-8;

    const double norm = pressure_gradient.l2_norm();
    if (norm == 0)
      return true;
    LA::Vector difference(forces);
    difference /= forces.l2_norm();
    difference.add((pressure_gradient * forces < 0 ? 1 : -1) / norm,
                   pressure_gradient);
    return difference.l2_norm() <= parallel;
  }


  void
  GasStiffness::vmult_add(LA::Vector       &product,
                          const LA::Vector &x,
                          const double      factor) const
  {
    product.add(-factor * (pressure_gradient * x), forces);
  }


  void
  GasStiffness::Tvmult_add(LA::Vector       &product,
                           const LA::Vector &x,
                           const double      factor) const
  {
    product.add(-factor * (forces * x), pressure_gradient);
  }


  void
  GasStiffness::sadd(const double s, const double a, const GasStiffness &other)
  {
    pressure_gradient.sadd(s, a, other.pressure_gradient);
  }


  GasStiffness
  GasStiffness::transposed() const
  {
    GasStiffness result = *this;
    std::swap(result.forces, result.pressure_gradient);
    return result;
  }


  bool
  GasStiffness::prepare(const Solve &solve)
  {
    per_pressure.reinit(forces);
    if (!solve(per_pressure, forces))
      return false;
    determinant = 1 - pressure_gradient * per_pressure;
    return determinant != 0 && std::isfinite(determinant);
  }


  void
  GasStiffness::correct(LA::Vector &x, const double by_supports) const
  {
    x.add((pressure_gradient * x + by_supports) / determinant, per_pressure);
  }


  unsigned int
  GasStiffness::n_negative(const unsigned int of_matrix) const
  {
    if (determinant > 0)
      return of_matrix;
    // one eigenvalue changes its sign; a gas that is compressed stiffens
    return pressure_gradient * forces < 0 ? std::max(of_matrix, 1u) - 1
                                          : of_matrix + 1;
  }
} // namespace Biface
