// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/utilities.h>

#include <cctype>
#include <cmath>
#include <map>
#include <sstream>

#include <biface/base/errors.h>
#include <biface/input/parameter_text.h>
#include <biface/input/parameter_tools.h>

namespace Biface
{
  using namespace dealii;

  namespace
  {
    /** More levels of sections than any entry has. */
    constexpr unsigned int max_depth = 10;


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
  } // namespace


  std::vector<ParameterLine>
  scan_parameter_text(const std::string &text)
  {
    std::vector<ParameterLine> result(1);
    std::string                section;
    unsigned int               depth = 0;
    std::istringstream         lines(text);
    std::string                physical, content;
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
        content.clear();

        // what stands deeper is refused by check_parameter_text()
        if (line.keyword == "subsection" && ++depth <= max_depth)
          section += line.name.substr(0, 200) + "/";
        else if (line.keyword == "end" && depth > 0 && --depth < max_depth)
          section.erase(section.find_last_of('/', section.size() - 2) + 1);
        result.back().depth = depth;
      }
    return result;
  }


  std::string
  parameter_place(const std::string &source, const std::string &line)
  {
    // a setting of the command line is one line to its reader
    return source + (source.rfind("--set", 0) == 0 ? "" : ", line " + line) +
           ": ";
  }


  void
  check_parameter_text(const std::string &source, const std::string &text)
  {
    const std::vector<ParameterLine>    lines = scan_parameter_text(text);
    std::map<std::string, unsigned int> line_of_entry;
    for (unsigned int number = 1; number < lines.size(); ++number)
      {
        const ParameterLine &line = lines[number];
        const std::string    where =
          parameter_place(source, std::to_string(number));
        const std::string name = line.section + line.name;
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
} // namespace Biface
