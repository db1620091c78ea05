// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/mpi.h>

#include <csignal>
#include <memory>
#include <optional>

#include <biface/analysis/analysis.h>
#include <biface/analysis/continuation.h>
#include <biface/analysis/messages.h>
#include <biface/analysis/simulation.h>
#include <biface/base/errors.h>
#include <biface/base/version.h>
#include <biface/output/results_check.h>
#include <biface/output/results_writer.h>
#include <biface/output/rig_table.h>
#include <biface/problem/expected_cost.h>
#include <biface/restart/checkpoint_writer.h>

namespace Biface
{
  using namespace dealii;

  namespace
  {
    /** The checkpoint to continue from, if requested and consistent. */
    std::unique_ptr<const Checkpoint>
    find_checkpoint(const Parameters &parameters,
                    const RunRecord  &record,
                    const bool        restart,
                    const MPI_Comm    communicator)
    {
      if (!restart)
        return nullptr;
      auto checkpoint = std::make_unique<const Checkpoint>(
        parameters.output.directory, communicator);
      const RunRecord &before = checkpoint->get_record();
      check_continuation(before.parameters,
                         record.parameters,
                         parameters.attributes,
                         before.files,
                         record.files,
                         before.run.last.progress);
      return checkpoint;
    }


    /** Print the reason why a run ended early. */
    AnalysisResult
    explain_end(const LoadSteppingResult &result,
                const unsigned int        n_steps,
                const int                 signal,
                RunLog                   &log,
                ConditionalOStream       &err)
    {
      const std::string reason =
        (result.stopped ? std::string("stopped by ") + signal_name(signal)
                        : result.message);
      const std::string message =
        "biface: " + reason + "; " + std::to_string(n_steps) +
        (n_steps == 1 ? " converged step is kept.\n"
                      : " converged steps are kept.\n") +
        (result.stopped ? "" : failure_paragraph(result));
      err << message << std::flush;
      log.note(message);
      if (result.stopped)
        return {signal == SIGINT ? interrupted : terminated, reason};
      return {no_convergence, reason};
    }


    /** Run the stages and write the results.
     * @param checkpoint from which the run continues; null for a new run. */
    AnalysisResult
    run_stages(const Parameters      &parameters,
               const AnalysisOptions &options,
               const Checkpoint      *checkpoint,
               RunRecord             &record,
               Simulation            &simulation,
               RunLog                &log,
               ConditionalOStream    &err)
    {
      const std::string    &directory    = parameters.output.directory;
      const ShellEquations &equations    = simulation.get_equations();
      const Progress       &progress     = simulation.get_progress();
      const MPI_Comm        communicator = equations.mesh.communicator;
      ConditionalOStream   &out          = simulation.get_stream();

      std::optional<const SignalWatch> own_signals;
      const SignalWatch               &signals =
        (options.signals ? *options.signals : own_signals.emplace());
      std::optional<ResultsWriter::Written> written;
      if (checkpoint != nullptr)
        {
          written           = checkpoint->get_record().written;
          record.rig_points = checkpoint->get_record().rig_points;
          record.summary    = checkpoint->get_record().summary;
        }
      ResultsDirectory results_directory(
        directory, communicator, parameters.units);
      for (const std::string &file : parameters.input_files())
        results_directory.keep(file);
      // of an earlier run, whose results are about to be removed
      if (checkpoint == nullptr)
        remove_checkpoints(directory, communicator);
      ResultsWriter results(parameters.output,
                            results_directory,
                            parameters.stages,
                            equations,
                            simulation.get_cavity(),
                            parameters.sensitivities.changes.size() *
                              parameters.sensitivities.outputs.size(),
                            written);

      RigTable rig_table(
        parameters.tire_test.axes,
        rig_targets(parameters.stages, parameters.first_rig_point),
        parameters.first_rig_point,
        results_directory);

      log.open(directory + "/run.log", checkpoint != nullptr);
      if (checkpoint != nullptr)
        {
          if (!checkpoint->get_warning().empty())
            out << checkpoint->get_warning() << std::endl;
          out << "The run continues after step " << progress.n_steps << '.'
              << std::endl;
          checkpoint->remove_unusable();
        }
      results.write_parameters(record.parameters, options.file_name);
      for (const std::string &sentence : results.warnings())
        out << sentence << std::endl;

      CheckpointWriter checkpoints(
        parameters.checkpoint,
        directory,
        equations.mesh,
        progress,
        [&simulation]() {
          return AllPoints{simulation.get_restore_points(),
                           simulation.get_perturbed_points()};
        },
        results,
        checkpoint != nullptr);
      // a run that is stopped in its first step can be continued, too
      checkpoints.write(record);
      ResultsCheck             check(equations, simulation.get_contact());
      StepCounter              counter(parameters, progress);
      const LoadSteppingResult result = simulation.run(
        [&](const StepReport &report, const State &state) {
          TimerOutput::Scope scope(simulation.get_timer(), "Output");
          out << counter.line(report, progress) << std::endl;
          for (const std::string &warning : check.add(report, state))
            out << "  " << warning << std::endl;
          // before the checkpoint, which counts on the files of its steps
          results.write_step(report, state);
          const unsigned int stage = report.instant.stage;
          if (rig_table.is_point(stage) && progress.at_end_of(stage))
            record.rig_points[stage] =
              rig_point(rig_table.target(stage), report);
          rig_table.write(record.rig_points, progress.failed_stages);
          record.summary.add(
            report, state, equations.mesh, results.get_failure_maxima());
          checkpoints.write_if_due(record);
          if (options.observer)
            options.observer(simulation, report, state);
        },
        [&]() { return signals.caught(communicator) != 0; },
        options.predictor);
      checkpoints.write(record);
      rig_table.write(record.rig_points, progress.failed_stages);

      out << std::endl;
      if (out.is_active())
        record.summary.print(equations.mesh, out.get_stream());
      out << check.summary();
      print_costs(simulation, out);
      out << (result.success ? "Results" : "Results so far");
      std::vector<std::string> files = results.list();
      if (!rig_table.description().empty())
        files.insert(files.begin(), rig_table.description());
      print_files(directory, files, out);
      const std::string failures = rig_table.warning(progress.failed_stages);
      if (!failures.empty())
        out << "Warning: " << failures << std::endl;
      if (result.success)
        {
          if (parameters.last_stage() + 1 < parameters.stages.size())
            out << "The run ends after stage " << parameters.last_stage() + 1
                << " of " << parameters.stages.size()
                << ", as '--stages' asks; '--restart' continues it."
                << std::endl;
          return {done, failures};
        }
      return explain_end(
        result, progress.n_steps, signals.caught(communicator), log, err);
    }
  } // namespace


  AnalysisResult
  analyze(const Parameters               &parameters,
          const ParameterHandler         &prm,
          const std::vector<std::string> &notes,
          const AnalysisOptions          &options,
          const MPI_Comm                  communicator,
          RunLog                         &log,
          ConditionalOStream             &err)
  {
    RunRecord record;
    record.version    = version();
    record.parameters = print_parameters(prm);
    record.files      = parameters.named_pairs();
    record.stages     = parameters.stages;
    for (const auto &change : parameters.sensitivities.changes)
      record.differences.push_back(change.step);
    // before the set-up, which takes long: a run that cannot be continued is
    // refused at once
    const auto checkpoint =
      find_checkpoint(parameters, record, options.restart, communicator);

    Simulation          simulation(parameters, communicator, log.stream());
    ConditionalOStream &out = simulation.get_stream();
    print_header(simulation, out);
    for (const std::string &note : notes)
      out << note << std::endl;
    for (const std::string &warning : parameters.warnings())
      out << warning << std::endl;
    // after the set-up, so that a check finds all that an analysis would refuse
    if (options.check_only)
      {
        const ExpectedCost expected(
          parameters, simulation.get_equations().mesh.grid, communicator);
        out << "Expected: " << expected.text() << ".\nParameters OK."
            << std::endl;
        return {};
      }
    if (checkpoint)
      {
        simulation.restore(*checkpoint);
        const Progress &progress = simulation.get_progress();
        if (options.first_stage > progress.stage &&
            !progress.at_end_of(options.first_stage - 1))
          throw InputError("the option '--stages' starts with stage " +
                           std::to_string(options.first_stage + 1) +
                           ", but the run to be continued has only reached "
                           "stage " +
                           std::to_string(progress.stage + 1) + ".");
        if (progress.at_end_of(parameters.last_stage()))
          {
            if (progress.at_end_of(parameters.stages.size() - 1))
              out << "Run already complete after " << progress.n_steps
                  << " steps." << std::endl;
            else
              out << "The run has reached stage " << progress.stage + 1
                  << " in " << progress.n_steps
                  << " steps: nothing is left of the stages that '--stages' "
                     "asks for."
                  << std::endl;
            return {};
          }
      }
    return run_stages(
      parameters, options, checkpoint.get(), record, simulation, log, err);
  }
} // namespace Biface
