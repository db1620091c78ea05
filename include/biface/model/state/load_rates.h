// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_model_state_load_rates_h
#define biface_model_state_load_rates_h

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <vector>

namespace Biface
{
  class RigidBody;


  /** The factor at a position, or the common one, which is the first, if there
   * is none. */
  template <typename Number>
  const Number &
  factor_at(const std::vector<Number> &factors, const unsigned int position)
  {
    return factors[position < factors.size() ? position : 0];
  }


  /** The derivatives of the loads by a parameter. */
  struct LoadRates
  {
    double              pressure = 0;
    std::vector<double> factors  = {0};
    /** The rate of the travel of the ground. */
    double travel = 0;
    /** The rate of the angular velocity of a rolling wheel, see Rolling. */
    double angular_velocity = 0;

    /** Add a multiple of other rates. */
    void
    add(const double scale, const LoadRates &other);

    /** The velocity of the point of a body at @p x. */
    dealii::Tensor<1, 3>
    velocity_of(const RigidBody &body, const dealii::Point<3> &x) const;

    /** The change of velocity_of(), at a point that does not move, as the body
     * moves by other rates. */
    dealii::Tensor<1, 3>
    change_of_velocity(const RigidBody        &body,
                       const dealii::Point<3> &x,
                       const LoadRates        &moves) const;

    /** The angular velocity of a body. */
    dealii::Tensor<1, 3>
    angular_velocity_of(const RigidBody &body) const;
  };
} // namespace Biface

#endif
