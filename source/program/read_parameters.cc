// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/mpi.h>
#include <deal.II/base/utilities.h>

#include <algorithm>
#include <filesystem>
#include <sstream>

#include <biface/base/errors.h>
#include <biface/input/parameter_sentence.h>
#include <biface/input/parameter_text.h>
#include <biface/input/read_file.h>
#include <biface/program/parameters.h>

namespace Biface
{
  using namespace dealii;

  namespace
  {
    void
    parse(ParameterHandler  &prm,
          const std::string &source,
          const std::string &text,
          const bool         skip_undefined)
    {
      try
        {
          prm.parse_input_from_string(text, "", skip_undefined);
        }
      catch (const ExceptionBase &exception)
        {
          throw InputError(parameter_sentence(exception, source, text, prm));
        }
    }


    /** "A/B/C=v" as the text of a parameter file. */
    std::string
    override_text(const Override &setting)
    {
      const std::string form   = "it must have the form 'Section/Entry=value'";
      const auto        equals = setting.find('=');
      if (equals == std::string::npos || equals == 0)
        throw InputError("--set", setting, form);
      const std::vector<std::string> path =
        Utilities::split_string_list(setting.substr(0, equals), '/');
      if (path.empty() || std::find(path.begin(), path.end(), "") != path.end())
        throw InputError("--set", setting, form);
      // what would end a line of a file, or go on with the next one
      if (setting.find_first_of("\n\r#") != std::string::npos ||
          Utilities::trim(setting).back() == '\\')
        throw InputError("--set",
                         setting,
                         "it must be one line without '#', and without a "
                         "backslash at its end");

      std::string text;
      for (unsigned int i = 0; i + 1 < path.size(); ++i)
        text += "subsection " + path[i] + "\n";
      text += "set " + path.back() + " = " + setting.substr(equals + 1) + "\n";
      for (unsigned int i = 0; i + 1 < path.size(); ++i)
        text += "end\n";
      return text;
    }

    /** Read settings, later ones in place of earlier ones.
     * @param sources what error messages call them, and their texts.
     * @param file_name whose folder holds the files that the settings name.
     */
    void
    parse_sources(
      const std::vector<std::pair<std::string, std::string>> &sources,
      const std::string                                      &file_name,
      Parameters                                             &parameters,
      ParameterHandler                                       &prm)
    {
      // these decide which sections there are
      ParameterHandler         names_only;
      unsigned int             n_stages = 1;
      std::vector<std::string> materials{"cord"};
      names_only.add_parameter(
        "Number of stages", n_stages, "", Patterns::Integer(1, 1000));
      names_only.add_parameter(
        "Materials", materials, "", Patterns::List(Patterns::Anything(), 1));
      for (const auto &source : sources)
        {
          check_parameter_text(source.first, source.second);
          parse(names_only, source.first, source.second, true);
        }

      if (materials.size() > 1000)
        throw InputError(file_name + ": the entry 'Materials' has " +
                         std::to_string(materials.size()) +
                         " names, but at most 1000 are allowed.");
      for (unsigned int i = 0; i < materials.size(); ++i)
        if (materials[i].empty() ||
            materials[i].find_first_of(":/@") != std::string::npos ||
            std::count(materials.begin(), materials.end(), materials[i]) > 1)
          throw InputError(
            file_name + ": " +
            InputError("Materials",
                       materials[i].empty() ? "," : materials[i],
                       "each name must be there once, without ':', '/', '@'")
              .what());

      parameters.add_parameters(prm, materials, n_stages);
      for (const auto &source : sources)
        parse(prm, source.first, source.second, false);

      // absolute, so that the parameters as written find the files, too
      const auto absolute = [&](const std::string &name) {
        std::error_code   error;
        const std::string result =
          std::filesystem::absolute(
            std::filesystem::path(file_name).parent_path() / name, error)
            .string();
        // the reader of the file says what is wrong
        return error ? name : result;
      };
      std::string &points_file = parameters.surface.points_file;
      if (!points_file.empty())
        {
          points_file = absolute(points_file);
          prm.enter_subsection("Surface");
          prm.enter_subsection("Points");
          prm.set("File", points_file);
          prm.leave_subsection();
          prm.leave_subsection();
        }
      std::string &tables = parameters.laminate.tables;
      if (!tables.empty())
        {
          // what is not 'name: file' is kept for Layup to refuse
          std::string list;
          for (std::string text : Utilities::split_string_list(tables, ','))
            {
              const auto colon = text.find(':');
              if (colon != std::string::npos)
                text = text.substr(0, colon) + ": " +
                       absolute(Utilities::trim(text.substr(colon + 1)));
              list += (list.empty() ? "" : ", ") + text;
            }
          tables = list;
          prm.enter_subsection("Laminate");
          prm.set("Tables", list);
          prm.leave_subsection();
        }

      try
        {
          parameters.check();
        }
      catch (const InputError &error)
        {
          throw InputError(file_name + ": " + error.what());
        }
    }
  } // namespace


  void
  read_parameters(const std::string           &file_name,
                  const std::vector<Override> &overrides,
                  const MPI_Comm               communicator,
                  Parameters                  &parameters,
                  ParameterHandler            &prm)
  {
    std::vector<std::pair<std::string, std::string>> sources;
    if (!file_name.empty())
      sources.emplace_back(file_name, read_file(file_name, communicator));
    for (const Override &setting : overrides)
      sources.emplace_back("--set " + setting, override_text(setting));
    parse_sources(sources, file_name, parameters, prm);
  }


  void
  parse_parameters(const std::string &source,
                   const std::string &text,
                   Parameters        &parameters,
                   ParameterHandler  &prm)
  {
    parse_sources({{source, text}}, source, parameters, prm);
  }


  std::string
  print_parameters(const ParameterHandler &prm)
  {
    std::ostringstream text;
    prm.print_parameters(
      text, ParameterHandler::PRM | ParameterHandler::KeepDeclarationOrder);
    return text.str();
  }
} // namespace Biface
