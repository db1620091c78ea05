// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_program_sensitivity_analysis_h
#define biface_program_sensitivity_analysis_h

#include <deal.II/base/conditional_ostream.h>
#include <deal.II/base/timer.h>

#include <array>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include <biface/output/scalar_results.h>
#include <biface/program/parameters.h>
#include <biface/program/shell_model.h>
#include <biface/solver/linear/linear_solver.h>
#include <biface/stepping/restore_point.h>
#include <biface/stepping/stage_analysis.h>

namespace Biface
{
  /**
   * The derivatives of results by numbers of the parameter file.
   *
   * Two neighbors of the run belong to each entry @f$p@f$: models built from
   * the parameter file with @f$p\pm h@f$, with everything that later steps read
   * of earlier ones: the displacements, the history of friction, the place
   * where the foundation touches, the prestress, the content of the gas. They
   * follow the steps of the run, but linearly. With the active set and the
   * slipping nodes of the run, in each step that is read later
   * @f[
   *   \mathbf K\frac{d\mathbf V}{dp}=
   *   \frac{\mathbf R_+(\mathbf V)-\mathbf R_-(\mathbf V)}{2h},\qquad
   *   \mathbf V_\pm=\mathbf V\pm h\frac{d\mathbf V}{dp},
   * @f]
   * with the tangent and the factors of the run; the residual
   * @f$\mathbf R_\pm@f$ contains the neighbor's history. A load parameter that
   * an equation determines is one more unknown. The derivative of a result
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

    /** Where the neighbors are, with resultants of zero. */
    NeighborPoints
    get_restore_points() const;

    /** Continue from there. */
    void
    restore(const NeighborPoints &points);

    void
    start_stage(const StageRun                    &run,
                const std::optional<unsigned int> &before) override;

    /** If a linear system cannot be solved, the derivatives in this stage and
     * in those that start from its end are left out, with a warning. */
    void
    follow(const Step &step) override;

    void
    end_stage(const StageRun &run, StepReport &report) override;

    /** Whether end_stage() reads the left eigenvectors of the modes of
     * vibration or buckling at the end of a stage. */
    bool
    reads_left_eigenvectors(const unsigned int stage) const;

  private:
    struct Neighbor;
    struct Linearization;

    /** The derivative of the displacements and of the load parameters by an
     * entry in a step, as far as it is known. */
    struct Derivative
    {
      /** The displacements of the run, but at the supports those of the two
       * perturbed runs. */
      std::array<LA::Vector, 2> fixed;
      LA::Vector                displacements;
      /** The displacements for which the forces were evaluated last. The
       * round-off in the positions is balanced by the displacements since. */
      LA::Vector     balanced;
      LoadParameters mu;
      /** The load parameters for which the forces were evaluated last. */
      LoadParameters balanced_mu;

      /** The displacements of a neighbor for which they were. */
      LA::Vector
      balanced_at(const unsigned int side, const double half_step) const;

      /** Its displacements since. */
      LA::Vector
      since_balanced(const double half_step) const;
    };

    using Change = SensitivityParameters::Change;

    /** The change of an entry in one of its neighbors. */
    double
    half_step(const unsigned int entry, const unsigned int side) const;

    /** Whether a step must be followed: if later steps read its state, or if
     * derivatives are wanted, which those of buckling factors read from the
     * last two. */
    bool
    is_read(const Step &step) const;

    /** Prepare a neighbor to follow a step, with the active set and the
     * slipping nodes of the run.
     * @return the displacements of the run, but at the supports those of the
     * neighbor. */
    LA::Vector
    propose(const Step &step, Neighbor &neighbor) const;

    /** Prepare both neighbors of an entry, with derivatives that vanish. */
    Derivative
    start(const Step &step, const unsigned int entry) const;

    /** Move both neighbors of an entry to where its derivative leads them. */
    void
    move(const Step        &step,
         const unsigned int entry,
         const Derivative  &derivative) const;

    /** The rate of the forces out of balance between the neighbors of an entry
     * where they are. Sets their multipliers to those of the run.
     * @param here those of the run.
     * @param roundoff of these. */
    LA::Vector
    force_rate(const Step        &step,
               const unsigned int entry,
               const LA::Vector  &here,
               const double       roundoff);

    /** Correct the derivative of load parameters by the equations that
     * determine them.
     * @param per_parameter the displacements per unit of each.
     * @return whether they do. */
    bool
    correct_loads(const Step                    &step,
                  const unsigned int             entry,
                  const std::vector<LA::Vector> &per_parameter,
                  Derivative                    &derivative) const;

    /** Move all neighbors to the end of a step, until a system is not solved,
     * see Linearization::failure. */
    void
    carry_along(const Step &step, Linearization &tangent);

    /** Leave the neighbors where they were before a step. */
    void
    lose(const Step &step, const Failure &failure);

    /** The modes of the run with the frequencies of a neighbor. */
    std::shared_ptr<const VibrationModes>
    change_modes(const VibrationModes &modes,
                 Neighbor             &neighbor,
                 const Loads          &loads);

    /** The buckling shapes of the run with the critical loads of a neighbor. */
    std::shared_ptr<const Buckling>
    change_buckling(const Buckling &buckling,
                    Neighbor       &neighbor,
                    const Loads    &loads);

    /** Warn once if something is not a smooth function of an entry: if the
     * value here deviates from the mean of those below and above by more than a
     * part of their difference.
     * @param roundoff a deviation that does not count. */
    void
    check_step(const Change      &change,
               const double       below,
               const double       here,
               const double       above,
               const double       roundoff,
               const std::string &what);

    void
    warn(const Change &change, const std::string &what);

    const Parameters            parameters;
    ShellModel                 &model;
    LinearSolver               &linear_solver;
    dealii::ConditionalOStream &out;
    dealii::TimerOutput        &timer;
    const ScalarResults         results;

    /** Two of each entry, below and above. */
    std::vector<std::unique_ptr<Neighbor>> neighbors;
    /** See NeighborPoints. */
    std::set<unsigned int>   lost_stages;
    std::vector<std::string> warned;
  };
} // namespace Biface

#endif
