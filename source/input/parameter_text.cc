// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/utilities.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <map>
#include <numeric>
#include <regex>
#include <sstream>

#include <biface/base/errors.h>
#include <biface/input/parameter_text.h>
#include <biface/input/parameter_tools.h>

namespace Biface
{
  using namespace dealii;

  namespace
  {
    /** A limit above the section depth of any entry. */
    constexpr unsigned int max_depth = 10;


    /** Whether one of the comma-separated numbers at the start of a text is
     * beyond all reasonable values. */
    bool
    holds_too_large(const std::string &text)
    {
      std::istringstream stream(text);
      double             number;
      while (stream >> number)
        {
          if (std::abs(number) > maximum_number)
            return true;
          char comma;
          if (!(stream >> comma) || comma != ',')
            return false;
        }
      return false;
    }
  } // namespace


  namespace
  {
    /** A line of a file without its comment. */
    struct FileLine
    {
      std::string content;
      /** Whether there is nothing but a comment. */
      bool is_comment = false;
      /** Whether a backslash joins it with the next one. */
      bool goes_on = false;

      explicit FileLine(const std::string &text)
      {
        const auto hash = text.find('#');
        content         = Utilities::trim(text.substr(0, hash));
        is_comment      = (content.empty() && hash != std::string::npos);
        if (!content.empty() && content.back() == '\\')
          {
            content.pop_back();
            goes_on = true;
          }
        else if (!is_comment && hash != std::string::npos &&
                 Utilities::trim(text).back() == '\\')
          {
            content += ' ';
            goes_on = true;
          }
      }

      /** Whether it begins a setting or a section, or ends one. */
      bool
      is_statement() const
      {
        std::istringstream words(content);
        std::string        word;
        words >> word;
        for (char &c : word)
          c = std::tolower(static_cast<unsigned char>(c));
        return (word == "set" && content.find('=') != std::string::npos) ||
               word == "subsection" || (word == "end" && !(words >> word));
      }
    };
  } // namespace


  std::string
  join_lines(const std::string &source, const std::string &text)
  {
    std::vector<std::string> result;
    std::istringstream       lines(text);
    std::string              joined;
    // the last line that goes on; 0 if there is none
    unsigned int before = 0;
    for (std::string physical; std::getline(lines, physical);)
      {
        const FileLine line(physical);
        // empty lines take the place of joined ones, so that messages have the
        // numbers of the lines in the file
        result.emplace_back();
        if (line.is_comment)
          continue;
        if (before > 0 && line.is_statement())
          throw InputError(parameter_place(source, before) +
                           "the backslash at the end of the line joins it "
                           "with " +
                           quoted(line.content) +
                           ", which is not a part of it; delete the "
                           "backslash.");
        const std::string left = Utilities::trim(line.content);
        if (!left.empty() && left.back() == '\\')
          throw InputError(parameter_place(source, result.size()) +
                           "the line ends with two backslashes, of which one "
                           "would join it with the next line; delete one.");
        joined += line.content;
        before = (line.goes_on ? result.size() : 0);
        if (!line.goes_on)
          result.back().swap(joined);
      }
    if (before > 0)
      result.back() = joined;

    std::string all;
    for (const std::string &line : result)
      all += line + '\n';
    return all;
  }


  std::vector<ParameterLine>
  scan_parameter_text(const std::string &text)
  {
    // lines are counted from 1
    std::vector<ParameterLine> result(1);
    std::string                section;
    unsigned int               depth = 0;
    std::istringstream         lines(text);
    for (std::string content; std::getline(lines, content);)
      {
        content = Utilities::trim(content);

        ParameterLine     line;
        const std::size_t end = content.find_first_of(" \t");
        line.section          = section;
        line.keyword          = content.substr(0, end);
        for (char &c : line.keyword)
          c = std::tolower(static_cast<unsigned char>(c));
        if (end != std::string::npos)
          {
            const std::string rest   = content.substr(end);
            const std::size_t equals = rest.find('=');
            line.name                = Utilities::trim(rest.substr(0, equals));
            if (equals != std::string::npos)
              line.value = Utilities::trim(rest.substr(equals + 1));
          }
        result.push_back(line);

        // deeper sections are refused by check_parameter_text()
        if (line.keyword == "subsection" && ++depth <= max_depth)
          section += line.name.substr(0, 200) + "/";
        else if (line.keyword == "end" && depth > 0 && --depth < max_depth)
          section.erase(section.find_last_of('/', section.size() - 2) + 1);
        result.back().depth = depth;
      }
    return result;
  }


  std::string
  parameter_place(const std::string &source, const unsigned int line)
  {
    // an option of the command line has no lines
    const bool is_option = (source.rfind("--", 0) == 0);
    return source + (is_option ? "" : ", line " + std::to_string(line)) + ": ";
  }


  std::string
  parameter_place(const std::string &source,
                  const std::string &text,
                  const std::string &entry)
  {
    const std::vector<ParameterLine> lines = scan_parameter_text(text);
    for (unsigned int number = 1; number < lines.size(); ++number)
      if (lines[number].keyword == "set" &&
          lines[number].section + lines[number].name == entry)
        return parameter_place(source, number);
    return source + ": ";
  }


  void
  check_parameter_text(const std::string &source, const std::string &text)
  {
    const std::vector<ParameterLine>    lines = scan_parameter_text(text);
    std::map<std::string, unsigned int> line_of_entry;
    for (unsigned int number = 1; number < lines.size(); ++number)
      {
        const ParameterLine &line  = lines[number];
        const std::string    where = parameter_place(source, number);
        const std::string    name  = line.section + line.name;
        if (line.keyword == "include")
          throw InputError(where + "'include' is not supported.");
        if (line.depth > max_depth)
          throw InputError(where + "more than " + std::to_string(max_depth) +
                           " nested sections are not allowed.");
        if (line.keyword != "set")
          continue;
        // the last setting would count, without a word
        const auto entry = line_of_entry.emplace(name, number);
        if (!entry.second)
          throw InputError(where + "the entry " + quoted(name) +
                           " is set twice, first in line " +
                           std::to_string(entry.first->second) + ".");
        if (line.value.find('{') != std::string::npos)
          throw InputError(where + "the entry " + quoted(name) + " is " +
                           quoted(line.value) +
                           ", but a value must not contain a brace.");
        if (std::count(line.value.begin(), line.value.end(), '"') == 1 &&
            line.value[0] == '"')
          throw InputError(
            where + InputError(name,
                               line.value,
                               "a value that begins with a quote must end with "
                               "one; '#' begins a comment, also in quotes")
                      .what());
        const char last = line.value.empty() ? ' ' : line.value.back();
        if (last == ',' || last == ';')
          throw InputError(
            where + InputError(name,
                               line.value,
                               std::string("a list must not end with a ") +
                                 (last == ',' ? "comma" : "semicolon"))
                      .what());
        // splitting a list takes quadratic time
        if (line.value.size() > 100000)
          throw InputError(where + "the entry " + quoted(name) + " has " +
                           std::to_string(line.value.size()) +
                           " characters, but at most 100000 are allowed.");
        if (holds_too_large(line.value))
          throw InputError(
            where + InputError(name, line.value, number_too_large).what());
      }
  }


  std::vector<std::string>
  declared_names(const ParameterHandler &prm)
  {
    // deal.II lists the entries in the order of declaration only in print
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
          names.push_back(path +
                          Utilities::trim(line.substr(4, line.find('=') - 4)));
        else if (line == "end")
          path.erase(path.find_last_of('/', path.size() - 2) + 1);
      }
    return names;
  }


  DeclaredEntries::DeclaredEntries(const ParameterHandler &prm) : prm(prm)
  {
    for (const std::string &name : declared_names(prm))
      names.insert(name);
  }


  std::optional<std::string>
  DeclaredEntries::value(const std::string &entry) const
  {
    if (names.count(entry) == 0)
      return {};
    std::vector<std::string> path = Utilities::split_string_list(entry, '/');
    const std::string        name = path.back();
    path.pop_back();
    return prm.get(path, name);
  }


  namespace
  {
    /** Number of single-letter edits between two words. */
    unsigned int
    edit_distance(const std::string &a, const std::string &b)
    {
      // one row of Levenshtein's table at a time
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


    /** The section that holds an entry or a section, with a slash at its end;
     * empty outside of all sections. */
    std::string
    section_of(const std::string &name)
    {
      // a section itself ends with a slash
      return name.substr(0, name.rfind('/', name.size() - 2) + 1);
    }
  } // namespace


  namespace
  {
    /** The entry that has another name in engineering, by words of
     * doc/glossary.md; empty if the word is none of them. */
    std::string
    entry_called(const std::string &word)
    {
      static const std::map<std::string, std::string> glossary{
        {"axle torque", "Axle moment"},
        {"brake torque", "Axle moment"},
        {"camber", "Inclination angle"},
        {"camber angle", "Inclination angle"},
        {"deflection", "Travel"},
        {"drive torque", "Axle moment"},
        {"inflation", "Pressure"},
        {"inflation pressure", "Pressure"},
        {"load", "Force"},
        {"longitudinal slip", "Slip ratio"},
        {"speed", "Ground velocity"},
        {"torque", "Axle moment"},
        {"vertical load", "Force"},
        {"wheel load", "Force"}};

      std::string lower = word;
      std::transform(lower.begin(), lower.end(), lower.begin(), [](char c) {
        return std::tolower(c);
      });
      const auto found = glossary.find(lower);
      return found == glossary.end() ? "" : found->second;
    }


    /** Whether 'Formulation' has taken the place of an entry or a section. */
    bool
    is_part_of_formulation(const std::string &name)
    {
      return name == "Element" || name.rfind("Element/", 0) == 0 ||
             name == "Loads/Area of face loads" || name == "Newton/Iteration";
    }
  } // namespace


  std::string
  no_such_entry(const ParameterHandler &prm, const std::string &name)
  {
    const std::vector<std::string> names   = declared_names(prm);
    const std::string              section = section_of(name);
    const std::string called = entry_called(name.substr(section.size()));
    if (!called.empty() &&
        std::find(names.begin(), names.end(), section + called) != names.end())
      return "there is no entry " + quoted(name) + "; it is called '" +
             section + called + "' here, see doc/glossary.md";
    if (is_part_of_formulation(name))
      return "there is no entry " + quoted(name) +
             "; 'Formulation' chooses the element and what belongs to it";
    const bool is_declared =
      (section.empty() ||
       std::find(names.begin(), names.end(), section) != names.end());
    std::string nearest;
    // a third of the letters may differ
    unsigned int limit =
      (name.size() - (is_declared ? section.size() : 0)) / 3 + 1;
    for (const std::string &other : names)
      {
        if (is_declared && section_of(other) != section)
          continue;
        const bool         is_section = (other.back() == '/');
        const unsigned int distance =
          edit_distance(name, other.substr(0, other.size() - is_section));
        if (distance < limit)
          {
            nearest = other;
            limit   = distance;
          }
      }
    return "there is no entry " + quoted(name) +
           (nearest.empty() ? "" : "; the nearest name is '" + nearest + "'");
  }


  namespace
  {
    /** The values allowed by a deal.II pattern, in words. */
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
      // ranges up to MIN_INT or MAX_INT mean nothing to a user
      if (std::regex_match(pattern, std::regex("\\[Integer.*\\]")))
        return "it must be a whole number";
      if (std::regex_match(pattern, std::regex("\\[Bool\\]")))
        return "it must be 'true' or 'false'";
      if (std::regex_match(
            pattern,
            match,
            std::regex("\\[Double ([-+.0-9e]+)\\.\\.\\.MAX_DOUBLE.*\\]")))
        return "it must be a number, " + match[1].str() + " or more";
      if (std::regex_match(pattern, std::regex("\\[Double.*\\]")))
        return "it must be a number";
      if (std::regex_match(pattern, match, std::regex("\\[Number or (.*)\\]")))
        return "it must be a number or '" + match[1].str() + "'";
      if (std::regex_search(pattern, std::regex("^\\[List of <\\[Double")) &&
          std::regex_search(
            pattern, match, std::regex("of length ([0-9]+)\\.\\.\\.\\1 ")))
        return "it must be a list of " + match[1].str() +
               " numbers, separated by commas";
      if (pattern.rfind("[List of <[Integer", 0) == 0)
        return "it must be a list of whole numbers, separated by commas";
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
    // the messages of deal.II are about its source; what the user needs is the
    // entry, its line and what is allowed
    std::ostringstream stream;
    exception.print_info(stream);
    // regular expressions are recursive: avoid very long lines
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
      return parameter_place(source, std::stoul(number));
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
        return where(match[1]) + no_such_entry(prm, name) + ".";
      }
    if (is(line + "The line <(.*)> could not be parsed.*"))
      return where(match[1]) + quoted(match[2].str()) +
             " is not understood; expected 'set ENTRY = VALUE', 'subsection "
             "NAME', 'end' or a comment.";
    if (is(line + "Invalid (format|content).*"))
      {
        const ParameterLine &found = lines.at(std::stoi(match[1]));
        return where(match[1]) + quoted(found.keyword + " " + found.name) +
               " is not understood; expected 'set ENTRY = VALUE' or 'end'.";
      }
    if (is(line + "(.*)"))
      return where(match[1]) + match[2].str();
    if (is("There are unequal numbers of 'subsection' and 'end'.*"))
      return source +
             ": the numbers of 'subsection' and 'end' differ; each section "
             "needs one 'end'.";
    return source + ": " + said;
  }


  void
  parse_parameter_text(ParameterHandler  &prm,
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
    catch (const InputError &error)
      {
        // the action of an entry knows its name, but not the line
        throw InputError(parameter_place(source, text, error.get_entry()) +
                         error.what());
      }
  }
} // namespace Biface
