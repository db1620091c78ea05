// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_contact_friction_h
#define biface_contact_friction_h

#include <deal.II/base/tensor.h>

#include <biface/contact/friction_coefficient.h>

namespace Biface
{
  struct FrictionParameters;


  /**
   * Coulomb's law of friction, regularized like the contact condition of
   * @cite GrigolyukKulikovPlotnikova2004, eq. (14.1).
   *
   * Each node in contact has a stick point on the ground. With the
   * tangential part @f$\mathbf s@f$ of the vector from this point to the node,
   * the trial traction is @f$\mathbf q=-\varepsilon_t\mathbf s@f$. The traction
   * on the shell is
   * - if the node sticks: @f$\mathbf q@f$, with
   *   @f$|\mathbf q|\le\tau(p)=\mu(p)\,p@f$;
   * - if it slips: @f$\tau(p)\,\mathbf q/|\mathbf q|@f$. The stick point
   * follows the node such that at the end of the step @f$\mathbf q@f$ equals
   * it, the implicit Euler method for the flow rule of perfect plasticity
   *   @cite SimoLaursen1992.
   */
  class FrictionLaw
  {
  public:
    using Parameters = FrictionParameters;

    /** The law with a coefficient.
     * @param tangential_stiffness the parameter @f$\varepsilon_t@f$. Unit:
     * pressure/length.
     * @param critical_velocity the parameter @f$s_c@f$ of SlipVelocityLaw. */
    FrictionLaw(const FrictionCoefficient &coefficient,
                const double               tangential_stiffness,
                const double               critical_velocity = 0)
      : coefficient(coefficient)
      , epsilon_t(tangential_stiffness)
      , s_c(critical_velocity)
    {}

    const FrictionCoefficient &
    get_coefficient() const
    {
      return coefficient;
    }

    /** The law with another critical velocity. */
    FrictionLaw
    with_critical_velocity(const double velocity) const
    {
      FrictionLaw law = *this;
      law.s_c         = velocity;
      return law;
    }

    /** The law with a part of the coefficient. */
    FrictionLaw
    with_part_of_friction(const double further_part) const
    {
      FrictionLaw law = *this;
      law.part *= further_part;
      return law;
    }

    /** The maximum traction @f$\tau@f$, with its derivatives by the pressure
     * and the slip velocity. */
    struct Limit
    {
      double value = 0, per_pressure = 0, per_speed = 0;
    };

    /** The limit of friction. A negative coefficient counts as 0. The limit is
     * NaN where the formula is.
     * @param speed the slip velocity. */
    Limit
    limit(const double pressure, const double speed = 0) const;

    /** The trial traction @f$\mathbf q@f$ for the vector from the stick point.
     * Unit: force/area. */
    dealii::Tensor<1, 3>
    trial(const dealii::Tensor<1, 3> &elastic_slip) const
    {
      return -epsilon_t * elastic_slip;
    }

    /** The part @f$\mathbf s@f$ of the slip that belongs to a traction. Unit:
     * length. */
    dealii::Tensor<1, 3>
    elastic_slip(const dealii::Tensor<1, 3> &traction) const
    {
      return -1 / epsilon_t * traction;
    }

    /** The parameter @f$\varepsilon_t@f$: minus the derivative of the trial
     * traction by @f$\mathbf s@f$. Unit: pressure/length. */
    double
    tangential_stiffness() const
    {
      return epsilon_t;
    }

    /** The parameter @f$s_c@f$ of SlipVelocityLaw. Unit: length/time. */
    double
    critical_velocity() const
    {
      return s_c;
    }

    /** Whether a node slips in the next iteration, for the trial traction and
     * the pressure of the last solution. */
    bool
    should_slip(const dealii::Tensor<1, 3> &trial, const double pressure) const
    {
      return !(trial.norm() <= value(pressure, 0));
    }

    /** The traction of a node that slips, with its derivatives. */
    struct Slip
    {
      dealii::Tensor<1, 3> traction;
      dealii::Tensor<2, 3> per_trial;
      dealii::Tensor<1, 3> per_pressure;
    };

    Slip
    slip(const dealii::Tensor<1, 3> &trial, const double pressure) const;

  private:
    /** The maximum traction without derivatives, see limit(). */
    double
    value(const double pressure, const double speed) const;

    FrictionCoefficient coefficient;
    double              epsilon_t, s_c;
    /** The part of the coefficient that counts. */
    double part = 1;
  };
} // namespace Biface

#endif
