// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/utilities.h>

#include <algorithm>
#include <filesystem>
#include <numeric>
#include <random>

#include <biface/base/errors.h>
#include <biface/input/entry_declarations.h>
#include <biface/input/parameter_tools.h>
#include <biface/solver/linear/eigenpairs.h>
#include <biface/study/sampling.h>

namespace Biface
{
  using namespace dealii;

  namespace
  {
    constexpr unsigned int max_samples = 100000;

    constexpr const char *values_form =
      "it must be a list of 'variable: values', separated by semicolons, with "
      "values 'a, b, c' or 'begin:end:number', or 'begin:end' for a Latin "
      "hypercube";


    std::vector<Sampling::Values>
    parse_samples(const std::string &entry, const std::string &text)
    {
      std::vector<Sampling::Values> result;
      for (const std::string &part : split_list(entry, text, ';', 1000))
        {
          const auto       named = split_named(entry, part, values_form);
          Sampling::Values values;
          values.variable = named.first;
          for (const Sampling::Values &other : result)
            if (other.variable == values.variable)
              throw InputError(entry,
                               text,
                               "the values of " +
                                 Biface::quoted(values.variable) +
                                 " are given twice");
          const auto range = Utilities::split_string_list(named.second, ':');
          values.is_range =
            range.size() == 2 && named.second.find(',') == std::string::npos;
          if (values.is_range)
            for (const std::string &end : range)
              values.values.push_back(parse_number(entry, end, values_form));
          else
            values.values =
              parse_values(entry, named.second, values_form, max_samples);
          if (values.values.empty())
            throw InputError(entry, text, values_form);
          result.push_back(values);
        }
      return result;
    }


    /** Random numbers that are the same on all machines. */
    class Random
    {
    public:
      explicit Random(const unsigned int seed) : generator(seed)
      {}

      /** At least 0 and less than 1. */
      double
      operator()()
      {
        // as many bits as a double has
        return (generator() >> 11) * 0x1p-53;
      }

    private:
      std::mt19937_64 generator;
    };
  } // namespace


  void
  Sampling::add_parameters(EntryDeclarations &prm)
  {
    // values refer to variables by name, so that the order of the entries does
    // not matter
    add_parsed(
      prm,
      "Variables",
      "",
      variables,
      parse_design_variables,
      "What varies: a list of design variables, separated by semicolons. Each "
      "is 'name: Section/Entry[k], -Section/Entry[k], ...' for one or several "
      "numbers of the parameter file that have its value, with the opposite "
      "sign after a minus, or 'name: factor of Section/Entry[k], ...' for "
      "numbers that it multiplies. [k] is the k-th number in the value of the "
      "entry, from 1, and is only needed if there are several. The name may be "
      "omitted for a single number.");
    add_choice(prm,
               "Sampling",
               type,
               {"grid", "list", "Latin hypercube", "file"},
               "The samples. 'grid': every combination of the values of the "
               "variables. 'list': the first values of all variables, the "
               "second ones, and so on. 'Latin hypercube': random samples that "
               "fill the ranges of the variables evenly. 'file': those of "
               "'Samples file'.");
    add_parsed(prm,
               "Values",
               "",
               values,
               parse_samples,
               "The values of the variables: a list of 'name: values', "
               "separated by semicolons. Values are 'a, b, c', or "
               "'begin:end:number' for equal intervals, ends included; for a "
               "Latin hypercube, 'begin:end'. Units are those of the entries.");
    prm.add_parameter("Number of samples",
                      n_samples,
                      "Number of samples of a Latin hypercube.",
                      Patterns::Integer(1, max_samples));
    prm.add_parameter("Seed",
                      seed,
                      "Seed of the random numbers of a Latin hypercube: the "
                      "same seed gives the same samples.",
                      Patterns::Integer(0));
    add_parsed(prm,
               "Samples file",
               "",
               file_name,
               parse_file_name,
               "CSV file of samples: a line of the names of the variables, and "
               "a line of their values for each sample. Relative to the "
               "folder of the study file.");
  }


  const Sampling::Values &
  Sampling::values_of(const DesignVariable &variable) const
  {
    const auto found =
      std::find_if(values.begin(), values.end(), [&](const Values &v) {
        return v.variable == variable.get_name();
      });
    if (found == values.end())
      throw InputError(
        "the entry 'Study/Values' has no values of the variable " +
        Biface::quoted(variable.get_name()) + ".");
    const bool wants_range = (type == Type::latin_hypercube);
    if (found->is_range != wants_range)
      throw InputError(
        "the entry 'Study/Values' gives the variable " +
        Biface::quoted(variable.get_name()) +
        (wants_range ? " a list, but a Latin hypercube needs a range "
                       "'begin:end'."
                     : " a range, but a " +
                         std::string(type == Type::grid ? "grid" : "list") +
                         " needs values 'a, b, c' or "
                         "'begin:end:number'."));
    return *found;
  }


  std::vector<std::vector<double>>
  Sampling::samples(const std::string &folder,
                    const MPI_Comm     communicator) const
  {
    if (variables.empty())
      throw InputError(
        "Study/Variables", "", "there must be at least one variable");
    for (const Values &given : values)
      if (std::none_of(variables.begin(), variables.end(), [&](const auto &v) {
            return v.get_name() == given.variable;
          }))
        throw InputError("the entry 'Study/Values' has values of " +
                         Biface::quoted(given.variable) +
                         ", but 'Study/Variables' has no such variable.");
    if (type == Type::file)
      return read_samples(folder, communicator);

    const unsigned int               m = variables.size();
    std::vector<std::vector<double>> result;
    if (type == Type::latin_hypercube)
      {
        result.resize(n_samples, std::vector<double>(m));
        Random random(seed);
        for (unsigned int j = 0; j < m; ++j)
          {
            const std::vector<double> &range = values_of(variables[j]).values;
            std::vector<unsigned int>  parts(n_samples);
            std::iota(parts.begin(), parts.end(), 0);
            // std::shuffle() depends on the library
            for (unsigned int i = n_samples; i > 1; --i)
              std::swap(parts[i - 1],
                        parts[static_cast<unsigned int>(random() * i)]);
            for (unsigned int i = 0; i < n_samples; ++i)
              result[i][j] = range[0] + (range[1] - range[0]) *
                                          (parts[i] + random()) / n_samples;
          }
        return result;
      }

    if (type == Type::list)
      {
        const std::size_t n = values_of(variables[0]).values.size();
        result.resize(n, std::vector<double>(m));
        for (unsigned int j = 0; j < m; ++j)
          {
            const std::vector<double> &given = values_of(variables[j]).values;
            if (given.size() != n)
              throw InputError("the entry 'Study/Values' has " +
                               std::to_string(n) + " values of " +
                               Biface::quoted(variables[0].get_name()) +
                               " and " + std::to_string(given.size()) + " of " +
                               Biface::quoted(variables[j].get_name()) +
                               ", but a list needs as many for each variable.");
            for (std::size_t i = 0; i < n; ++i)
              result[i][j] = given[i];
          }
        return result;
      }

    // a real number, since the product may exceed an integer
    double n = 1;
    for (const DesignVariable &variable : variables)
      n *= values_of(variable).values.size();
    if (n > max_samples)
      throw InputError("the grid of 'Study/Values' has " + number_to_string(n) +
                       " samples, but at most " + std::to_string(max_samples) +
                       " are allowed.");
    result.resize(n, std::vector<double>(m));
    for (std::size_t i = 0; i < result.size(); ++i)
      {
        // the last variable varies fastest
        std::size_t rest = i;
        for (unsigned int j = m; j-- > 0;)
          {
            const std::vector<double> &given = values_of(variables[j]).values;
            result[i][j]                     = given[rest % given.size()];
            rest /= given.size();
          }
      }
    return result;
  }


  std::vector<unsigned int>
  Sampling::columns_of(const NumberedLine &line) const
  {
    // the separator with which the names are those of all variables
    for (const char separator : {',', ';', '\t'})
      {
        const std::vector<std::string> cells =
          split_cells(line.text, separator);
        std::vector<unsigned int> columns;
        for (const DesignVariable &variable : variables)
          {
            const auto found =
              std::find(cells.begin(), cells.end(), variable.get_name());
            if (found != cells.end())
              columns.push_back(found - cells.begin());
          }
        if (columns.size() == variables.size() &&
            cells.size() == variables.size())
          return columns;
      }
    throw InputError(line.place,
                     line.text,
                     "the first line must contain the names of the variables "
                     "and nothing else, such as " +
                       Biface::quoted(variables.front().get_name()));
  }


  std::vector<std::vector<double>>
  Sampling::read_samples(const std::string &folder,
                         const MPI_Comm     communicator) const
  {
    if (file_name.empty())
      throw InputError(
        "Study/Samples file", "", "'Sampling = file' needs the name of a file");
    const std::string path =
      (std::filesystem::path(folder) / file_name).lexically_normal().string();
    const unsigned int n = variables.size();
    const CsvRowForm   form{
      "it must contain " + std::to_string(n) + " numbers", n, n};
    std::vector<NumberedLine> lines =
      lines_of_csv(read_file(path, communicator), path, form.text());
    std::vector<std::vector<double>> result;
    if (!lines.empty())
      {
        // the names of the columns, whose order is up to the file
        const std::vector<unsigned int> columns = columns_of(lines.front());
        lines.erase(lines.begin());
        if (lines.size() > max_samples)
          throw InputError("the file " + Biface::quoted(path) +
                           " has more than " + std::to_string(max_samples) +
                           " samples.");
        for (const std::vector<double> &row : parse_rows(lines, form))
          {
            std::vector<double> sample;
            for (const unsigned int column : columns)
              sample.push_back(row[column]);
            result.push_back(sample);
          }
      }
    if (result.empty())
      throw InputError("the file " + Biface::quoted(path) +
                       " contains no samples, but there must be at least "
                       "one.");
    return result;
  }
} // namespace Biface
