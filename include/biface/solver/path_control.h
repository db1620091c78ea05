// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_solver_path_control_h
#define biface_solver_path_control_h

#include <biface/base/linear_algebra.h>
#include <biface/model/shell_equations.h>

namespace Biface
{
  /**
   * A condition that takes the place of a given load: the load becomes an
   * unknown @f$\mu@f$ of Newton's method, and every iteration solves for two
   * increments, @f$d\mathbf V_R@f$ of the residual and @f$d\mathbf V_q@f$ of a
   * unit of load; the condition then chooses the change of the load
   * @f$d\mu@f$ in @f$d\mathbf V = d\mathbf V_R + d\mu\,d\mathbf V_q@f$.
   */
  class PathControl
  {
  public:
    virtual ~PathControl() = default;

    /** Where Newton's method is. */
    struct Iteration
    {
      /** As last assembled, at this state and these loads. */
      const ShellEquations &equations;
      const State          &state;
      const Loads          &loads;
      /** What the displacements have changed by since the begin of the step.
       */
      const LA::Vector &total;
    };

    /** The derivative of the forces on the shell with respect to the load. */
    virtual LA::Vector
    load_direction(const Iteration &iteration) const = 0;

    /** The change of the load in this iteration. */
    virtual double
    load_change(const Iteration  &iteration,
                const LA::Vector &dV_R,
                const LA::Vector &dV_q) const = 0;
  };


  /** The unknown is the fraction of the way that all loads but the foundation
   * have gone. */
  class FractionControl : public PathControl
  {
  public:
    /** @param rate how the loads change with the fraction. */
    explicit FractionControl(const Loads &rate) : rate(rate)
    {}

    LA::Vector
    load_direction(const Iteration &iteration) const override
    {
      return iteration.equations.load_direction(rate);
    }

  private:
    const Loads rate;
  };


  /** A displacement, @f$\mathbf l\cdot\mathbf V@f$, is to change by a given
   * amount. */
  class DisplacementControl : public FractionControl
  {
  public:
    DisplacementControl(const Loads      &rate,
                        const LA::Vector &functional,
                        const double      change)
      : FractionControl(rate), functional(functional), change(change)
    {}

    double
    load_change(const Iteration  &iteration,
                const LA::Vector &dV_R,
                const LA::Vector &dV_q) const override
    {
      return (change - functional * iteration.total - functional * dV_R) /
             (functional * dV_q);
    }

  private:
    const LA::Vector &functional;
    const double      change;
  };


  /**
   * The displacements are to change by a given length in all, @f$|\Delta
   * \mathbf V| = s@f$ @cite Crisfield1981. In the first iteration the load
   * changes so that the displacements go on in the direction of the step
   * before: turning points of the load are passed without being asked.
   * Later, the condition is linearized.
   */
  class ArcLengthControl : public FractionControl
  {
  public:
    /**
     * @param length s.
     * @param previous what the displacements changed by in the step before.
     */
    ArcLengthControl(const Loads      &rate,
                     const double      length,
                     const LA::Vector &previous)
      : FractionControl(rate), length(length), previous(previous)
    {}

    double
    load_change(const Iteration  &iteration,
                const LA::Vector &dV_R,
                const LA::Vector &dV_q) const override
    {
      const LA::Vector &total = iteration.total;
      const double      size  = total.norm_sqr();
      if (size == 0)
        return (previous * dV_q < 0 ? -length : length) / dV_q.l2_norm();
      return ((length * length - size) / 2 - total * dV_R) / (total * dV_q);
    }

  private:
    const double      length;
    const LA::Vector &previous;
  };


  /** The force on the foundation is to have a given value; the unknown is how
   * far the foundation has moved. */
  class ForceControl : public PathControl
  {
  public:
    /** @param force compressive. */
    explicit ForceControl(const double force) : force(force)
    {}

    LA::Vector
    load_direction(const Iteration &iteration) const override
    {
      return iteration.equations.travel_direction(iteration.state,
                                                  iteration.loads);
    }

    double
    load_change(const Iteration  &iteration,
                const LA::Vector &dV_R,
                const LA::Vector &dV_q) const override
    {
      const auto F =
        iteration.equations.contact_force(iteration.state, iteration.loads);
      return (force - F.value - F.gradient * dV_R) /
             (F.gradient * dV_q + F.per_travel);
    }

  private:
    const double force;
  };
} // namespace Biface

#endif
