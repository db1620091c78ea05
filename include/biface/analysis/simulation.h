// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_analysis_simulation_h
#define biface_analysis_simulation_h

#include <deal.II/base/conditional_ostream.h>
#include <deal.II/base/timer.h>

#include <iosfwd>
#include <memory>

#include <biface/model/mesh/shell_mesh.h>
#include <biface/model/state/state.h>
#include <biface/problem/parameters.h>
#include <biface/problem/shell_model.h>
#include <biface/restart/checkpoint.h>
#include <biface/solver/newton.h>
#include <biface/stepping/load_stepping.h>
#include <biface/stepping/nested_predictor.h>

namespace Biface
{
  class SensitivityAnalysis;
  class ShellEquations;


  /**
   * An analysis, from its parameters to its results. There is no global state:
   * a program can contain any number of simulations, each on its own
   * communicator.
   */
  class Simulation
  {
  public:
    /**
     * Set up the mesh and the equations.
     *
     * @param parameters valid parameters, see Parameters::check().
     * @param communicator the ranks that share the work.
     * @param stream the output of the first rank.
     *
     * Throws InputError if the parameters are inconsistent.
     */
    Simulation(const Parameters &parameters,
               const MPI_Comm    communicator,
               std::ostream     &stream);

    ~Simulation();

    /** Run all remaining stages and pass each converged step to @p observer.
     * @param stop see Newton.
     * @param predictor states of another analysis with the same stages and
     * mesh, from which steps start in place of those of coarser meshes; null
     * for none. */
    LoadSteppingResult
    run(const LoadStepping::Observer &observer,
        const Newton::Stop           &stop      = {},
        const NestedPredictor        *predictor = nullptr);

    const ShellEquations &
    get_equations() const
    {
      return equations;
    }

    const ContactInteraction &
    get_contact() const
    {
      return contact;
    }

    /** The space that the gas fills; null if it cannot be sealed in. */
    const Cavity *
    get_cavity() const
    {
      return model.cavity.get();
    }

    const Progress &
    get_progress() const
    {
      return progress;
    }

    /** The last converged step and the ends of completed stages from which
     * later ones start. */
    RestorePoints
    get_restore_points() const;

    /** The restore points of the runs with changed entries, see
     * SensitivityAnalysis. */
    PerturbedPoints
    get_perturbed_points() const;

    /** Continue another run of the same shell, see check_continuation(). Throws
     * InputError if a stage starts from an end that this run has not kept, or
     * if derivatives would be taken by other differences. */
    void
    restore(const Checkpoint &checkpoint);

    /** The times of the parts of the run. */
    dealii::TimerOutput &
    get_timer()
    {
      return timer;
    }

    /** Seconds spent in factorizations and solutions on coarser meshes. */
    double
    get_coarse_solver_seconds() const
    {
      return coarse_solver_seconds;
    }

    dealii::ConditionalOStream &
    get_stream()
    {
      return out;
    }

  private:
    /** The analysis of a coarser or other mesh than that of the parameters.
     * @param mesh in place of that of the parameters. */
    Simulation(const Parameters                &parameters,
               const MPI_Comm                   communicator,
               std::ostream                    &stream,
               std::shared_ptr<const ShellMesh> mesh);

    /** The grid of every second line of a grid and of the lines of points and
     * ends of plies. */
    ChartGrid
    coarser_grid(const ChartGrid &grid) const;

    /** Create what accompanies the stages. */
    StageAnalyses
    make_analyses(BucklingAnalysis &buckling_analysis);

    /** Run all stages on the coarser mesh, and record the states of its steps.
     */
    std::unique_ptr<const NestedPredictor>
    run_coarser(const Newton::Stop &stop);

    const Parameters           parameters;
    std::ostream              &stream;
    dealii::ConditionalOStream out;
    dealii::TimerOutput        timer;
    ShellModel                 model;
    /** The parts of the model. */
    const std::shared_ptr<const ShellMesh> &mesh;
    const ContactInteraction               &contact;
    ShellEquations                         &equations;

    const std::unique_ptr<LinearSolver> linear_solver;
    /** The sensitivity analysis; null if no derivatives are asked for. */
    std::shared_ptr<SensitivityAnalysis> sensitivities;

    State     state;
    double    coarse_solver_seconds = 0;
    Progress  progress;
    StageEnds ends;
  };
} // namespace Biface

#endif
