// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/mpi.h>

#include <iostream>

#include <biface/analysis/analysis.h>
#include <biface/analysis/run_log.h>
#include <biface/base/errors.h>
#include <biface/base/version.h>
#include <biface/model/mesh/rigid_motions.h>
#include <biface/problem/parameters.h>
#include <biface/program/command_line.h>
#include <biface/program/program.h>
#include <biface/program/starting_files.h>
#include <biface/study/study.h>

namespace Biface
{
  using namespace dealii;

  namespace
  {
    /** List the examples and templates, or write one of them. */
    void
    start_a_file(const CommandLine  &command_line,
                 const MPI_Comm      communicator,
                 ConditionalOStream &out)
    {
      if (command_line.file_name.empty())
        {
          out << list_of_starting_files();
          return;
        }
      if (command_line.action == CommandLine::Action::write_example &&
          !command_line.overrides.empty())
        throw InputError("an example is written as it is; change the file, or "
                         "use '--set' when it runs.");
      const std::vector<ShippedFile> files =
        (command_line.action == CommandLine::Action::write_example
           ? example_files(command_line.file_name)
           : template_files(command_line.file_name, command_line.overrides));
      write_starting_files(files, communicator);
      for (const ShippedFile &file : files)
        out << file.name << (&file == &files.back() ? "" : ", ");
      const bool is_study =
        (files.front().text.find("subsection Study") != std::string::npos);
      out << " written. Run it: biface " << (is_study ? "--study " : "")
          << files.front().name << std::endl;
    }


    /** Run the study of the command line, check it, or print its entries. */
    ExitCode
    start_study(const CommandLine  &command_line,
                const MPI_Comm      communicator,
                std::ostream       &screen,
                ConditionalOStream &err)
    {
      if (command_line.action == CommandLine::Action::print_parameters)
        {
          if (Utilities::MPI::this_mpi_process(communicator) == 0)
            print_study_parameters(command_line.json, screen);
          return done;
        }
      StudyOptions options;
      options.file_name  = command_line.file_name;
      options.overrides  = command_line.overrides;
      options.output     = command_line.output;
      options.restart    = command_line.restart;
      options.check_only = (command_line.action == CommandLine::Action::check);
      options.quiet      = command_line.quiet;
      return run_study(options, communicator, screen, err);
    }


    /** End the run after the last stage of the command line. */
    void
    choose_stages(const CommandLine &command_line, Parameters &parameters)
    {
      const auto [first, last] = command_line.stages;
      if (last > parameters.stages.size())
        throw InputError("the option '--stages' ends with stage " +
                         std::to_string(last) + ", but there are " +
                         std::to_string(parameters.stages.size()) + ".");
      // a stage needs the end of the one before
      if (first > 1 && !command_line.restart)
        throw InputError("the option '--stages' starts with stage " +
                         std::to_string(first) +
                         ", but a run starts with stage 1 unless '--restart' "
                         "continues it.");
      parameters.load_stepping.last_stage = last - 1;
    }
  } // namespace


  ExitCode
  run_program(const std::vector<std::string> &arguments,
              const MPI_Comm                  communicator,
              std::ostream                   &out_stream,
              std::ostream                   &err_stream)
  {
    const bool is_root = (Utilities::MPI::this_mpi_process(communicator) == 0);
    ConditionalOStream out(out_stream, is_root);
    ConditionalOStream err(err_stream, is_root);
    limit_blas_threads();

    // the file, for errors after its reading, which do not name it
    std::string source;
    try
      {
        const CommandLine command_line(arguments);
        using Action = CommandLine::Action;

        if (command_line.action == Action::print_help)
          out << CommandLine::help();
        else if (command_line.action == Action::print_version)
          out << "biface " << version() << std::endl;
        else if (command_line.action == Action::write_example ||
                 command_line.action == Action::write_template)
          start_a_file(command_line, communicator, out);
        else if (command_line.study)
          return start_study(command_line, communicator, out_stream, err);
        else
          {
            Parameters       parameters;
            ParameterHandler prm;
            const bool       print_only =
              (command_line.action == Action::print_parameters);
            const std::vector<std::string> notes =
              (print_only ? parse_parameters
                          : read_parameters)(command_line.file_name,
                                             command_line.overrides,
                                             communicator,
                                             parameters,
                                             prm);
            if (print_only)
              {
                for (const std::string &note : notes)
                  err << "biface: " << note << std::endl;
                if (is_root)
                  prm.print_parameters(
                    out_stream,
                    (command_line.json ? ParameterHandler::JSON
                                       : ParameterHandler::PRM) |
                      ParameterHandler::KeepDeclarationOrder);
                return done;
              }
            source = command_line.file_name + ": ";
            AnalysisOptions options;
            options.file_name   = command_line.file_name;
            options.restart     = command_line.restart;
            options.first_stage = command_line.stages.first - 1;
            if (command_line.stages.last > 0)
              choose_stages(command_line, parameters);
            options.check_only = (command_line.action == Action::check);
            RunLog log(out_stream, command_line.quiet, is_root);
            return analyze(
                     parameters, prm, notes, options, communicator, log, err)
              .code;
          }
        return done;
      }
    catch (const InputError &error)
      {
        err << "biface: " << source << error.what() << std::endl;
        return wrong_input;
      }
    catch (const OutputError &error)
      {
        err << "biface: " << error.what() << std::endl;
        return internal_error;
      }
  }
} // namespace Biface
