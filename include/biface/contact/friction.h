// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_contact_friction_h
#define biface_contact_friction_h

#include <deal.II/base/tensor.h>

#include <memory>
#include <optional>
#include <string>

#include <biface/input/formula.h>

namespace Biface
{
  class EntryDeclarations;


  /** The way in which a body holds a node sideways. */
  enum class ContactStatus : char
  {
    /** The node was not in contact at the end of the last step and has no
     * history: friction begins at the end of the step in which it enters. */
    none,
    /** The node sticks to its point of the body. */
    stick,
    /** The node slips at the limit of friction. */
    slip,
    /** The node sticks, however large the traction. */
    glued
  };


  /** The law of friction of a shell that rolls. */
  enum class RollingFriction
  {
    /** Friction by the slip velocity, see SlipVelocityLaw. */
    slip_velocity,
    /** Friction by the deflection of bristles, see BristleLaw. */
    bristles
  };


  /**
   * Coulomb's law of friction, regularized like the contact condition of
   * @cite GrigolyukKulikovPlotnikova2004, eq. (14.1).
   *
   * Each node in contact has a stick point on the foundation. With the
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
    struct Parameters
    {
      std::string coefficient = "0";
      /** The parameter @f$\varepsilon_t@f$; if not set, it follows from the
       * stiffness of the wall. Unit: pressure/length. */
      std::optional<double> regularization;
      RollingFriction       rolling = RollingFriction::slip_velocity;
      /** The critical velocity, see FrictionLaw::critical_velocity; 0 if not
       * given. */
      double critical_velocity = 0;

      void
      add_parameters(EntryDeclarations &prm);

      /** Throws InputError if a value is invalid. */
      void
      check() const;

      /** The parameter @f$\varepsilon_t@f$ on a wall of the given stiffness,
       * see ContactCondition: a hundredth of the @f$\varepsilon@f$ that
       * follows from it, for far fewer iterations. */
      double
      regularization_on(const double wall_stiffness) const
      {
        return regularization.value_or(70 * wall_stiffness);
      }

      /** The law in a stage.
       * @param entry of the coefficient of the stage.
       * @param own the coefficient of the stage; empty for that of these
       * parameters.
       * @param wall_stiffness see regularization_on(). */
      FrictionLaw
      of_stage(const std::string &entry,
               const std::string &own,
               const double       wall_stiffness = 1) const;
    };

    /** The law with a coefficient.
     * @param entry the entry of the coefficient, for error messages.
     * @param coefficient a number or a formula of the contact pressure `p` and
     * of the slip velocity `s`, which is 0 unless the shell rolls.
     * @param regularization the parameter @f$\varepsilon_t@f$.
     *
     * Throws InputError if the coefficient is neither, or negative. */
    FrictionLaw(const std::string &entry,
                const std::string &coefficient,
                const double       regularization,
                const double       critical_velocity = 0);

    /** The law with another critical velocity. */
    FrictionLaw
    with_critical_velocity(const double velocity) const
    {
      return FrictionLaw(*this, velocity, part);
    }

    /** The law with a part of the coefficient. */
    FrictionLaw
    with_part_of_friction(const double further_part) const
    {
      return FrictionLaw(*this, critical_velocity, part * further_part);
    }

    /** Whether the coefficient is the number 0. */
    bool
    is_zero() const
    {
      return constant && *constant == 0;
    }

    /** Whether the coefficient depends on the slip velocity. */
    bool
    depends_on_speed() const;

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
      return -regularization * elastic_slip;
    }

    /** The part @f$\mathbf s@f$ of the slip that belongs to a traction. Unit:
     * length. */
    dealii::Tensor<1, 3>
    elastic_slip(const dealii::Tensor<1, 3> &traction) const
    {
      return -1 / regularization * traction;
    }

    /** Minus the derivative of the trial traction by @f$\mathbf s@f$, the
     * parameter @f$\varepsilon_t@f$. Unit: pressure/length. */
    double
    stiffness() const
    {
      return regularization;
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

    /** The parameter @f$s_c@f$ of SlipVelocityLaw. */
    const double critical_velocity;

  private:
    FrictionLaw(const FrictionLaw &other,
                const double       critical_velocity,
                const double       part)
      : critical_velocity(critical_velocity)
      , coefficient(other.coefficient)
      , constant(other.constant)
      , regularization(other.regularization)
      , part(part)
    {}

    /** The maximum traction without derivatives, see limit(). */
    double
    value(const double pressure, const double speed) const;

    std::shared_ptr<const Formula> coefficient;
    std::optional<double>          constant;
    const double                   regularization;
    /** The part of the coefficient that counts. */
    const double part = 1;
  };


  /** Check a coefficient of friction, see FrictionLaw. */
  void
  check_friction(const std::string &entry, const std::string &coefficient);
} // namespace Biface

#endif
