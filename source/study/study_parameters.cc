// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/utilities.h>

#include <biface/base/errors.h>
#include <biface/input/entry_declarations.h>
#include <biface/input/parameter_text.h>
#include <biface/input/parameter_tools.h>
#include <biface/study/study_parameters.h>

namespace Biface
{
  using namespace dealii;

  namespace
  {
    std::vector<StudyParameters::Output>
    parse_outputs(const std::string &entry, const std::string &text)
    {
      std::vector<StudyParameters::Output> result;
      for (const std::string &item : split_list(entry, text))
        {
          const auto              at = item.find('@');
          StudyParameters::Output output;
          output.result = Utilities::trim(item.substr(0, at));
          for (unsigned int of = 1; of < output.words.size(); ++of)
            if (output.result.rfind(output.words[of], 0) == 0)
              {
                output.of     = static_cast<StudyParameters::Output::Of>(of);
                output.result = Utilities::trim(
                  output.result.substr(std::string(output.words[of]).size()));
                break;
              }
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
  } // namespace


  void
  StudyParameters::add_parameters(ParameterHandler &handler)
  {
    EntryDeclarations prm(handler);
    prm.enter_subsection("Study");
    // the base file is only named here; its path is relative to the file of the
    // study
    add_parsed(prm,
               "Base file",
               "",
               base_file,
               parse_file_name,
               "The parameter file of the analyses. Relative to the folder of "
               "the study file.");
    add_parsed(prm,
               "Settings",
               "",
               settings,
               parse_settings,
               "Entries of the base file with other values in all samples: a "
               "list of 'Section/Entry=value', separated by semicolons.");
    sampling.add_parameters(prm);
    add_parsed(prm,
               "Outputs",
               "",
               outputs,
               parse_outputs,
               "Results that become columns of study.csv: a comma-separated "
               "list of 'result' at the end of the run, 'result @ stage' at "
               "the end of the stage of this name, or 'maximum result', "
               "'minimum result' and 'first maximum result' over all steps of "
               "either; the last one is the result of the first step before "
               "one with a smaller result, empty if there is none. A result is "
               "a column of history.csv such as 'force', a displacement of a "
               "named point such as 'top u_x', a component of forces.csv such "
               "as 'alpha_1 min F_x', a stiffness 'BODY tangent' or 'BODY "
               "secant' of the ground ('foundation'), a body or a support that "
               "moves, such as 'alpha_1 max tangent', or, at the ends only, "
               "the frequency of a mode such as 'frequency 1' or a factor of "
               "'Buckling' such as 'buckling factor 1'.");
    prm.add_parameter("Reference sample",
                      reference_sample,
                      "Number of a sample. study.csv has a column 'OUTPUT / "
                      "sample N' more for each output: its value over that of "
                      "sample N, such as the knock-down factor if this is the "
                      "perfect shell. 0: no reference.",
                      Patterns::Integer(0));
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
    prm.leave_subsection();
  }
} // namespace Biface
