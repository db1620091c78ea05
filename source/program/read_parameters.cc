// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/mpi.h>
#include <deal.II/base/utilities.h>

#include <algorithm>
#include <cctype>
#include <cmath>
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
    /** A line of a parameter file. */
    struct Line
    {
      /** The section it stands in, as "Section/Subsection/". */
      std::string section;
      /** `set`, `subsection`, `end`, `include`, or anything else. */
      std::string keyword;
      /** What stands before and after the first '='. */
      std::string name;
      std::string value;
      /** How many sections are open after it. */
      unsigned int depth = 0;
    };

    /** More levels of sections than any entry has. */
    constexpr unsigned int max_depth = 10;


    /** The lines of a file, the first one with the number 1. */
    std::vector<Line>
    scan(const std::string &text)
    {
      std::vector<Line>  result(1);
      std::string        section;
      unsigned int       depth = 0;
      std::istringstream lines(text);
      std::string        physical, content;
      while (std::getline(lines, physical))
        {
          // a backslash joins a line with the next one
          physical = Utilities::trim(physical);
          if (!physical.empty() && physical.back() == '\\')
            {
              content.append(physical, 0, physical.size() - 1);
              if (lines.peek() != std::istringstream::traits_type::eof())
                {
                  result.emplace_back();
                  continue;
                }
            }
          else
            content += physical;
          content = Utilities::trim(content.substr(0, content.find('#')));

          Line              line;
          const std::size_t end = content.find_first_of(" \t");
          line.section          = section;
          line.keyword          = content.substr(0, end);
          for (char &c : line.keyword)
            c = std::tolower(static_cast<unsigned char>(c));
          if (end != std::string::npos)
            {
              const std::string rest   = content.substr(end);
              const std::size_t equals = rest.find('=');
              line.name = Utilities::trim(rest.substr(0, equals));
              if (equals != std::string::npos)
                line.value = Utilities::trim(rest.substr(equals + 1));
            }
          result.push_back(line);
          content.clear();

          // what stands deeper is refused by check_lines()
          if (line.keyword == "subsection" && ++depth <= max_depth)
            section += line.name.substr(0, 200) + "/";
          else if (line.keyword == "end" && depth > 0 && --depth < max_depth)
            section.erase(section.find_last_of('/', section.size() - 2) + 1);
          result.back().depth = depth;
        }
      return result;
    }


    /** Whether one of the numbers that a text begins with, separated by commas,
     * is larger than any that makes sense. */
    bool
    holds_too_large(const std::string &text)
    {
      std::istringstream stream(text);
      double             number;
      while (stream >> number)
        {
          if (std::abs(number) > greatest_number)
            return true;
          char comma;
          if (!(stream >> comma) || comma != ',')
            return false;
        }
      return false;
    }


    /** Where something stands, as the begin of a sentence. */
    std::string
    place(const std::string &source, const std::string &line)
    {
      // a setting of the command line is one line to its reader
      return source + (source.rfind("--set", 0) == 0 ? "" : ", line " + line) +
             ": ";
    }


    /**
     * Refuse what ParameterHandler would take without a word, and not as meant:
     * two settings of one entry, of which it takes the last; braces, which it
     * takes for a list of alternatives; other files, which every rank would
     * read; numbers that would overflow; sections without end.
     */
    void
    check_lines(const std::string &source, const std::string &text)
    {
      const std::vector<Line>             lines = scan(text);
      std::map<std::string, unsigned int> line_of_entry;
      for (unsigned int number = 1; number < lines.size(); ++number)
        {
          const Line       &line  = lines[number];
          const std::string where = place(source, std::to_string(number));
          const std::string name  = line.section + line.name;
          if (line.keyword == "include")
            throw InputError(where +
                             "a parameter file must not include another one.");
          if (line.depth > max_depth)
            throw InputError(where + "more than " + std::to_string(max_depth) +
                             " sections lie within each other, but no entry "
                             "stands so deep.");
          if (line.keyword != "set")
            continue;
          const auto entry = line_of_entry.emplace(name, number);
          if (!entry.second)
            throw InputError(where + "the entry " + quoted(name) +
                             " is set a second time, but line " +
                             std::to_string(entry.first->second) +
                             " has set it already.");
          if (line.value.find('{') != std::string::npos)
            throw InputError(where + "the entry " + quoted(name) + " is " +
                             quoted(line.value) +
                             ", but a value must not hold a brace.");
          // splitting a list takes time by the square of its length
          if (line.value.size() > 100000)
            throw InputError(where + "the entry " + quoted(name) + " has " +
                             std::to_string(line.value.size()) +
                             " letters, but at most 100000 are allowed.");
          if (holds_too_large(line.value))
            throw InputError(
              where + InputError(name, line.value, number_too_large).what());
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
      if (std::regex_match(
            pattern, match, std::regex("\\[(Multiple)?Selection (.*) \\]")))
        {
          const std::string choices =
            std::regex_replace(match[2].str(), std::regex("\\|"), "', '");
          return (match[1].matched ? "it must be a list of some of '"
                                   : "it must be one of '") +
                 choices + "'";
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
      if (std::regex_match(
            pattern,
            match,
            std::regex("\\[Double ([-+.0-9e]+)\\.\\.\\.MAX_DOUBLE.*\\]")))
        return "it must be a number, " + match[1].str() + " or above";
      if (std::regex_match(pattern, std::regex("\\[Double.*\\]")))
        return "it must be a number";
      if (std::regex_search(pattern, std::regex("^\\[List of <\\[Double")) &&
          std::regex_search(
            pattern, match, std::regex("of length ([0-9]+)\\.\\.\\.\\1 ")))
        return "it must be a list of " + match[1].str() +
               " numbers, separated by commas";
      if (pattern.rfind("[List of <[Anything]> of length 1...", 0) == 0)
        return "it must be a list of at least one name, separated by commas";
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
      // regular expressions recurse: keep them from very long lines
      std::string said = stream.str();
      if (said.size() > 2000)
        said = said.substr(0, 1000) + " ... " + said.substr(said.size() - 900);
      said = Utilities::trim(std::regex_replace(said, std::regex("\\s+"), " "));

      const std::vector<Line> lines = scan(text);
      std::smatch             match;
      const auto              is = [&](const std::string &form) {
        return std::regex_match(said, match, std::regex(form));
      };
      const std::string line  = "Line <([0-9]+)> of file <input string>?: ";
      const auto        where = [&](const std::string &number) {
        return place(source, number);
      };

      if (is(line + "The entry value ?(.*) for the entry named (.*) does not "
                    "match the given pattern: (.*)"))
        {
          const std::string name =
            lines.at(std::stoi(match[1])).section + match[3].str();
          return where(match[1]) +
                 InputError(name, match[2], allowed_by(match[4])).what();
        }
      if (is(line + "No entry with name <(.*)> was declared in the current "
                    "subsection\\.?") ||
          is(line + "There is no such subsection to be entered: (.*)"))
        {
          const std::string name =
            lines.at(std::stoi(match[1])).section + match[2].str();
          return where(match[1]) + "there is no entry " + quoted(name) +
                 "; the nearest name is '" + nearest_name(prm, name) + "'.";
        }
      if (is(line + "The line <(.*)> could not be parsed.*"))
        return where(match[1]) + quoted(match[2].str()) +
               " is none of 'set ENTRY = VALUE', 'subsection NAME', 'end', and "
               "no comment.";
      if (is(line + "Invalid (format|content).*"))
        {
          const Line &found = lines.at(std::stoi(match[1]));
          return where(match[1]) + quoted(found.keyword + " " + found.name) +
                 " is neither 'set ENTRY = VALUE' nor 'end'.";
        }
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
          check_lines(source.first, source.second);
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
