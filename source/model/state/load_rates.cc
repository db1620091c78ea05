// SPDX-License-Identifier: LGPL-2.1-or-later

#include <biface/contact/rigid_body.h>
#include <biface/model/state/load_rates.h>

namespace Biface
{
  void
  LoadRates::add(const double scale, const LoadRates &other)
  {
    pressure += scale * other.pressure;
    if (factors.size() < other.factors.size())
      factors.resize(other.factors.size(), factors[0]);
    for (unsigned int i = 0; i < factors.size(); ++i)
      factors[i] += scale * factor_at(other.factors, i);
    travel += scale * other.travel;
    angular_velocity += scale * other.angular_velocity;
  }


  dealii::Tensor<1, 3>
  LoadRates::velocity_of(const RigidBody &body, const dealii::Point<3> &x) const
  {
    return body.velocity(x, travel, [this](const unsigned int factor) {
      return factor_at(factors, factor);
    });
  }


  dealii::Tensor<1, 3>
  LoadRates::change_of_velocity(const RigidBody        &body,
                                const dealii::Point<3> &x,
                                const LoadRates        &moves) const
  {
    const auto rate_of = [](const LoadRates &rates) {
      return [&rates](const unsigned int factor) {
        return factor_at(rates.factors, factor);
      };
    };
    return body.change_of_velocity(
      x, travel, rate_of(*this), moves.travel, rate_of(moves));
  }


  dealii::Tensor<1, 3>
  LoadRates::angular_velocity_of(const RigidBody &body) const
  {
    return body.angular_velocity(travel, [this](const unsigned int factor) {
      return factor_at(factors, factor);
    });
  }
} // namespace Biface
