// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_solver_path_control_h
#define biface_solver_path_control_h

#include <biface/base/linear_algebra.h>

namespace Biface
{
  /**
   * A condition that takes the place of a given load: the load becomes an
   * unknown of Newton's method, and every iteration solves for two increments,
   * @f$d\mathbf V_R@f$ of the residual and @f$d\mathbf V_q@f$ of a unit of
   * load; the condition then chooses the change of the load
   * @f$d\mu@f$ in @f$d\mathbf V = d\mathbf V_R + d\mu\,d\mathbf V_q@f$.
   */
  class PathControl
  {
  public:
    virtual ~PathControl() = default;

    /**
     * The change of the load in this iteration.
     *
     * @param total what the displacements have changed by since the begin of
     * the step, before this iteration.
     */
    virtual double
    load_change(const LA::Vector &total,
                const LA::Vector &dV_R,
                const LA::Vector &dV_q) const = 0;
  };


  /** A displacement, @f$\mathbf l\cdot\mathbf V@f$, is to change by a given
   * amount. */
  class DisplacementControl : public PathControl
  {
  public:
    DisplacementControl(const LA::Vector &functional, const double change)
      : functional(functional), change(change)
    {}

    double
    load_change(const LA::Vector &total,
                const LA::Vector &dV_R,
                const LA::Vector &dV_q) const override
    {
      return (change - functional * total - functional * dV_R) /
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
  class ArcLengthControl : public PathControl
  {
  public:
    /**
     * @param length s.
     * @param previous what the displacements changed by in the step before.
     */
    ArcLengthControl(const double length, const LA::Vector &previous)
      : length(length), previous(previous)
    {}

    double
    load_change(const LA::Vector &total,
                const LA::Vector &dV_R,
                const LA::Vector &dV_q) const override
    {
      const double size = total.norm_sqr();
      if (size == 0)
        return (previous * dV_q < 0 ? -length : length) / dV_q.l2_norm();
      return ((length * length - size) / 2 - total * dV_R) / (total * dV_q);
    }

  private:
    const double      length;
    const LA::Vector &previous;
  };
} // namespace Biface

#endif
