// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_solver_control_equation_h
#define biface_solver_control_equation_h

#include <optional>

#include <biface/base/linear_algebra.h>
#include <biface/model/contact_interaction.h>
#include <biface/model/shell_equations.h>
#include <biface/model/state.h>

namespace Biface
{
  /**
   * An equation that replaces prescribed loads: the load parameter @f$\mu@f$
   * becomes an unknown of Newton's method, and every iteration solves for two
   * increments, @f$d\mathbf V_R@f$ for the residual and @f$d\mathbf V_q@f$ for
   * a unit change of @f$\mu@f$; the equation then determines @f$d\mu@f$ in
   * @f$d\mathbf V = d\mathbf V_R + d\mu\,d\mathbf V_q@f$ @cite Crisfield1981.
   */
  class ControlEquation
  {
  public:
    /** @param rates the derivatives of the loads by @f$\mu@f$. */
    explicit ControlEquation(const LoadRates &rates) : rates(rates)
    {}

    virtual ~ControlEquation() = default;

    /** The current iterate of Newton's method. */
    struct Iteration
    {
      /** As last assembled, for this state and these loads. */
      const ShellEquations     &equations;
      const ContactInteraction &contact;
      const State              &state;
      const Loads              &loads;
      /** Change of the displacements since the start of the step. */
      const LA::Vector &total;
      /** Of the tangent, if the linear solver counts them. */
      std::optional<unsigned int> n_negative_pivots;
    };

    /** @f$d\mu@f$ of this iteration; not finite if the equation does not depend
     * on the loads. */
    virtual double
    parameter_change(const Iteration  &iteration,
                     const LA::Vector &dV_R,
                     const LA::Vector &dV_q) const = 0;

    /** The violation of the equation, relative to the prescribed value. */
    virtual double
    violation(const Iteration &iteration) const = 0;

    const LoadRates rates;
  };

} // namespace Biface

#endif
