// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_analysis_analysis_h
#define biface_analysis_analysis_h

#include <deal.II/base/conditional_ostream.h>
#include <deal.II/base/parameter_handler.h>

#include <mpi.h>

#include <functional>
#include <string>
#include <vector>

#include <biface/analysis/exit_code.h>
#include <biface/analysis/run_log.h>
#include <biface/analysis/signal_watch.h>
#include <biface/problem/parameters.h>
#include <biface/stepping/nested_predictor.h>
#include <biface/stepping/step_report.h>

namespace Biface
{
  class Simulation;
  struct State;


  /** What an analysis is to do besides its parameters. */
  struct AnalysisOptions
  {
    /** The parameter file, which is named in the written parameters. */
    std::string file_name;
    /** Whether to continue the run in the directory of results. */
    bool restart = false;
    /** The position of the first stage that is asked for, which a restart must
     * have reached. */
    unsigned int first_stage = 0;
    /** Whether only to set up the analysis. */
    bool check_only = false;
    /** States from which steps start; null for none. */
    const NestedPredictor *predictor = nullptr;
    /** A function that is called after every converged step, if set. */
    std::function<void(const Simulation &, const StepReport &, const State &)>
      observer;
    /** The object that watches signals; null if the analysis has its own. */
    const SignalWatch *signals = nullptr;
  };


  /** How an analysis ended. */
  struct AnalysisResult
  {
    ExitCode code = done;
    /** The reason of an early end, or what failed all the same; empty
     * otherwise. */
    std::string reason;
  };


  /**
   * A complete analysis: set-up, stages, results, and checkpoints. Must be
   * called on all ranks.
   *
   * Throws InputError if the parameters are inconsistent, or a restart is
   * impossible, and OutputError if results cannot be written.
   *
   * @param parameters valid parameters, see read_parameters().
   * @param prm their entries and values.
   * @param notes sentences to print at the start.
   * @param log receives the progress, and a file in the directory of results.
   * @param err receives the reason of an early end.
   */
  AnalysisResult
  analyze(const Parameters               &parameters,
          const dealii::ParameterHandler &prm,
          const std::vector<std::string> &notes,
          const AnalysisOptions          &options,
          const MPI_Comm                  communicator,
          RunLog                         &log,
          dealii::ConditionalOStream     &err);
} // namespace Biface

#endif
