// SPDX-License-Identifier: LGPL-2.1-or-later

#include <regex>

#include <biface/base/errors.h>
#include <biface/program/command_line.h>

#include <getopt.h>

namespace Biface
{
  CommandLine::CommandLine(std::vector<std::string> arguments)
  {
    // as main() has them: the name of the program first, a null pointer last
    std::string         name = "biface";
    std::vector<char *> words{name.data()};
    for (std::string &argument : arguments)
      words.push_back(argument.data());
    words.push_back(nullptr);
    char **const argv = words.data();
    const int    argc = words.size() - 1;

    const option options[] = {
      {"set", required_argument, nullptr, 's'},
      {"output", required_argument, nullptr, 'o'},
      {"study", no_argument, nullptr, 't'},
      {"restart", no_argument, nullptr, 'r'},
      {"stages", required_argument, nullptr, 'g'},
      {"print-parameters", optional_argument, nullptr, 'p'},
      {"check", no_argument, nullptr, 'c'},
      {"example", no_argument, nullptr, 'e'},
      {"template", no_argument, nullptr, 'm'},
      {"quiet", no_argument, nullptr, 'q'},
      {"version", no_argument, nullptr, 'v'},
      {"help", no_argument, nullptr, 'h'},
      {nullptr, 0, nullptr, 0}};
    opterr = 0; // errors are reported below
    optind = 0; // start again, also on a second call

    int found;
    // the colon tells a missing value from an unknown option
    while ((found = getopt_long_only(argc, argv, ":", options, nullptr)) != -1)
      switch (found)
        {
          case 's':
            overrides.emplace_back(optarg);
            break;
          case 'o':
            output = optarg;
            break;
          case 't':
            study = true;
            break;
          case 'r':
            restart = true;
            break;
          case 'g':
            {
              std::smatch       match;
              const std::string range = optarg;
              if (!std::regex_match(
                    range, match, std::regex("(?:([0-9]{1,6})-)?([0-9]{1,6})")))
                throw InputError("the option '--stages' is '" + range +
                                 "', but must have the form '2' or '1-2'.");
              stages.last  = std::stoul(match[2]);
              stages.first = match[1].matched ? std::stoul(match[1]) : 1;
              if (stages.first < 1 || stages.last < stages.first)
                throw InputError("the option '--stages' is '" + range +
                                 "', but stages are counted from 1, and the "
                                 "last one is not before the first.");
              break;
            }
          case 'p':
            action = Action::print_parameters;
            if (optarg != nullptr && std::string(optarg) != "json")
              throw InputError("the option '--print-parameters' is '" +
                               std::string(optarg) +
                               "', but only '--print-parameters' and "
                               "'--print-parameters=json' are allowed.");
            json = (optarg != nullptr);
            break;
          case 'c':
            action = Action::check;
            break;
          case 'e':
            action = Action::write_example;
            break;
          case 'm':
            action = Action::write_template;
            break;
          case 'q':
            quiet = true;
            break;
          case 'v':
            action = Action::print_version;
            break;
          case 'h':
            action = Action::print_help;
            break;
          case ':':
            throw InputError("the option '" + std::string(argv[optind - 1]) +
                             "' needs a value; see --help.");
          default:
            throw InputError("there is no option '" +
                             std::string(argv[optind - 1]) + "'; see --help.");
        }

    // a study has a directory of its own
    if (!output.empty() && !study)
      overrides.emplace_back("Output/Directory=" + output,
                             "--output " + output);

    if (study && stages.last > 0)
      throw InputError("the option '--stages' belongs to a run, not to a "
                       "study; use 'Study/Settings' with 'Number of stages'.");
    if (optind < argc)
      file_name = argv[optind++];
    if (optind < argc)
      throw InputError("the command line has the files '" + file_name +
                       "' and '" + argv[optind] +
                       "', but only one parameter file is "
                       "allowed.");
    if (file_name.empty() && (action == Action::run || action == Action::check))
      throw InputError("the command line has no parameter file; see --help.");
  }


  std::string
  CommandLine::help()
  {
    return "Usage: biface [options] FILE.prm\n"
           "\n"
           "Nonlinear analysis of a layered shell in contact, as described by "
           "a parameter\nfile.\n"
           "\n"
           "  --set \"Section/Entry=value\"  override the file (repeatable)\n"
           "  --output DIR                 directory of the results\n"
           "  --study                      run the study that the file "
           "describes\n"
           "  --restart                    continue the run or study in this "
           "directory\n"
           "  --stages 1-2                 run these stages only; --restart "
           "continues\n"
           "  --print-parameters[=json]    print all entries with their "
           "documentation\n"
           "  --check                      check the file, do not run\n"
           "  --example [NAME]             list the examples, or write one "
           "here\n"
           "  --template NAME              write a file for sizes given by "
           "--set\n"
           "  --quiet                      print errors only; run.log has "
           "the rest\n"
           "  --version                    print the version\n"
           "  --help                       print this text\n"
           "\n"
           "Exit codes: 0 success, 1 invalid input, 2 no convergence "
           "(converged steps are\nkept), 3 results cannot be written, or internal "
           "error, 130 and 143 stopped by SIGINT and SIGTERM.\n";
  }
} // namespace Biface
