// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_solver_load_stepping_h
#define biface_solver_load_stepping_h

#include <deal.II/base/conditional_ostream.h>
#include <deal.II/base/parameter_handler.h>

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <biface/model/shell_equations.h>
#include <biface/model/state.h>
#include <biface/solver/newton.h>

namespace Biface
{
  /** A stage of loading: from the loads of the stage before to its own, in
   * equal steps. */
  struct Stage
  {
    std::string  name   = "stage";
    StrainTheory theory = StrainTheory::nonlinear;
    /** At the end of the stage. */
    double pressure = 0;
    /** Whether there is a foundation, and how far it has come at the end. */
    bool         contact = false;
    double       travel  = 0;
    unsigned int n_steps = 1;
    /** Begin with the stresses reached so far, but undeformed and unloaded. */
    bool from_prestress = false;

    /** @param number of the stage, for its default name. */
    void
    add_parameters(dealii::ParameterHandler &prm, const unsigned int number);

    /** Throws InputError where a value is not usable. */
    void
    check(const std::string &section) const;
  };


  /** A converged step, as reported. */
  struct StepReport
  {
    /** Counted from 1 through all stages. */
    unsigned int step  = 0;
    const Stage *stage = nullptr;
    Loads        loads;
    /** Travel of the foundation since it touched the shell. */
    double         approach = 0;
    ContactSummary contact;
    unsigned int   iterations = 0;
    /** Relative residuals before each iteration, and after the last. */
    std::vector<double> residuals;
    double              seconds = 0;
  };


  /** How the stages ended. */
  struct LoadSteppingResult
  {
    bool success = true;
    /** Where a step failed for good: what happened. */
    std::string message;
  };


  /**
   * Takes the shell through its stages, a step at a time. A step that fails is
   * tried again from the restored state: in the mixed iteration first with
   * the substituted one, then with half the size; after a success the size
   * doubles again, up to what is left of the stage's step.
   */
  class LoadStepping
  {
  public:
    struct Parameters
    {
      unsigned int max_cuts = 6;

      void
      add_parameters(dealii::ParameterHandler &prm);
    };

    /** Called after every converged step. */
    using Observer = std::function<void(const StepReport &, const State &)>;

    LoadStepping(const Parameters           &parameters,
                 ShellEquations             &equations,
                 Newton                     &newton,
                 dealii::ConditionalOStream &out);

    /** Run the stages from a state, which is the last converged one at the
     * end. */
    LoadSteppingResult
    run(const std::vector<Stage> &stages,
        State                    &state,
        const Observer           &observer);

  private:
    /** Loads and foundation travel at some moment. */
    struct LoadPoint
    {
      double pressure = 0;
      double travel   = 0;
    };

    LoadSteppingResult
    run_stage(const Stage &stage, State &state, const Observer &observer);

    NewtonResult
    try_step(State &state, const Loads &loads);

    Loads
    loads_at(const LoadPoint &point, const Stage &stage) const;

    const Parameters            parameters;
    ShellEquations             &equations;
    Newton                     &newton;
    dealii::ConditionalOStream &out;

    LoadPoint    reached;
    unsigned int n_steps = 0;
    /** The plane as it touches the shell at the begin of the first stage with
     * contact. */
    std::optional<RigidPlane> touching_plane;
  };
} // namespace Biface

#endif
