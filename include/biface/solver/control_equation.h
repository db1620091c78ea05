// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_solver_control_equation_h
#define biface_solver_control_equation_h

#include <biface/base/linear_algebra.h>
#include <biface/model/contact_interaction.h>
#include <biface/model/shell_equations.h>
#include <biface/model/state.h>

namespace Biface
{
  /**
   * An equation that takes the place of a given load: the load parameter
   * @f$\mu@f$ becomes an unknown of Newton's method, and every iteration solves
   * for two increments, @f$d\mathbf V_R@f$ of the residual and
   * @f$d\mathbf V_q@f$ of a unit of @f$\mu@f$; the equation then chooses
   * @f$d\mu@f$ in @f$d\mathbf V = d\mathbf V_R + d\mu\,d\mathbf V_q@f$
   * @cite Crisfield1981.
   */
  class ControlEquation
  {
  public:
    virtual ~ControlEquation() = default;

    /** Where Newton's method is. */
    struct Iteration
    {
      /** As last assembled, at this state and these loads. */
      const ShellEquations     &equations;
      const ContactInteraction &contact;
      const State              &state;
      const Loads              &loads;
      /** Change of the displacements since the start of the step. */
      const LA::Vector &total;
    };

    /** The derivative of the forces on the shell with respect to @f$\mu@f$. */
    virtual LA::Vector
    load_direction(const Iteration &iteration) const = 0;

    /** @f$d\mu@f$ of this iteration; not a finite number where the equation
     * does not depend on the loads. */
    virtual double
    parameter_change(const Iteration  &iteration,
                     const LA::Vector &dV_R,
                     const LA::Vector &dV_q) const = 0;
  };


  /** The load parameter is the part of their way that all loads but the
   * foundation have gone. */
  class LoadFractionEquation : public ControlEquation
  {
  public:
    /** @param rate how the loads change with the load parameter. */
    explicit LoadFractionEquation(const LoadRates &rate) : rate(rate)
    {}

    LA::Vector
    load_direction(const Iteration &iteration) const override
    {
      return iteration.equations.load_direction(
        iteration.state, iteration.loads, rate);
    }

  private:
    const LoadRates rate;
  };
} // namespace Biface

#endif
