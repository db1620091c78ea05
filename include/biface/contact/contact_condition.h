// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_contact_contact_condition_h
#define biface_contact_contact_condition_h

namespace Biface
{
  struct ContactConditionParameters;


  /**
   * The frictionless contact condition, regularized by a penalty stiffness, of
   * @cite GrigolyukKulikovPlotnikova2004, eq. (14.1), at one node of the outer
   * face, with the clearance c left in the deformed state and the multiplier
   * @f$\lambda@f$ (minus the pressure):
   * - in contact (active): @f$c - \lambda/\varepsilon = 0@f$,
   *   @f$\lambda\le 0@f$;
   * - not in contact (inactive): @f$\lambda = 0@f$, @f$c\ge 0@f$.
   *
   * For a given active set @f$\lambda=\varepsilon c@f$, with the linearized
   * clearance in the linear systems, from which the multiplier is eliminated.
   * The primal-dual active set method @cite HintermuellerItoKunisch2002
   * determines the active nodes, see should_be_active().
   */
  class ContactCondition
  {
  public:
    using Parameters = ContactConditionParameters;

    /** The condition on a wall of a given stiffness.
     * @param wall_stiffness the pressure per change of the thickness of the
     * wall, of which an @f$\varepsilon@f$ that is not given is a multiple, so
     * that no number with a unit is built in. Unit: pressure/length. */
    ContactCondition(const Parameters &parameters, const double wall_stiffness);

    /** @param penalty_stiffness the parameter @f$\varepsilon@f$. Unit:
     * pressure/length. */
    explicit ContactCondition(const double penalty_stiffness)
      : epsilon(penalty_stiffness)
    {}

    /** The multiplier of an active node. */
    double
    multiplier(const double clearance) const
    {
      return epsilon * clearance;
    }

    /** The parameter @f$\varepsilon@f$: the derivative of the multiplier of an
     * active node by its clearance. Unit: pressure/length. */
    double
    penalty_stiffness() const
    {
      return epsilon;
    }

    /**
     * Whether a node should be active in the next iteration: if
     * @f$\lambda + \kappa\,(c - \lambda/\varepsilon) < 0@f$, as in deal.II's
     * step-41 @cite dealIIStep41 with the clearance of the regularized
     * condition, for arbitrarily small @f$\kappa>0@f$. An active node becomes
     * inactive if it is in tension, an inactive node becomes active if it has
     * penetrated.
     *
     * @param multiplier that of the last solution, 0 if the node was inactive.
     * @param clearance that of the same solution, not linearized.
     */
    bool
    should_be_active(const double multiplier, const double clearance) const
    {
      // any kappa > 0 gives the same result if the multiplier is that of the
      // clearance. On a curved ground, the error of a linearized clearance
      // times the penalty stiffness may be many times the pressure
      return multiplier < 0 || (multiplier == 0 && clearance < 0);
    }

  private:
    double epsilon;
  };
} // namespace Biface

#endif
