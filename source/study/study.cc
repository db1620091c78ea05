// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/conditional_ostream.h>
#include <deal.II/base/mpi.h>
#include <deal.II/base/timer.h>
#include <deal.II/base/utilities.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <limits>
#include <memory>
#include <optional>
#include <sstream>

#include <biface/analysis/analysis.h>
#include <biface/analysis/signal_watch.h>
#include <biface/analysis/simulation.h>
#include <biface/base/errors.h>
#include <biface/input/parameter_text.h>
#include <biface/input/read_file.h>
#include <biface/output/csv.h>
#include <biface/output/result_file.h>
#include <biface/output/scalar_results.h>
#include <biface/problem/parameters.h>
#include <biface/stepping/stage_sequence.h>
#include <biface/study/sample_queue.h>
#include <biface/study/sample_states.h>
#include <biface/study/study.h>
#include <biface/study/study_parameters.h>
#include <biface/study/study_table.h>

namespace Biface
{
  using namespace dealii;

  namespace
  {
    /** Refuse a variable whose column in study.csv would have the name of
     * another one. */
    void
    check_column_of(const DesignVariable                       &variable,
                    const std::vector<StudyParameters::Output> &outputs)
    {
      const auto taken = [&](const std::string &column) {
        return column == variable.get_name();
      };
      const auto &own = StudyTable::own_columns;
      if (std::any_of(own.begin(), own.end(), taken) ||
          std::any_of(outputs.begin(), outputs.end(), [&](const auto &output) {
            return taken(output.name());
          }))
        throw InputError("the entry 'Study/Variables' names a variable " +
                         Biface::quoted(variable.get_name()) +
                         ", but study.csv has another column of this name; "
                         "choose a different one.");
    }


    constexpr const char *base_name  = "base.prm";
    constexpr const char *study_name = "study.prm";


    /** The base file with all that it reads: the contents of the files that it
     * names follow in comments. */
    std::string
    text_of_base(const ParameterHandler &prm, const Parameters &parameters)
    {
      std::string text = print_parameters(prm);
      for (const auto &[entry, pairs] : parameters.named_pairs())
        {
          text += "\n# " + entry + ":\n";
          for (const Point<2> &pair : pairs)
            text += "# " + exact_number(pair[0]) + ", " +
                    exact_number(pair[1]) + '\n';
        }
      return text;
    }


    /** The communicator of the group of a rank. */
    class Group
    {
    public:
      Group(const MPI_Comm all, const unsigned int size)
      {
        const unsigned int rank  = Utilities::MPI::this_mpi_process(all);
        const unsigned int ranks = Utilities::MPI::n_mpi_processes(all);
        number                   = (ranks + size - 1) / size;
        // consecutive ranks, which are mostly on the same machine
        const int ierr = MPI_Comm_split(all, rank / size, rank, &communicator);
        AssertThrowMPI(ierr);
      }

      ~Group()
      {
        MPI_Comm_free(&communicator);
      }

      Group(const Group &) = delete;
      Group &
      operator=(const Group &) = delete;

      MPI_Comm communicator = MPI_COMM_NULL;
      /** The number of groups. */
      unsigned int number = 1;
    };


    /** The values of the outputs in an analysis. */
    class OutputsOfAnalysis
    {
    public:
      /** Throws InputError if there is no such result. */
      OutputsOfAnalysis(const std::vector<StudyParameters::Output> &outputs,
                        const Parameters                           &parameters,
                        const Simulation                           &simulation)
        : outputs(outputs)
      {
        const Cavity *cavity = simulation.get_cavity();
        const auto    add    = [&](const Numbers              &numbers,
                             const ScalarResults::Known &known) {
          std::vector<std::string> names;
          for (const unsigned int o : numbers)
            names.push_back(outputs[o].result);
          return OfSteps{numbers,
                         ScalarResults("Study/Outputs",
                                       names,
                                       simulation.get_equations(),
                                       parameters.output.criteria,
                                       parameters.output.forces.moment_center,
                                       known,
                                       ScalarResults::Columns::all)};
        };
        ScalarResults::Known always;
        always.volume = (cavity != nullptr);
        for (unsigned int s = 0; s < parameters.stages.size(); ++s)
          {
            starts_elsewhere.push_back(
              s > 0 && stage_before(parameters.stages, s) != s - 1);
            Numbers at_end, at_steps;
            for (unsigned int o = 0; o < outputs.size(); ++o)
              if (outputs[o].of != Output::Of::end && outputs[o].stage.empty())
                at_steps.push_back(o);
              else if (last_stage(outputs[o], parameters.stages) == s)
                (outputs[o].of == Output::Of::end ? at_end : at_steps)
                  .push_back(o);
            ends.push_back(add(
              at_end,
              ScalarResults::Known::at_ends(cavity, {parameters.stages[s]})));
            steps.push_back(add(at_steps, always));
          }
      }

      /** Read the values of a step. On all ranks. */
      void
      read(const Simulation    &simulation,
           const StepReport    &report,
           const State         &state,
           std::vector<double> &values)
      {
        first_maxima.resize(outputs.size());
        const auto read = [&](const OfSteps &of, const auto &function) {
          if (of.numbers.empty())
            return;
          const std::vector<double> found = of.results.evaluate(
            simulation.get_equations(), simulation.get_cavity(), report, state);
          for (unsigned int i = 0; i < found.size(); ++i)
            function(of.numbers[i], found[i]);
        };
        const unsigned int stage = report.instant.stage;
        // a branch goes on from another step
        if (stage != last_stage_read && starts_elsewhere[stage])
          for (FirstMaximum &maximum : first_maxima)
            maximum.leave();
        last_stage_read = stage;
        // what is not a number does not count
        read(steps[stage], [&](const unsigned int o, const double found) {
          if (outputs[o].of == Output::Of::first_maximum)
            first_maxima[o].add(found, values[o]);
          else
            values[o] = (outputs[o].of == Output::Of::maximum
                           ? std::fmax(values[o], found)
                           : std::fmin(values[o], found));
        });
        if (report.instant.fraction >= 1)
          read(ends[stage], [&](const unsigned int o, const double found) {
            values[o] = found;
          });
      }

    private:
      using Output  = StudyParameters::Output;
      using Numbers = std::vector<unsigned int>;

      /** The first value of a sequence that is larger than the next one. */
      class FirstMaximum
      {
      public:
        /** @param maximum is set if the value before this one is it. */
        void
        add(const double value, double &maximum)
        {
          if (std::isnan(value))
            return;
          if (last && value < *last && !is_found)
            {
              maximum  = *last;
              is_found = true;
            }
          last = value;
        }

        /** The next value does not follow the last one. */
        void
        leave()
        {
          last.reset();
        }

      private:
        std::optional<double> last;
        bool                  is_found = false;
      };

      struct OfSteps
      {
        /** The positions of the outputs. */
        Numbers       numbers;
        ScalarResults results;
      };

      /** The position of the last stage with the name that an output asks
       * for. */
      static unsigned int
      last_stage(const Output &output, const std::vector<Stage> &stages)
      {
        unsigned int result = stages.size() - 1;
        // without a stage, the last one; names may occur several times
        while (!output.stage.empty() && stages[result].name != output.stage)
          {
            Assert(result > 0, ExcInternalError());
            --result;
          }
        return result;
      }

      const std::vector<Output> &outputs;
      /** By stage. */
      std::vector<OfSteps> ends, steps;
      /** By output. */
      std::vector<FirstMaximum> first_maxima;
      /** By stage, whether it starts from another one than that before. */
      std::vector<bool> starts_elsewhere;
      unsigned int      last_stage_read = 0;
    };


    /** A study after reading. */
    class Study
    {
    public:
      Study(const StudyOptions &options, const MPI_Comm communicator);

      /** Set up the analysis of the base file, and check the outputs. */
      void
      check(const Group &group) const;

      ExitCode
      run(const Group        &group,
          const bool          restart,
          RunLog             &log,
          ConditionalOStream &err);

      StudyParameters                  parameters;
      std::vector<std::vector<double>> samples;

    private:
      std::string
      path(const std::string &file) const
      {
        return parameters.directory + "/" + file;
      }

      /** The table of the directory before any sample runs. Check that of the
       * study to be continued. */
      StudyTable
      prepare_table(const bool restart) const;

      /** Run a sample and write its row.
       * @return whether it was stopped by a signal; then it has no row. */
      bool
      run_sample(const StudyTable  &table,
                 const unsigned int i,
                 const MPI_Comm     communicator,
                 const SignalWatch &signals);

      /** The analysis of a sample.
       * @param results receives the outputs and counts of the steps. */
      AnalysisResult
      analyze_sample(const unsigned int   i,
                     const std::string   &directory,
                     const MPI_Comm       communicator,
                     const SignalWatch   &signals,
                     StudyTable::Results &results);

      const MPI_Comm        communicator;
      const bool            is_root;
      const std::string     study_file;
      std::string           base_file;
      std::vector<Override> base_overrides;
      Parameters            base;
      ParameterHandler      base_prm;
      std::string           study_text;
      std::vector<double>   scales;
      SampleStates          neighbors;
    };


    Study::Study(const StudyOptions &options, const MPI_Comm communicator)
      : communicator(communicator)
      , is_root(Utilities::MPI::this_mpi_process(communicator) == 0)
      , study_file(options.file_name)
    {
      const std::string &name = study_file;
      const std::string  folder =
        std::filesystem::path(name).parent_path().string();
      const std::string text = join_lines(name, read_file(name, communicator));
      ParameterHandler  prm;
      parameters.add_parameters(prm);
      check_parameter_text(name, text);
      const std::vector<ParameterLine> lines = scan_parameter_text(text);
      if (std::none_of(
            lines.begin(), lines.end(), [](const ParameterLine &line) {
              return line.keyword == "subsection" && line.name == "Study";
            }))
        throw InputError(name +
                         ": the file has no section 'Study', which '--study' "
                         "runs; run it without '--study'.");
      parse_parameter_text(prm, name, text);
      // the others change the base file
      std::vector<Override> of_base;
      for (const Override &given : options.overrides)
        if (Utilities::trim(given.setting).rfind("Study/", 0) == 0)
          {
            const std::string changed = override_text(given);
            check_parameter_text(given.source, changed);
            parse_parameter_text(prm, given.source, changed);
          }
        else
          of_base.push_back(given);
      if (!options.output.empty())
        parameters.directory = options.output;

      try
        {
          if (parameters.base_file.empty())
            throw InputError(
              "Study/Base file", "", "a study needs a parameter file");
          samples = parameters.sampling.samples(folder, communicator);
          if (parameters.reference_sample > samples.size())
            throw InputError("Study/Reference sample",
                             std::to_string(parameters.reference_sample),
                             "it must be at most the number of samples, " +
                               std::to_string(samples.size()));
        }
      catch (const InputError &error)
        {
          throw InputError(name + ": " + error.what());
        }

      base_file = (std::filesystem::path(folder) / parameters.base_file)
                    .lexically_normal()
                    .string();
      // a sample is not continued, but run again
      base_overrides = {{"Checkpoint/Write=false", "--study"}};
      for (const Override &setting : parameters.settings)
        base_overrides.push_back(setting);
      for (const Override &setting : of_base)
        base_overrides.push_back(setting);
      read_parameters(base_file, base_overrides, communicator, base, base_prm);

      try
        {
          for (const auto &variable : parameters.sampling.variables)
            {
              variable.check(base_prm);
              check_column_of(variable, parameters.outputs);
            }
          // refuses two variables that set the same number
          settings(
            parameters.sampling.variables, samples[0], base_prm, "--study");
          for (const StudyParameters::Output &output : parameters.outputs)
            if (!output.stage.empty() && std::none_of(base.stages.begin(),
                                                      base.stages.end(),
                                                      [&](const Stage &stage) {
                                                        return stage.name ==
                                                               output.stage;
                                                      }))
              throw InputError("the entry 'Study/Outputs' names the stage " +
                               Biface::quoted(output.stage) + ", but " +
                               Biface::quoted(base_file) +
                               " has no stage of this "
                               "name.");
        }
      catch (const InputError &error)
        {
          throw InputError(name + ": " + error.what());
        }

      std::ostringstream printed;
      prm.print_parameters(printed,
                           ParameterHandler::PRM |
                             ParameterHandler::KeepDeclarationOrder);
      study_text = printed.str();

      for (unsigned int j = 0; j < samples[0].size(); ++j)
        {
          // distances between samples count in parts of the range of each
          // variable
          double low = samples[0][j], high = low;
          for (const std::vector<double> &sample : samples)
            {
              low  = std::min(low, sample[j]);
              high = std::max(high, sample[j]);
            }
          scales.push_back(high > low ? high - low : 1.);
        }
    }


    void
    Study::check(const Group &group) const
    {
      std::ostringstream                screen;
      std::unique_ptr<const Simulation> simulation;
      // errors name the file in which the user finds them
      try
        {
          simulation = std::make_unique<const Simulation>(
            base, group.communicator, screen);
        }
      catch (const InputError &error)
        {
          throw InputError(base_file + ": " + error.what());
        }
      try
        {
          const OutputsOfAnalysis outputs(
            parameters.outputs, base, *simulation);
        }
      catch (const InputError &error)
        {
          throw InputError(study_file + ": " + error.what());
        }
    }


    StudyTable
    Study::prepare_table(const bool restart) const
    {
      std::vector<std::string> columns;
      for (const DesignVariable &variable : parameters.sampling.variables)
        columns.push_back(variable.get_name());
      for (const StudyParameters::Output &output : parameters.outputs)
        columns.push_back(output.name());
      StudyTable table(
        parameters.directory, columns, samples, parameters.reference_sample);

      const std::string base_text = text_of_base(base_prm, base);
      std::string       reason;
      // rows of another study would be mixed with those of this one
      if (is_root && restart)
        {
          std::ifstream     file(path(base_name));
          const std::string before((std::istreambuf_iterator<char>(file)), {});
          const std::string name = Biface::quoted(parameters.directory);
          table.collect();
          if (before.empty())
            reason = "the directory " + name +
                     " contains no study that can be continued.";
          else if (before != base_text)
            reason = "the study in " + name +
                     " has another base file, other settings or other tables, "
                     "see 'base.prm' there, and cannot be continued.";
          else if (table.has_foreign_row())
            reason = "the study in " + name +
                     " has other samples or outputs and cannot be continued.";
        }
      else if (is_root)
        StudyTable::remove_rows(parameters.directory);
      reason = Utilities::MPI::broadcast(communicator, reason);
      if (!reason.empty())
        throw InputError(reason);

      write_text(path(base_name), base_text, false, communicator);
      write_text(path(study_name), study_text, false, communicator);
      write_text(
        path(StudyTable::file_name), table.text(), false, communicator);
      return table;
    }


    AnalysisResult
    Study::analyze_sample(const unsigned int   i,
                          const std::string   &directory,
                          const MPI_Comm       communicator,
                          const SignalWatch   &signals,
                          StudyTable::Results &results)
    {
      const bool is_first =
        (Utilities::MPI::this_mpi_process(communicator) == 0);
      std::ostringstream nowhere;
      ConditionalOStream err(nowhere, false);
      RunLog             log(nowhere, true, is_first);
      const auto fail = [&](const ExitCode code, const std::string &reason) {
        log.open(directory + "/run.log", false);
        log.stream() << reason << std::endl;
        return AnalysisResult{code, reason};
      };
      try
        {
          // for the log, also if the input is invalid
          ResultsDirectory(directory, communicator);
          const std::string source = "--study sample " + std::to_string(i + 1);
          std::vector<Override> overrides = base_overrides;
          for (const Override &setting : settings(
                 parameters.sampling.variables, samples[i], base_prm, source))
            overrides.push_back(setting);
          overrides.emplace_back(
            "Output/Directory=" + print_file_name(directory), source);
          Parameters                     changed;
          ParameterHandler               prm;
          const std::vector<std::string> notes =
            read_parameters(base_file, overrides, communicator, changed, prm);
          changed.output.directory = directory;

          AnalysisOptions options;
          options.file_name = base_file;
          options.signals   = &signals;
          std::unique_ptr<SampleStates::Sample> states;
          // states are interpolated between the lines of grids
          if (parameters.warm_start &&
              changed.surface.type != ReferenceSurface::Parameters::Type::mesh)
            {
              const ChartGrid grid(changed.mesh,
                                   *make_surface(changed.surface));
              states =
                std::make_unique<SampleStates::Sample>(SampleStates::Sample{
                  samples[i],
                  grid,
                  NestedPredictor(
                    grid, changed.laminate.n_layers(), changed.stages)});
              if (const SampleStates::Sample *nearest =
                    neighbors.nearest(samples[i], grid, scales))
                options.predictor = &nearest->states;
            }
          std::optional<OutputsOfAnalysis> reader;
          options.observer = [&](const Simulation &simulation,
                                 const StepReport &report,
                                 const State      &state) {
            if (states)
              states->states.learn(
                report.instant,
                GridState(simulation.get_equations().mesh, state));
            if (!reader)
              reader.emplace(parameters.outputs, changed, simulation);
            reader->read(simulation, report, state, results.outputs);
            ++results.n_steps;
            results.n_iterations += report.iterations;
          };
          const AnalysisResult result =
            analyze(changed, prm, notes, options, communicator, log, err);
          // what stopped on its way has no states for the later stages
          if (states && result.code == done)
            neighbors.add(std::move(states));
          return result;
        }
      catch (const InputError &error)
        {
          return fail(wrong_input, error.what());
        }
      catch (const OutputError &)
        {
          throw;
        }
      catch (const std::exception &error)
        {
          // other ranks may wait for this one
          if (Utilities::MPI::n_mpi_processes(communicator) > 1)
            throw;
          return fail(internal_error,
                      std::string("internal error: ") + error.what());
        }
    }


    bool
    Study::run_sample(const StudyTable  &table,
                      const unsigned int i,
                      const MPI_Comm     communicator,
                      const SignalWatch &signals)
    {
      const Timer         timer;
      StudyTable::Results results;
      results.outputs.assign(parameters.outputs.size(),
                             std::numeric_limits<double>::quiet_NaN());
      const AnalysisResult result = analyze_sample(
        i, table.sample_directory(i), communicator, signals, results);
      if (result.code == interrupted || result.code == terminated)
        return true;

      results.failure = result.reason;
      results.seconds = timer.wall_time();
      // at last: a sample without a row is run again
      write_text(
        table.row_file(i), table.row_text(i, results), false, communicator);
      return false;
    }


    ExitCode
    Study::run(const Group        &group,
               const bool          restart,
               RunLog             &log,
               ConditionalOStream &err)
    {
      // kept until the end, since it locks the directory
      const ResultsDirectory directory(parameters.directory, communicator);
      StudyTable             table = prepare_table(restart);
      log.open(path("study.log"), restart);
      ConditionalOStream out(log.stream(), is_root);

      // only the first rank has read the rows of a study that is continued
      const std::vector<unsigned int> todo =
        Utilities::MPI::broadcast(communicator, table.missing());
      const unsigned int n_ranks =
        Utilities::MPI::n_mpi_processes(communicator);
      out << "Study of " << base_file << ": " << samples.size() << " samples"
          << (restart ? ", " + std::to_string(todo.size()) + " of them missing"
                      : std::string())
          << "; " << n_ranks << (n_ranks == 1 ? " rank in " : " ranks in ")
          << group.number << (group.number == 1 ? " group" : " groups")
          << std::endl;

      unsigned int n_done = samples.size() - todo.size();
      // on all ranks of a group, which learn together that a file cannot be
      // written
      const auto report = [&]() {
        const std::vector<unsigned int> news = Utilities::MPI::broadcast(
          group.communicator,
          is_root ? table.collect() : std::vector<unsigned int>());
        for (const unsigned int i : news)
          out << "  " << ++n_done << " of " << samples.size() << ": sample "
              << i + 1 << ' ' << table.status(i) << ", " << table.seconds(i)
              << " s" << std::endl;
        if (!news.empty())
          write_text(path(StudyTable::file_name),
                     table.text(),
                     false,
                     group.communicator);
      };

      const SignalWatch signals;
      const Timer       timer;
      double            busy = 0;
      int               stop = 0;
      std::string       failure;
      {
        SampleQueue queue(communicator, group.communicator);
        try
          {
            for (long next = queue.next();
                 next < static_cast<long>(todo.size());
                 next = queue.next())
              {
                const Timer sample_timer;
                const bool  stopped =
                  run_sample(table, todo[next], group.communicator, signals);
                busy += sample_timer.wall_time();
                stop = signals.caught(group.communicator);
                // other groups end after the samples that they have begun
                if (stopped || stop != 0)
                  {
                    queue.skip_to(todo.size());
                    break;
                  }
                report();
              }
          }
        catch (const OutputError &error)
          {
            failure = error.what();
            queue.skip_to(todo.size());
          }
        // waits for all groups
      }
      try
        {
          report();
        }
      catch (const OutputError &error)
        {
          failure = error.what();
        }
      const double seconds = timer.wall_time();
      // each group counts once
      const double all_busy = Utilities::MPI::sum(
        Utilities::MPI::this_mpi_process(group.communicator) == 0 ? busy : 0.,
        communicator);
      stop = Utilities::MPI::max(stop, communicator);
      for (const std::string &text :
           Utilities::MPI::all_gather(communicator, failure))
        if (!text.empty())
          {
            err << "biface: " << text << std::endl;
            return internal_error;
          }

      char line[128];
      std::snprintf(line,
                    sizeof(line),
                    "; %.3g s, groups busy for %.1f %% of it\n",
                    seconds,
                    100 * all_busy / (group.number * seconds));
      out << n_done << " of " << samples.size() << " samples done, "
          << n_done - table.n_ok() << " of them failed" << line << "Results in "
          << parameters.directory << ": " << StudyTable::file_name
          << ", sample-*/, " << study_name << ", " << base_name << ", study.log"
          << std::endl;
      if (stop != 0)
        {
          out << "Stopped by " << signal_name(stop)
              << "; --restart runs the samples that are missing." << std::endl;
          return stop == SIGINT ? interrupted : terminated;
        }
      // the table of the first rank is complete
      if (Utilities::MPI::broadcast(communicator, table.n_ok()) == 0)
        {
          err << "biface: no sample of the study has succeeded; the column "
                 "'status' of "
              << StudyTable::file_name << " has the reasons." << std::endl;
          return no_convergence;
        }
      return done;
    }
  } // namespace


  void
  print_study_parameters(const bool json, std::ostream &screen)
  {
    StudyParameters  parameters;
    ParameterHandler prm;
    parameters.add_parameters(prm);
    prm.print_parameters(
      screen,
      (json ? ParameterHandler::JSON : ParameterHandler::PRM) |
        ParameterHandler::KeepDeclarationOrder);
  }


  ExitCode
  run_study(const StudyOptions &options,
            const MPI_Comm      communicator,
            std::ostream       &screen,
            ConditionalOStream &err)
  {
    const bool  is_root = (Utilities::MPI::this_mpi_process(communicator) == 0);
    Study       study(options, communicator);
    const Group group(communicator, study.parameters.group_size);
    study.check(group);
    if (options.check_only)
      {
        if (is_root)
          screen << "Study of " << study.samples.size()
                 << " samples. Parameters OK." << std::endl;
        return done;
      }
    RunLog log(screen, options.quiet, is_root);
    return study.run(group, options.restart, log, err);
  }
} // namespace Biface
