// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/conditional_ostream.h>
#include <deal.II/base/mpi.h>
#include <deal.II/base/timer.h>
#include <deal.II/base/utilities.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <deque>
#include <exception>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iostream>
#include <limits>
#include <memory>
#include <optional>
#include <sstream>

#include <biface/base/errors.h>
#include <biface/input/parameter_text.h>
#include <biface/input/parameter_tools.h>
#include <biface/input/read_file.h>
#include <biface/output/atomic_file.h>
#include <biface/output/csv.h>
#include <biface/output/result_file.h>
#include <biface/output/scalar_results.h>
#include <biface/program/analysis.h>
#include <biface/program/sample_queue.h>
#include <biface/program/signal_watch.h>
#include <biface/program/simulation.h>
#include <biface/program/study.h>

namespace Biface
{
  using namespace dealii;

  namespace
  {
    constexpr const char *table_name = "study.csv";
    constexpr const char *row_name   = "sample.csv";
    constexpr const char *base_name  = "base.prm";
    constexpr const char *file_name  = "study.prm";


    std::vector<StudyParameters::Output>
    parse_outputs(const std::string &entry, const std::string &text)
    {
      std::vector<StudyParameters::Output> result;
      for (const std::string &item : split_list(entry, text))
        {
          const auto              at = item.find('@');
          StudyParameters::Output output;
          output.result = Utilities::trim(item.substr(0, at));
          if (at != std::string::npos)
            output.stage = Utilities::trim(item.substr(at + 1));
          if (output.result.empty() ||
              (at != std::string::npos && output.stage.empty()))
            throw InputError(entry,
                             text,
                             "it must be a list of results, as in 'force, "
                             "strain_energy @ inflation'");
          for (const StudyParameters::Output &other : result)
            if (other.name() == output.name())
              throw InputError(entry,
                               text,
                               Biface::quoted(output.name()) +
                                 " is listed twice");
          result.push_back(output);
        }
      return result;
    }


    std::vector<Override>
    parse_settings(const std::string &entry, const std::string &text)
    {
      std::vector<Override> result;
      for (const std::string &item : split_list(entry, text, ';'))
        {
          if (item.find('=') == std::string::npos || item[0] == '=')
            throw InputError(
              entry, item, "it must have the form 'Section/Entry=value'");
          result.emplace_back(item, "--study " + item);
        }
      return result;
    }


    /** A text as a cell of a CSV file. */
    std::string
    csv_text(const std::string &text)
    {
      std::string result = "\"";
      for (const char c : text)
        if (c == '"')
          result += "\"\"";
        else
          result += (c == '\n' ? ' ' : c);
      return result + '"';
    }


    /** The lines of a small file; none if it cannot be read. */
    std::vector<std::string>
    lines_of(const std::string &path)
    {
      std::vector<std::string> result;
      std::ifstream            file(path);
      for (std::string line; std::getline(file, line);)
        result.push_back(line);
      return result;
    }


    /** Write a complete file on one rank. Throws OutputError. */
    void
    write_whole(const std::string &path, const std::string &text)
    {
      AtomicFile file(path);
      file.write(text);
      file.commit();
      if (!file.error().empty())
        throw OutputError(path, file.error());
    }


    /** Call a function on the first rank. Throws OutputError on all ranks; the
     * first one has the reason. */
    void
    write_on_first(const MPI_Comm               communicator,
                   const std::function<void()> &write)
    {
      std::optional<OutputError> error;
      if (Utilities::MPI::this_mpi_process(communicator) == 0)
        try
          {
            write();
          }
        catch (const OutputError &caught)
          {
            error = caught;
          }
      const bool failed =
        Utilities::MPI::broadcast(communicator, error.has_value());
      if (error)
        throw *error;
      if (failed)
        throw OutputError(table_name, "see the message of the first rank");
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


    /** The states of finished samples, from which others start. */
    class Neighbors
    {
    public:
      /** The states in the steps of a sample. */
      struct Sample
      {
        std::vector<double> values;
        ChartGrid           grid;
        NestedPredictor     states;
      };

      /** Add the states of a sample; old ones are forgotten. */
      void
      add(std::unique_ptr<Sample> sample)
      {
        // a few megabytes each on the meshes of tires
        constexpr std::size_t limit = 30;
        if (samples.size() == limit)
          samples.pop_front();
        samples.push_back(std::move(sample));
      }

      /** The nearest sample with the same grid; null if there is none.
       * @param scales the differences of values that count as much. */
      const Sample *
      nearest(const std::vector<double> &values,
              const ChartGrid           &grid,
              const std::vector<double> &scales) const
      {
        const Sample *result   = nullptr;
        double        smallest = std::numeric_limits<double>::infinity();
        for (const auto &sample : samples)
          {
            if (!same(sample->grid, grid))
              continue;
            double distance = 0;
            for (unsigned int i = 0; i < values.size(); ++i)
              distance +=
                std::pow((sample->values[i] - values[i]) / scales[i], 2);
            // the last one of several
            if (distance <= smallest)
              {
                smallest = distance;
                result   = sample.get();
              }
          }
        return result;
      }

    private:
      /** Whether two grids have the same lines, up to their scale. */
      static bool
      same(const ChartGrid &a, const ChartGrid &b)
      {
        return a.lines == b.lines && a.closed == b.closed;
      }

      std::deque<std::unique_ptr<Sample>> samples;
    };


    /** The values of the outputs in an analysis. */
    class OutputsOfAnalysis
    {
    public:
      /** Throws InputError if there is no such result. */
      OutputsOfAnalysis(const std::vector<StudyParameters::Output> &outputs,
                        const Parameters                           &parameters,
                        const Simulation                           &simulation)
      {
        for (unsigned int s = 0; s < parameters.stages.size(); ++s)
          {
            std::vector<unsigned int> numbers;
            std::vector<std::string>  names;
            for (unsigned int o = 0; o < outputs.size(); ++o)
              if (last_stage(outputs[o], parameters.stages) == s)
                {
                  numbers.push_back(o);
                  names.push_back(outputs[o].result);
                }
            const Stage               &stage = parameters.stages[s];
            const ScalarResults::Known known{
              simulation.get_gas() != nullptr, stage.n_modes, stage.n_buckling};
            of_stages.push_back(
              {numbers,
               ScalarResults("Study/Outputs",
                             names,
                             simulation.get_equations().mesh,
                             parameters.output.criteria,
                             parameters.output.forces.moment_center,
                             known,
                             ScalarResults::Columns::all)});
          }
      }

      /** Read the values if a step is the last one of its stage. On all
       * ranks. */
      void
      read(const Simulation    &simulation,
           const StepReport    &report,
           const State         &state,
           std::vector<double> &values) const
      {
        const OfStage &stage = of_stages[report.instant.stage];
        if (report.instant.fraction < 1 || stage.numbers.empty())
          return;
        const Gas                *gas = simulation.get_gas();
        const std::vector<double> found =
          stage.results.evaluate(simulation.get_equations(),
                                 gas ? &gas->cavity : nullptr,
                                 report,
                                 state);
        for (unsigned int i = 0; i < found.size(); ++i)
          values[stage.numbers[i]] = found[i];
      }

    private:
      struct OfStage
      {
        /** The positions of the outputs. */
        std::vector<unsigned int> numbers;
        ScalarResults             results;
      };

      /** The position of the last stage with the name that an output asks
       * for. */
      static unsigned int
      last_stage(const StudyParameters::Output &output,
                 const std::vector<Stage>      &stages)
      {
        unsigned int result = stages.size() - 1;
        while (!output.stage.empty() && stages[result].name != output.stage)
          {
            Assert(result > 0, ExcInternalError());
            --result;
          }
        return result;
      }

      std::vector<OfStage> of_stages;
    };


    /** A study after reading. */
    class Study
    {
    public:
      Study(const CommandLine &command_line, const MPI_Comm communicator);

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

      std::string
      path(const std::string &file) const
      {
        return parameters.directory + "/" + file;
      }

    private:
      std::string
      sample_directory(const unsigned int i) const;

      std::string
      header() const;

      /** The number of a sample and the values of its variables. */
      std::string
      first_cells(const unsigned int i) const;

      /** Create the directory, or check that of the study to be continued. */
      void
      prepare_directory(const bool restart);

      /** Read the lines of the table that exist. On the first rank.
       * @return the samples of new lines. */
      std::vector<unsigned int>
      collect();

      /** Write the table. On the first rank. */
      void
      write_table() const;

      /** Run a sample and write its line of the table.
       * @return whether it was stopped by a signal; then it has no line. */
      bool
      run_sample(const unsigned int i,
                 const MPI_Comm     communicator,
                 const SignalWatch &signals);

      /** The analysis of a sample.
       * @param outputs receives their values, if the run gets there. */
      AnalysisResult
      analyze_sample(const unsigned int   i,
                     const MPI_Comm       communicator,
                     const SignalWatch   &signals,
                     std::vector<double> &outputs);

      /** The cells of steps and iterations of a sample. On the first rank of a
       * group. */
      std::string
      count_steps(const unsigned int i) const;

      const MPI_Comm        communicator;
      const bool            is_root;
      const std::string     study_file;
      std::string           base_file;
      std::vector<Override> base_overrides;
      Parameters            base;
      ParameterHandler      base_prm;
      std::string           study_text;
      std::vector<double>   scales;
      Neighbors             neighbors;

      /** The lines of the table; empty if unknown. On the first rank. */
      std::vector<std::string> rows;
    };


    Study::Study(const CommandLine &command_line, const MPI_Comm communicator)
      : communicator(communicator)
      , is_root(Utilities::MPI::this_mpi_process(communicator) == 0)
      , study_file(command_line.file_name)
    {
      const std::string &name = study_file;
      const std::string  folder =
        std::filesystem::path(name).parent_path().string();
      const std::string text = read_file(name, communicator);
      ParameterHandler  prm;
      prm.enter_subsection("Study");
      parameters.add_parameters(prm);
      prm.leave_subsection();
      check_parameter_text(name, text);
      parse_parameter_text(prm, name, text);
      if (!command_line.output.empty())
        parameters.directory = command_line.output;

      try
        {
          if (parameters.base_file.empty())
            throw InputError(
              "Study/Base file", "", "a study needs a parameter file");
          samples = parameters.sampling.samples(folder, communicator);
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
      for (const Override &setting : command_line.overrides)
        base_overrides.push_back(setting);
      read_parameters(base_file, base_overrides, communicator, base, base_prm);

      try
        {
          for (const auto &variable : parameters.sampling.variables)
            variable.check(base_prm);
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
          double low = samples[0][j], high = low;
          for (const std::vector<double> &sample : samples)
            {
              low  = std::min(low, sample[j]);
              high = std::max(high, sample[j]);
            }
          scales.push_back(high > low ? high - low : 1.);
        }
      rows.resize(samples.size());
    }


    void
    Study::check(const Group &group) const
    {
      std::ostringstream                screen;
      std::unique_ptr<const Simulation> simulation;
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


    std::string
    Study::sample_directory(const unsigned int i) const
    {
      const unsigned int digits =
        std::max<std::size_t>(4, std::to_string(samples.size()).size());
      return path("sample-" + Utilities::int_to_string(i + 1, digits));
    }


    std::string
    Study::header() const
    {
      std::string result = "sample";
      for (const DesignVariable &variable : parameters.sampling.variables)
        result += ',' + variable.get_name();
      for (const StudyParameters::Output &output : parameters.outputs)
        result += ',' + output.name();
      return result + ",status,steps,iterations,seconds";
    }


    std::string
    Study::first_cells(const unsigned int i) const
    {
      std::string result = std::to_string(i + 1);
      for (const double value : samples[i])
        result += ',' + exact_number(value);
      return result + ',';
    }


    void
    Study::prepare_directory(const bool restart)
    {
      const ResultsDirectory directory(parameters.directory, communicator);
      std::string            reason;
      if (is_root)
        {
          const std::string base_text = print_parameters(base_prm);
          if (restart)
            {
              collect();
              std::string before;
              for (const std::string &line : lines_of(path(base_name)))
                before += line + '\n';
              if (before.empty())
                reason = "the directory " +
                         Biface::quoted(parameters.directory) +
                         " contains no study that can be continued.";
              else if (before != base_text)
                reason = "the study in " +
                         Biface::quoted(parameters.directory) +
                         " has another base file or other settings, see "
                         "'base.prm' there, and cannot be continued.";
              for (unsigned int i = 0; i < rows.size() && reason.empty(); ++i)
                if (!rows[i].empty() && rows[i].rfind(first_cells(i), 0) != 0)
                  reason = "the study in " +
                           Biface::quoted(parameters.directory) +
                           " has other samples or outputs and cannot be "
                           "continued.";
            }
          else
            {
              // lines of an earlier study
              std::error_code error;
              for (const auto &entry : std::filesystem::directory_iterator(
                     parameters.directory, error))
                if (entry.path().filename().string().rfind("sample-", 0) == 0)
                  std::filesystem::remove(entry.path() / row_name, error);
            }
        }
      reason = Utilities::MPI::broadcast(communicator, reason);
      if (!reason.empty())
        throw InputError(reason);
      write_on_first(communicator, [&]() {
        write_whole(path(base_name), print_parameters(base_prm));
        write_whole(path(file_name), study_text);
        write_table();
      });
    }


    std::vector<unsigned int>
    Study::collect()
    {
      std::vector<unsigned int> result;
      for (unsigned int i = 0; i < rows.size(); ++i)
        if (rows[i].empty())
          {
            const std::vector<std::string> lines =
              lines_of(sample_directory(i) + "/" + row_name);
            if (lines.size() != 2)
              continue;
            // a line with other columns cannot be continued
            rows[i] = (lines[0] == header() ? lines[1] : "?");
            result.push_back(i);
          }
      return result;
    }


    void
    Study::write_table() const
    {
      std::string text = header() + '\n';
      for (const std::string &row : rows)
        if (!row.empty())
          text += row + '\n';
      write_whole(path(table_name), text);
    }


    std::string
    Study::count_steps(const unsigned int i) const
    {
      const std::vector<std::string> lines =
        lines_of(sample_directory(i) + "/history.csv");
      const std::vector<std::string> columns =
        Utilities::split_string_list(lines.empty() ? "" : lines[0], ',');
      const std::size_t column =
        std::find(columns.begin(), columns.end(), "iterations") -
        columns.begin();
      unsigned int n_iterations = 0;
      for (std::size_t l = 1; l < lines.size(); ++l)
        {
          const std::vector<std::string> cells =
            Utilities::split_string_list(lines[l], ',');
          if (column < cells.size())
            n_iterations += std::atoi(cells[column].c_str());
        }
      return std::to_string(lines.empty() ? 0 : lines.size() - 1) + ',' +
             std::to_string(n_iterations);
    }


    AnalysisResult
    Study::analyze_sample(const unsigned int   i,
                          const MPI_Comm       communicator,
                          const SignalWatch   &signals,
                          std::vector<double> &outputs)
    {
      const bool is_first =
        (Utilities::MPI::this_mpi_process(communicator) == 0);
      const std::string directory = sample_directory(i);
      ResultsDirectory(directory, communicator);

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
          std::unique_ptr<Neighbors::Sample> states;
          if (parameters.warm_start)
            {
              const ChartGrid grid(changed.mesh,
                                   *make_surface(changed.surface));
              states = std::make_unique<Neighbors::Sample>(Neighbors::Sample{
                samples[i], grid, NestedPredictor(grid, changed.stages)});
              if (const Neighbors::Sample *nearest =
                    neighbors.nearest(samples[i], grid, scales))
                options.predictor = &nearest->states;
            }
          std::optional<const OutputsOfAnalysis> results;
          options.observer = [&](const Simulation &simulation,
                                 const StepReport &report,
                                 const State      &state) {
            if (states)
              states->states.learn(
                report.instant,
                GridState(simulation.get_equations().mesh, state));
            if (!results)
              results.emplace(parameters.outputs, changed, simulation);
            results->read(simulation, report, state, outputs);
          };
          const AnalysisResult result =
            analyze(changed, prm, notes, options, communicator, log, err);
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
    Study::run_sample(const unsigned int i,
                      const MPI_Comm     communicator,
                      const SignalWatch &signals)
    {
      const Timer          timer;
      std::vector<double>  outputs(parameters.outputs.size(),
                                  std::numeric_limits<double>::quiet_NaN());
      const AnalysisResult result =
        analyze_sample(i, communicator, signals, outputs);
      if (result.code == interrupted || result.code == terminated)
        return true;

      write_on_first(communicator, [&]() {
        std::string cells;
        for (const double value : outputs)
          cells +=
            (result.code == done && !std::isnan(value) ? csv_number(value)
                                                       : std::string()) +
            ',';
        write_whole(sample_directory(i) + "/" + row_name,
                    header() + '\n' + first_cells(i) + cells +
                      csv_text(result.code == done ? "ok" : result.reason) +
                      ',' + count_steps(i) + ',' +
                      csv_number(timer.wall_time()) + '\n');
      });
      return false;
    }


    ExitCode
    Study::run(const Group        &group,
               const bool          restart,
               RunLog             &log,
               ConditionalOStream &err)
    {
      prepare_directory(restart);
      log.open(path("study.log"), restart);
      ConditionalOStream out(log.stream(), is_root);

      std::vector<unsigned int> todo;
      for (unsigned int i = 0; i < rows.size(); ++i)
        if (rows[i].empty())
          todo.push_back(i);
      todo = Utilities::MPI::broadcast(communicator, todo);
      const unsigned int n_ranks =
        Utilities::MPI::n_mpi_processes(communicator);
      out << "Study of " << base_file << ": " << samples.size() << " samples"
          << (restart ? ", " + std::to_string(todo.size()) + " of them missing"
                      : std::string())
          << "; " << n_ranks << (n_ranks == 1 ? " rank in " : " ranks in ")
          << group.number << (group.number == 1 ? " group" : " groups")
          << std::endl;

      unsigned int n_done = rows.size() - todo.size();
      const auto   report = [&]() {
        if (!is_root)
          return;
        const std::vector<unsigned int> news = collect();
        for (const unsigned int i : news)
          {
            const std::string &row   = rows[i];
            const auto         first = row.find('"');
            const auto         last  = row.find_last_of('"');
            out << "  " << ++n_done << " of " << rows.size() << ": sample "
                << i + 1 << ' ' << row.substr(first + 1, last - first - 1)
                << ", " << row.substr(row.find_last_of(',') + 1) << " s"
                << std::endl;
          }
        if (!news.empty())
          write_table();
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
                  run_sample(todo[next], group.communicator, signals);
                busy += sample_timer.wall_time();
                stop = signals.caught(group.communicator);
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

      const unsigned int n_ok =
        std::count_if(rows.begin(), rows.end(), [](const std::string &row) {
          return row.find(",\"ok\",") != std::string::npos;
        });
      char line[128];
      std::snprintf(line,
                    sizeof(line),
                    "; %.3g s, groups busy for %.1f %% of it\n",
                    seconds,
                    100 * all_busy / (group.number * seconds));
      out << n_done << " of " << rows.size() << " samples done, "
          << n_done - n_ok << " of them failed" << line << "Results in "
          << parameters.directory << ": " << table_name << ", sample-*/, "
          << file_name << ", " << base_name << ", study.log" << std::endl;
      if (stop != 0)
        {
          out << "Stopped by " << signal_name(stop)
              << "; --restart runs the samples that are missing." << std::endl;
          return stop == SIGINT ? interrupted : terminated;
        }
      return done;
    }
  } // namespace


  void
  StudyParameters::add_parameters(ParameterHandler &prm)
  {
    add_parsed(prm,
               "Study/",
               "Base file",
               "",
               base_file,
               parse_file_name,
               "The parameter file of the analyses. Relative to the folder of "
               "the study file.");
    add_parsed(prm,
               "Study/",
               "Settings",
               "",
               settings,
               parse_settings,
               "Entries of the base file with other values in all samples: a "
               "list of 'Section/Entry=value', separated by semicolons.");
    sampling.add_parameters(prm);
    add_parsed(prm,
               "Study/",
               "Outputs",
               "",
               outputs,
               parse_outputs,
               "Results that become columns of study.csv: a comma-separated "
               "list of 'result' at the end of the run, or 'result @ stage' at "
               "the end of the stage of this name. A result is a column of "
               "history.csv such as 'force', a displacement of a named point "
               "such as 'top u_x', a component of forces.csv such as 'alpha_1 "
               "min F_x', the frequency of a mode such as 'frequency 1', or a "
               "factor of 'Buckling' such as 'buckling factor 1'.");
    prm.add_parameter("Directory",
                      directory,
                      "Directory of the results, created if it does not exist. "
                      "Each sample has a subdirectory.");
    prm.add_parameter("Group size",
                      group_size,
                      "Number of ranks that run a sample together. Each group "
                      "takes the next sample when it is free.",
                      Patterns::Integer(1));
    prm.add_parameter("Warm start",
                      warm_start,
                      "Whether the steps of a sample start from the states of "
                      "the nearest sample of the same group that has the same "
                      "mesh, which saves iterations.",
                      Patterns::Bool());
  }


  ExitCode
  run_study(const CommandLine  &command_line,
            const MPI_Comm      communicator,
            std::ostream       &screen,
            ConditionalOStream &err)
  {
    const bool is_root = (Utilities::MPI::this_mpi_process(communicator) == 0);
    if (command_line.action == CommandLine::Action::print_parameters)
      {
        StudyParameters  parameters;
        ParameterHandler prm;
        prm.enter_subsection("Study");
        parameters.add_parameters(prm);
        prm.leave_subsection();
        if (is_root)
          prm.print_parameters(screen,
                               (command_line.json ? ParameterHandler::JSON
                                                  : ParameterHandler::PRM) |
                                 ParameterHandler::KeepDeclarationOrder);
        return done;
      }

    Study       study(command_line, communicator);
    const Group group(communicator, study.parameters.group_size);
    study.check(group);
    if (command_line.action == CommandLine::Action::check)
      {
        if (is_root)
          screen << "Study of " << study.samples.size()
                 << " samples. Parameters OK." << std::endl;
        return done;
      }
    RunLog log(screen, command_line.quiet, is_root);
    return study.run(group, command_line.restart, log, err);
  }
} // namespace Biface
