// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_stepping_critical_point_h
#define biface_stepping_critical_point_h

#include <cmath>
#include <string>

#include <biface/base/linear_algebra.h>
#include <biface/solver/buckling_analysis.h>
#include <biface/solver/control_equation.h>
#include <biface/stepping/buckling.h>

namespace Biface
{
  /** A point of the path at which the number of negative pivots of the tangent
   * changes. */
  struct CriticalPoint
  {
    unsigned int n_negative_before = 0, n_negative_after = 0;
    /** Whether the step ends at the point, which bisection has found. */
    bool located = false;
    /** The loads at the end of the step. */
    CriticalLoads loads;
    /** The critical shape at the end of the step. */
    BucklingMode mode;

    /** Whether the loads work on the critical shape: the path turns back in the
     * loads. Otherwise it crosses another one. */
    bool
    is_limit_point() const
    {
      // round-off and small imperfections
      constexpr double no_work = 1e-3;
      return mode.load_work > no_work;
    }

    /** "limit point" or "bifurcation". */
    std::string
    kind() const
    {
      return is_limit_point() ? "limit point" : "bifurcation";
    }
  };


  /** The equation that the part of a shape in the displacements remains as it
   * is at the start of the iteration, which therefore stays on a branch. */
  class ShapeEquation : public ControlEquation
  {
  public:
    /** @param shape with locally owned entries.
     * @param amplitude the part of the shape, to which violations refer. */
    ShapeEquation(const LoadRates  &rates,
                  const LA::Vector &shape,
                  const double      amplitude)
      : ControlEquation(rates), shape(shape), amplitude(amplitude)
    {}

    double
    parameter_change(const Iteration  &iteration,
                     const LA::Vector &dV_R,
                     const LA::Vector &dV_q) const override
    {
      return -(shape * iteration.total + shape * dV_R) / (shape * dV_q);
    }

    double
    violation(const Iteration &iteration) const override
    {
      return std::abs(shape * iteration.total / (amplitude * shape.norm_sqr()));
    }

  private:
    const LA::Vector shape;
    const double     amplitude;
  };
} // namespace Biface

#endif
