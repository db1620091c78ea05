// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_analysis_sensitivity_analysis_h
#define biface_analysis_sensitivity_analysis_h

#include <deal.II/base/conditional_ostream.h>
#include <deal.II/base/timer.h>

#include <array>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <biface/output/scalar_results.h>
#include <biface/problem/parameters.h>
#include <biface/problem/shell_model.h>
#include <biface/solver/linear/linear_solver.h>
#include <biface/stepping/restore_point.h>
#include <biface/stepping/stage_analysis.h>

namespace Biface
{
  /**
   * The derivatives of results by numbers of the parameter file.
   *
   * Two perturbed runs belong to each entry @f$p@f$: models built from
   * the parameter file with @f$p\pm h@f$, with everything that later steps read
   * of earlier ones: the displacements, the history of friction, the place
   * where the ground touches, the prestress, the content of the gas. They
   * follow the steps of the run, but linearly. With the active set and the
   * slipping nodes of the run, in each step that is read later
   * @f[
   *   \mathbf K\frac{d\mathbf V}{dp}=
   *   \frac{\mathbf R_+(\mathbf V)-\mathbf R_-(\mathbf V)}{2h},\qquad
   *   \mathbf V_\pm=\mathbf V\pm h\frac{d\mathbf V}{dp},
   * @f]
   * with the tangent and the factors of the run; the residual
   * @f$\mathbf R_\pm@f$ contains the perturbed run's history. A load parameter
   * that an equation determines is one more unknown. The derivative of a result
   * @f$y@f$ is @f$(y_+(\mathbf V_+)-y_-(\mathbf V_-))/2h@f$.
   */
  class SensitivityAnalysis : public StageAnalysis
  {
  public:
    /** The objects are kept by reference. Throws InputError if a result does
     * not exist, or if an entry changes the mesh itself. */
    SensitivityAnalysis(const Parameters           &parameters,
                        ShellModel                 &model,
                        LinearSolver               &linear_solver,
                        dealii::ConditionalOStream &out,
                        dealii::TimerOutput        &timer);

    ~SensitivityAnalysis() override;

    /** The states and progress of the perturbed runs, with resultants of
     * zero. */
    PerturbedPoints
    get_restore_points() const;

    /** Continue perturbed runs from their restore points. */
    void
    restore(const PerturbedPoints &points);

    void
    start_stage(const StageRun                    &run,
                const std::optional<unsigned int> &before) override;

    /** Take the perturbed runs along in a converged step. If a linear system
     * cannot be solved, the derivatives in this stage and in those that start
     * from its end are left out, with a warning. */
    void
    follow(const Step &step) override;

    void
    end_stage(const StageRun &run, StepReport &report) override;

    /** Whether end_stage() reads the left eigenvectors of the modes of
     * vibration or buckling at the end of a stage. */
    bool
    reads_left_eigenvectors(const unsigned int stage) const;

  private:
    struct PerturbedRun;
    struct Linearization;

    using Change = SensitivityParameters::Change;

    /** Whether a step must be followed: if later steps read its state, or if
     * derivatives are wanted, which those of buckling factors read from the
     * last two. */
    bool
    is_read(const Step &step) const;

    /** Whether the perturbed runs of an entry follow a stage: unless they have
     * not settled. */
    bool
    follows(const unsigned int entry, const unsigned int stage) const
    {
      return unsettled.count({stage, entry}) == 0;
    }

    /** The perturbed runs that follow a stage. */
    std::vector<PerturbedRun *>
    followers(const unsigned int stage) const;

    /** Prepare a perturbed run to follow a step, with the active set and the
     * slipping nodes of the run, and where the run is but at the supports. */
    void
    start(const Step &step, PerturbedRun &perturbed) const;

    /** Move a perturbed run to where its deviation from the run leads it. */
    void
    move(const Step &step, PerturbedRun &perturbed) const;

    /** The forces and loads that a converged step leaves out of balance, in the
     * perturbed runs as well as in the run. */
    struct Balance
    {
      LA::Vector forces;
      double     roundoff = 0;
      /** The changes of the load parameters that the equations that determine
       * them ask for. */
      LoadParameters missing_loads;
    };

    Balance
    balance_of_run(const Step &step, const Linearization &tangent) const;

    /** The forces out of balance of a perturbed run in its state, beyond those
     * of the run. Sets its multipliers to those of the run. */
    LA::Vector
    unbalance(const Step       &step,
              const LA::Vector &of_run,
              PerturbedRun     &perturbed) const;

    /** The changes of the load parameters that the equations that determine
     * them ask of a perturbed run.
     * @param per_parameter the displacements per unit of each. */
    LoadParameters
    missing_loads(const Step                    &step,
                  const std::vector<LA::Vector> &per_parameter,
                  const PerturbedRun            &perturbed) const;

    /** Correct the displacements and the load parameters of a perturbed run.
     * @param per_parameter the displacements per unit of each.
     * @param missing_in_run see Balance. */
    void
    correct(const Step                    &step,
            const LA::Vector              &correction,
            const std::vector<LA::Vector> &per_parameter,
            const LoadParameters          &missing_in_run,
            PerturbedRun                  &perturbed) const;

    /** A vector of each of the two perturbed runs of an entry. */
    using Sides = std::array<const LA::Vector *, 2>;

    /** Whether both perturbed runs of an entry are near the run, so that their
     * corrections do not diverge. */
    bool
    is_near(const unsigned int entry) const;

    /** Whether the perturbed runs of an entry deviate from the run in opposite
     * directions, so that their first corrections suffice for the difference
     * if forces are linear. If not, warn.
     * @param roundoff of the forces. */
    bool
    is_linear(const unsigned int entry,
              const Sides       &forces,
              const Sides       &corrections,
              const double       roundoff);

    /** Let the perturbed runs of an entry deviate from the run by opposite
     * amounts: what they have in common is of second order. */
    void
    make_opposite(const Step &step, const unsigned int entry);

    /** Whether the last correction of both perturbed runs of an entry was
     * small.
     * @param forces that it has balanced.
     * @param roundoff of these. */
    bool
    has_settled(const unsigned int entry,
                const Sides       &forces,
                const double       roundoff) const;

    /** Move all perturbed runs to the end of a step, until a system is not
     * solved, see Linearization::failure. Each settles in its own contact. */
    void
    carry_along(const Step &step, Linearization &tangent);

    /** Leave the perturbed runs where they were before a step. */
    void
    lose(const Step &step, const Failure &failure);

    /** Leave the perturbed runs of an entry that have not settled where they
     * were before a step. */
    void
    leave_unsettled(const Step &step, const unsigned int entry);

    /** The modes of the run with the frequencies of a perturbed run, to first
     * order in what changes.
     * @param state, loads those of the run. */
    std::shared_ptr<const VibrationModes>
    change_modes(const VibrationModes &modes,
                 const State          &state,
                 const Loads          &loads,
                 PerturbedRun         &perturbed,
                 const Loads          &changed_loads);

    /** The buckling shapes of the run with the critical loads of a perturbed
     * run. */
    std::shared_ptr<const Buckling>
    change_buckling(const Buckling &buckling,
                    PerturbedRun   &perturbed,
                    const Loads    &loads);

    /** Warn once that something is not a smooth function of an entry. */
    void
    warn(const Change &change, const std::string &what);

    const Parameters            parameters;
    ShellModel                 &model;
    LinearSolver               &linear_solver;
    dealii::ConditionalOStream &out;
    dealii::TimerOutput        &timer;
    const ScalarResults         results;

    /** The perturbed runs, two of each entry: below and above its value. */
    std::vector<std::unique_ptr<PerturbedRun>> perturbed_runs;
    /** The stages that perturbed runs did not follow, see PerturbedPoints. */
    std::set<unsigned int>                          lost_stages;
    std::set<std::pair<unsigned int, unsigned int>> unsettled;
    std::vector<std::string>                        warned;
  };
} // namespace Biface

#endif
