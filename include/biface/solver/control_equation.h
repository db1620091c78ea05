// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_solver_control_equation_h
#define biface_solver_control_equation_h

#include <optional>
#include <string>
#include <vector>

#include <biface/base/linear_algebra.h>
#include <biface/model/state/load_rates.h>

namespace Biface
{
  class ContactInteraction;
  class EquationSystem;
  struct Loads;
  struct State;


  /** A shell with its contact in a state under loads, kept by reference. */
  struct LoadedShell
  {
    const EquationSystem     &equations;
    const ContactInteraction &contact;
    const State              &state;
    const Loads              &loads;
  };


  /** The load parameters @f$\mu_i@f$, on which the loads of a step depend. */
  using LoadParameters = std::vector<double>;

  /** Add a multiple of changes to the same number of load parameters. */
  inline void
  add(LoadParameters       &parameters,
      const double          factor,
      const LoadParameters &changes)
  {
    AssertDimension(parameters.size(), changes.size());
    for (unsigned int i = 0; i < parameters.size(); ++i)
      parameters[i] += factor * changes[i];
  }


  /**
   * Equations that replace prescribed loads: the load parameters @f$\mu_i@f$
   * become unknowns of Newton's method, as many as there are equations. Every
   * iteration solves for the increments @f$d\mathbf V_R@f$ for the residual and
   * @f$d\mathbf V_i@f$ for a unit change of each @f$\mu_i@f$; the equations
   * then determine @f$d\mu_i@f$ in @f$d\mathbf V = d\mathbf V_R +
   * \sum_i d\mu_i\,d\mathbf V_i@f$ @cite Crisfield1981.
   */
  class ControlEquations
  {
  public:
    /** @param rates the derivatives of the loads by each @f$\mu_i@f$. */
    explicit ControlEquations(const std::vector<LoadRates> &rates)
      : rates(rates)
    {}

    virtual ~ControlEquations() = default;

    /** The current iterate of Newton's method. */
    struct Iteration : LoadedShell
    {
      /** The change of the displacements since the start of the step. */
      const LA::Vector &total;
      /** The number of negative pivots of the tangent, if the linear solver
       * counts them. */
      std::optional<unsigned int> n_negative_pivots;
    };

    /** The changes @f$d\mu_i@f$ of all load parameters in this iteration; not
     * finite if the equations do not depend on the loads.
     * @param dV_q one for each parameter. */
    virtual LoadParameters
    parameter_changes(const Iteration               &iteration,
                      const LA::Vector              &dV_R,
                      const std::vector<LA::Vector> &dV_q) const = 0;

    /** The changes @f$d\mu_i@f$ for equations that are slightly different at
     * @p iteration, as their linearization at @p about says, to which the
     * directions belong. */
    virtual LoadParameters
    parameter_changes_about(const Iteration & /*about*/,
                            const Iteration               &iteration,
                            const LA::Vector              &dV_R,
                            const std::vector<LA::Vector> &dV_q) const
    {
      return parameter_changes(iteration, dV_R, dV_q);
    }

    /** What may help if they do not depend on the loads, as part of a sentence
     * that names entries of the parameter file; empty if nothing is known. */
    virtual std::string
    remedies() const
    {
      return {};
    }

    /** Whether an iteration reads the number of negative pivots. */
    virtual bool
    reads_pivots(const Iteration & /*iteration*/) const
    {
      return false;
    }

    /** The largest violation of an equation, relative to the prescribed
     * value. */
    virtual double
    violation(const Iteration &iteration) const = 0;

    /** The change of the loads for given changes of all @f$\mu_i@f$. */
    LoadRates
    change_of_loads(const LoadParameters &changes) const
    {
      AssertDimension(changes.size(), rates.size());
      LoadRates result;
      for (unsigned int i = 0; i < rates.size(); ++i)
        result.add(changes[i], rates[i]);
      return result;
    }

    const std::vector<LoadRates> rates;
  };


  /** A single equation for a single load parameter. */
  class ControlEquation : public ControlEquations
  {
  public:
    explicit ControlEquation(const LoadRates &rates) : ControlEquations({rates})
    {}

    /** The change @f$d\mu@f$ of the load parameter in this iteration, see
     * parameter_changes(). */
    virtual double
    parameter_change(const Iteration  &iteration,
                     const LA::Vector &dV_R,
                     const LA::Vector &dV_q) const = 0;

    LoadParameters
    parameter_changes(const Iteration               &iteration,
                      const LA::Vector              &dV_R,
                      const std::vector<LA::Vector> &dV_q) const override
    {
      return {parameter_change(iteration, dV_R, dV_q[0])};
    }
  };

} // namespace Biface

#endif
