// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/utilities.h>

#include <algorithm>
#include <cctype>
#include <numeric>
#include <regex>
#include <sstream>

#include <biface/base/errors.h>
#include <biface/input/parameter_sentence.h>
#include <biface/input/parameter_text.h>

namespace Biface
{
  using namespace dealii;

  namespace
  {
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
  } // namespace


  std::string
  parameter_sentence(const ExceptionBase    &exception,
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

    const std::vector<ParameterLine> lines = scan_parameter_text(text);
    std::smatch                      match;
    const auto                       is = [&](const std::string &form) {
      return std::regex_match(said, match, std::regex(form));
    };
    const std::string line  = "Line <([0-9]+)> of file <input string>?: ";
    const auto        where = [&](const std::string &number) {
      return parameter_place(source, number);
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
        const ParameterLine &found = lines.at(std::stoi(match[1]));
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
} // namespace Biface
