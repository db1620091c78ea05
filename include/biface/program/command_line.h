// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_program_command_line_h
#define biface_program_command_line_h

#include <string>
#include <vector>

#include <biface/problem/override.h>

namespace Biface
{
  /** The content of the command line. */
  struct CommandLine
  {
    enum class Action
    {
      run,
      check,
      print_parameters,
      write_example,
      write_template,
      print_version,
      print_help
    };

    Action                action = Action::run;
    std::string           file_name;
    std::vector<Override> overrides;
    /** Whether the file describes a study. */
    bool study = false;
    /** The directory of the results of a study; empty for that of its file. */
    std::string output;
    /** Whether to continue the run in the directory of results. */
    bool restart = false;
    /** The stages to run, counted from 1; all of them if @p last is 0. */
    struct
    {
      unsigned int first = 1, last = 0;
    } stages;
    /** Whether to print only errors to the screen. */
    bool quiet = false;

    /** Whether to print parameters as JSON. */
    bool json = false;

    /** Parse the command line. Throws InputError if it is invalid.
     * @param arguments without the name of the program. */
    explicit CommandLine(std::vector<std::string> arguments);

    static std::string
    help();
  };
} // namespace Biface

#endif
