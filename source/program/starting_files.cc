// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/mpi.h>
#include <deal.II/base/utilities.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <regex>
#include <sstream>

#include <biface/base/errors.h>
#include <biface/input/formula.h>
#include <biface/input/parameter_tools.h>
#include <biface/output/csv.h>
#include <biface/problem/design_variable.h>
#include <biface/program/starting_files.h>

namespace Biface
{
  using namespace dealii;

  namespace
  {
    const std::string folder = "templates/", ending = ".prm";


    bool
    is_template(const ShippedFile &file)
    {
      return file.name.rfind(folder, 0) == 0;
    }


    bool
    is_parameter_file(const ShippedFile &file)
    {
      return file.name.size() > ending.size() &&
             file.name.substr(file.name.size() - ending.size()) == ending;
    }


    /** The name without folder and ending. */
    std::string
    short_name(const ShippedFile &file)
    {
      return std::filesystem::path(file.name).stem().string();
    }


    /** A parameter file by its name. */
    const ShippedFile &
    find(const std::string &option,
         const std::string &name,
         const bool         templates)
    {
      std::string names, similar;
      for (const ShippedFile &file : shipped_files())
        if (is_parameter_file(file) && is_template(file) == templates)
          {
            if (name == file.name || name == short_name(file) ||
                name == short_name(file) + ending)
              return file;
            names += (names.empty() ? "" : ", ") + short_name(file);
            if (short_name(file).find(name) != std::string::npos)
              similar +=
                (similar.empty() ? "'" : ", '") + short_name(file) + "'";
          }
      if (!name.empty() && !similar.empty())
        throw InputError("the option '" + option + "' names '" + name +
                         "', but there is only " + similar + ".");
      throw InputError("the option '" + option + "' names '" + name +
                       "', but there are only: " + names + ".");
    }


    /** A parameter file with other text, and the files that it reads. */
    std::vector<ShippedFile>
    with_files(const ShippedFile &file, const std::string &text)
    {
      const auto base_name = [](const ShippedFile &file) {
        return std::filesystem::path(file.name).filename().string();
      };
      std::vector<ShippedFile> files{{base_name(file), text}};
      for (const ShippedFile &other : shipped_files())
        // the example runs where it is written only with the files that it
        // names
        if (std::regex_search(
              text,
              std::regex(
                (is_parameter_file(other) ? "set Base file *= *" : "[ =,:]") +
                base_name(other))))
          files.push_back({base_name(other), other.text});
      return files;
    }


    /** The first sentence of the comment at the top, in one line. */
    std::string
    first_sentence(const std::string &text)
    {
      std::istringstream lines(text);
      std::string        line, sentence;
      while (std::getline(lines, line) && line.rfind("# ", 0) == 0)
        {
          sentence += line.substr(2) + ' ';
          // not the point of a file name
          const auto end = std::min(sentence.find(". "), sentence.find(": "));
          if (end != std::string::npos)
            return sentence.substr(0, end);
        }
      return sentence;
    }


    /** A size of a template. */
    struct Size
    {
      std::string name, value;
    };

    const std::regex size_line("# size (\\w+) *= *([^:]+): *(.*)");
    const std::regex with_line("# with (\\w+) *= *(.+)");


    std::vector<std::string>
    split_into_lines(const std::string &text)
    {
      std::istringstream       stream(text);
      std::vector<std::string> lines;
      for (std::string line; std::getline(stream, line);)
        lines.push_back(line);
      return lines;
    }


    std::vector<Size>
    sizes_of(const std::string &text)
    {
      std::vector<Size> sizes;
      std::smatch       match;
      for (const std::string &line : split_into_lines(text))
        if (std::regex_match(line, match, size_line))
          sizes.push_back({match[1], Utilities::trim(match[2])});
      return sizes;
    }


    /** The names and values of sizes and of what follows from them. */
    class Values
    {
    public:
      void
      add(const std::string &name, const std::string &formula)
      {
        const double value = evaluate(formula);
        names.push_back(name);
        values.push_back(value);
      }

      double
      evaluate(const std::string &formula) const
      {
        const double value =
          Formula("--template", formula, names).unchecked(values);
        if (!std::isfinite(value))
          throw InputError("the sizes of the template do not fit together: '" +
                           formula + "' has no value.");
        return value;
      }

    private:
      std::vector<std::string> names;
      std::vector<double>      values;
    };


    std::string
    contents_of(const std::string &path)
    {
      std::ifstream      file(path, std::ios::binary);
      std::ostringstream text;
      text << file.rdbuf();
      return text.str();
    }


    /** In a comment, few digits are enough. */
    std::string
    rounded(const double value)
    {
      char text[32];
      std::snprintf(text, sizeof(text), "%.6g", value);
      return text;
    }
  } // namespace


  std::string
  list_of_starting_files()
  {
    std::ostringstream list;
    list << "Examples, for 'biface --example NAME':\n";
    for (const ShippedFile &file : shipped_files())
      if (is_parameter_file(file) && !is_template(file))
        list << "  " << short_name(file) << ": " << first_sentence(file.text)
             << '\n';
    list << "Templates, for 'biface --template NAME --set \"SIZE=value\"':\n";
    for (const ShippedFile &file : shipped_files())
      if (is_parameter_file(file) && is_template(file))
        {
          list << "  " << short_name(file) << ": " << first_sentence(file.text)
               << " (";
          bool is_first = true;
          for (const Size &size : sizes_of(file.text))
            {
              list << (is_first ? "" : ", ") << size.name << '=' << size.value;
              is_first = false;
            }
          list << ")\n";
        }
    return list.str();
  }


  std::vector<ShippedFile>
  example_files(const std::string &name)
  {
    const ShippedFile &file = find("--example", name, false);
    return with_files(file, file.text);
  }


  std::vector<ShippedFile>
  template_files(const std::string &name, const std::vector<Override> &settings)
  {
    const ShippedFile &file  = find("--template", name, true);
    std::vector<Size>  sizes = sizes_of(file.text);
    for (const Override &setting : settings)
      {
        const auto  equals = setting.setting.find('=');
        std::string names;
        bool        found = false;
        for (Size &size : sizes)
          {
            names += (names.empty() ? "" : ", ") + size.name;
            if (equals == std::string::npos ||
                Utilities::trim(setting.setting.substr(0, equals)) != size.name)
              continue;
            size.value = Utilities::trim(setting.setting.substr(equals + 1));
            // a formula of no variables
            if (!std::isfinite(
                  Formula(size.name, size.value, {}).unchecked({})))
              throw InputError(size.name, size.value, "it must be a number");
            found = true;
          }
        if (!found)
          throw InputError("the setting '" + setting.setting +
                           "' is not a size of the template '" + name +
                           "', which has: " + names + ".");
      }

    Values values;
    for (const Size &size : sizes)
      values.add(size.name, size.value);
    std::string      text;
    std::smatch      match;
    const std::regex braces("\\{([^}]*)\\}");
    for (std::string line : split_into_lines(file.text))
      {
        if (std::regex_match(line, match, with_line))
          {
            values.add(match[1], match[2]);
            continue;
          }
        if (std::regex_match(line, match, size_line))
          line = "# " + std::string(match[1]) + " = " +
                 exact_number(values.evaluate(match[1])) + ": " +
                 std::string(match[3]);
        // only the values are replaced: the rest of the template, comments
        // included, is the file
        while (std::regex_search(line, match, braces))
          {
            const double      number = values.evaluate(match[1]);
            const std::string value =
              (line[0] == '#' ? rounded(number) : exact_number(number));
            line =
              std::string(match.prefix()) + value + std::string(match.suffix());
          }
        text += line + '\n';
      }
    return with_files(file, text);
  }


  void
  write_starting_files(const std::vector<ShippedFile> &files,
                       const MPI_Comm                  communicator)
  {
    // all files or none; those that are there already with the same text do no
    // harm
    std::string existing;
    if (Utilities::MPI::this_mpi_process(communicator) == 0)
      for (const ShippedFile &file : files)
        if (std::filesystem::exists(file.name) &&
            contents_of(file.name) != file.text)
          existing = file.name;
    existing = Utilities::MPI::broadcast(communicator, existing);
    if (!existing.empty())
      throw InputError("the file '" + existing +
                       "' exists already with other contents; move it, or "
                       "go to another directory.");
    for (const ShippedFile &file : files)
      write_text(file.name, file.text, false, communicator);
  }
} // namespace Biface
