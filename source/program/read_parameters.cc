// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/mpi.h>
#include <deal.II/base/utilities.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <numeric>
#include <regex>
#include <sstream>

#include <biface/base/input_error.h>
#include <biface/base/parameter_tools.h>
#include <biface/base/read_file.h>
#include <biface/program/parameters.h>

namespace Biface
{
  using namespace dealii;

  namespace
  {
    /** The sections of a file that its lines stand in, as
     * "Section/Subsection/". The first line has the number 1. */
    std::vector<std::string>
    sections_of_lines(const std::string &text)
    {
      std::vector<std::string> result(1);
      std::string              path;
      std::istringstream       lines(text);
      std::string              line;
      while (std::getline(lines, line))
        {
          result.push_back(path);
          line = Utilities::trim(line.substr(0, line.find('#')));
          std::smatch match;
          if (std::regex_match(line, match, std::regex("subsection\\s+(.*)")))
            path += match[1].str() + "/";
          else if (line == "end" && !path.empty())
            path.erase(path.find_last_of('/', path.size() - 2) + 1);
        }
      return result;
    }


    /** ParameterHandler silently takes the last of two settings of one entry:
     * more likely, one of them is a mistake. */
    void
    check_duplicates(const std::string &source, const std::string &text)
    {
      const std::vector<std::string>      sections = sections_of_lines(text);
      std::map<std::string, unsigned int> line_of_entry;
      std::istringstream                  lines(text);
      std::string                         line;
      for (unsigned int number = 1; std::getline(lines, line); ++number)
        {
          std::smatch match;
          if (!std::regex_match(
                line, match, std::regex("\\s*set\\s+([^=#]*[^=#\\s])\\s*=.*")))
            continue;
          const std::string name  = sections[number] + match[1].str();
          const auto        entry = line_of_entry.emplace(name, number);
          if (!entry.second)
            throw InputError(
              source + ", line " + std::to_string(number) + ": the entry '" +
              name + "' is set a second time, but line " +
              std::to_string(entry.first->second) + " has set it already.");
        }
    }


    /** Full names of all entries and sections. */
    std::vector<std::string>
    declared_names(const ParameterHandler &prm)
    {
      std::ostringstream text;
      prm.print_parameters(text,
                           ParameterHandler::ShortPRM |
                             ParameterHandler::KeepDeclarationOrder);

      std::vector<std::string> names;
      std::istringstream       lines(text.str());
      std::string              line;
      std::string              path;
      while (std::getline(lines, line))
        {
          line = Utilities::trim(line);
          if (line.rfind("subsection ", 0) == 0)
            {
              path += line.substr(11) + "/";
              names.push_back(path);
            }
          else if (line.rfind("set ", 0) == 0)
            names.push_back(
              path + Utilities::trim(line.substr(4, line.find('=') - 4)));
          else if (line == "end")
            path.erase(path.find_last_of('/', path.size() - 2) + 1);
        }
      return names;
    }


    /** Number of single-letter edits between two words. */
    unsigned int
    edit_distance(const std::string &a, const std::string &b)
    {
      std::vector<unsigned int> row(b.size() + 1);
      std::iota(row.begin(), row.end(), 0);
      for (unsigned int i = 0; i < a.size(); ++i)
        {
          unsigned int diagonal = row[0]++;
          for (unsigned int j = 0; j < b.size(); ++j)
            {
              const unsigned int replaced =
                diagonal + (std::tolower(a[i]) != std::tolower(b[j]));
              diagonal   = row[j + 1];
              row[j + 1] = std::min({row[j + 1] + 1, row[j] + 1, replaced});
            }
        }
      return row.back();
    }


    std::string
    nearest_name(const ParameterHandler &prm, const std::string &name)
    {
      const std::vector<std::string> names = declared_names(prm);
      return *std::min_element(
        names.begin(), names.end(), [&](const auto &a, const auto &b) {
          return edit_distance(name, a) < edit_distance(name, b);
        });
    }


    /** What a pattern of deal.II allows, in words. */
    std::string
    allowed_by(const std::string &pattern)
    {
      std::smatch match;
      if (std::regex_match(pattern, match, std::regex("\\[Selection (.*) \\]")))
        {
          std::string choices =
            std::regex_replace(match[1].str(), std::regex("\\|"), "', '");
          return "it must be one of '" + choices + "'";
        }
      if (std::regex_match(
            pattern,
            match,
            std::regex("\\[Integer range ([-0-9]+)\\.\\.\\.([-0-9]+).*\\]")))
        return "it must be a whole number from " + match[1].str() + " to " +
               match[2].str();
      if (std::regex_match(pattern, std::regex("\\[Integer.*\\]")))
        return "it must be a whole number";
      if (std::regex_match(pattern, std::regex("\\[Bool\\]")))
        return "it must be 'true' or 'false'";
      if (std::regex_match(pattern, std::regex("\\[Double.*\\]")))
        return "it must be a number";
      if (std::regex_search(pattern, std::regex("^\\[List of <\\[Double")) &&
          std::regex_search(
            pattern, match, std::regex("of length ([0-9]+)\\.\\.\\.\\1 ")))
        return "it must be a list of " + match[1].str() +
               " numbers, separated by commas";
      return "it must match the pattern " + pattern;
    }


    /** One sentence from what ParameterHandler has to say. */
    std::string
    sentence(const ExceptionBase    &exception,
             const std::string      &source,
             const std::string      &text,
             const ParameterHandler &prm)
    {
      std::ostringstream stream;
      exception.print_info(stream);
      const std::string said = Utilities::trim(
        std::regex_replace(stream.str(), std::regex("\\s+"), " "));

      const std::vector<std::string> sections = sections_of_lines(text);
      std::smatch                    match;
      const auto                     is = [&](const std::string &form) {
        return std::regex_match(said, match, std::regex(form));
      };
      const std::string line  = "Line <([0-9]+)> of file <input string>?: ";
      const auto        where = [&](const std::string &number) {
        // a setting of the command line is one line to its reader
        return source +
               (source.rfind("--set", 0) == 0 ? "" : ", line " + number) + ": ";
      };

      if (is(line + "The entry value (.*) for the entry named (.*) does not "
                    "match the given pattern: (.*)"))
        {
          const std::string name =
            sections.at(std::stoi(match[1])) + match[3].str();
          return where(match[1]) +
                 InputError(name, match[2], allowed_by(match[4])).what();
        }
      if (is(line + "No entry with name <(.*)> was declared in the current "
                    "subsection\\.?") ||
          is(line + "There is no such subsection to be entered: (.*)"))
        {
          const std::string name =
            sections.at(std::stoi(match[1])) + match[2].str();
          return where(match[1]) + "there is no entry '" + name +
                 "'; the nearest name is '" + nearest_name(prm, name) + "'.";
        }
      if (is(line + "The line <(.*)> could not be parsed.*"))
        return where(match[1]) + "'" + match[2].str() +
               "' is none of 'set ENTRY = VALUE', 'subsection NAME', 'end', "
               "'include FILE', and no comment.";
      if (is(line + "(.*)"))
        return where(match[1]) + match[2].str();
      if (is("There are unequal numbers of 'subsection' and 'end'.*"))
        return source +
               ": the numbers of 'subsection' and 'end' must be equal, but "
               "they are not.";
      return source + ": " + said;
    }


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
          throw InputError(sentence(exception, source, text, prm));
        }
    }


    /** "A/B/C=v" as the text of a parameter file. */
    std::string
    override_text(const Override &setting)
    {
      const auto equals = setting.find('=');
      if (equals == std::string::npos || equals == 0)
        throw InputError(
          "--set", setting, "it must have the form 'Section/Entry=value'");
      const std::vector<std::string> path =
        Utilities::split_string_list(setting.substr(0, equals), '/');
      if (path.empty())
        throw InputError(
          "--set", setting, "it must have the form 'Section/Entry=value'");

      std::string text;
      for (unsigned int i = 0; i + 1 < path.size(); ++i)
        text += "subsection " + path[i] + "\n";
      text += "set " + path.back() + " = " + setting.substr(equals + 1) + "\n";
      for (unsigned int i = 0; i + 1 < path.size(); ++i)
        text += "end\n";
      return text;
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
        check_duplicates(source.first, source.second);
        parse(names_only, source.first, source.second, true);
      }

    parameters.add_parameters(prm, materials, n_stages);
    for (const auto &source : sources)
      parse(prm, source.first, source.second, false);

    std::string &points_file = parameters.surface.points_file;
    if (!points_file.empty())
      points_file =
        (std::filesystem::path(file_name).parent_path() / points_file).string();

    try
      {
        parameters.check();
      }
    catch (const InputError &error)
      {
        throw InputError(file_name + ": " + error.what());
      }
  }
} // namespace Biface
