// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>
#include <map>

#include <biface/base/errors.h>
#include <biface/input/formula.h>
#include <biface/input/parameter_tools.h>

#include <muParser.h>

namespace Biface
{
  struct Formula::Parser
  {
    mu::Parser parser;
    /** The values read by the parser, by name. */
    mutable std::map<std::string, double> values;

    static double *
    add_variable(const char *name, void *parser)
    {
      return &static_cast<Parser *>(parser)->values[name];
    }
  };


  namespace
  {
    /** Whether the text contains a single '=', which would assign to a
     * variable. */
    bool
    assigns(const std::string &text)
    {
      for (std::string::size_type i = 0; i < text.size(); ++i)
        if (text[i] == '=')
          {
            if (i + 1 < text.size() && text[i + 1] == '=')
              ++i;
            else if (i == 0 ||
                     std::string("<>!").find(text[i - 1]) == std::string::npos)
              return true;
          }
      return false;
    }
  } // namespace


  namespace
  {
    std::string
    allowed_form(const std::vector<std::string> &variables)
    {
      std::string names;
      for (const std::string &name : variables)
        names += (names.empty() ? "" : ", ") + name;
      return "it must be a number or a formula" +
             (names.empty() ? std::string() : " of " + names);
    }
  } // namespace


  Formula::Formula(const std::string              &entry,
                   const std::string              &text,
                   const std::vector<std::string> &variables)
    : entry(entry), text(text)
  {
    compile(allowed_form(variables));
    bind(variables);
  }


  Formula::Formula(const std::string &entry, const std::string &text)
    : entry(entry), text(text)
  {
    compile(allowed_form({}));
  }


  void
  Formula::compile(const std::string &allowed)
  {
    const auto new_parser = std::make_shared<Parser>();
    if (assigns(text))
      throw InputError(
        entry, text, allowed + " without '=' (to compare, write '==')");
    try
      {
        mu::Parser &p = new_parser->parser;
        p.DefineConst("pi", dealii::numbers::PI);
        p.SetVarFactory(&Parser::add_variable, new_parser.get());
        p.SetExpr(text);
        int n_values = 0;
        p.Eval(n_values);
        if (n_values != 1)
          throw InputError(entry, text, allowed);
      }
    catch (const mu::ParserError &error)
      {
        std::string reason = error.GetMsg();
        while (!reason.empty() && reason.back() == '.')
          reason.pop_back();
        if (reason.size() > 200)
          reason = reason.substr(0, 200) + "...";
        throw InputError(entry, text, allowed + " (" + reason + ")");
      }
    parser = new_parser;
  }


  void
  Formula::bind(const std::vector<std::string> &variables)
  {
    for (const auto &value : parser->values)
      if (std::find(variables.begin(), variables.end(), value.first) ==
          variables.end())
        throw InputError(entry,
                         text,
                         allowed_form(variables) + " (there is no " +
                           quoted(value.first) + ")");
    this->variables = variables;
    slots.clear();
    for (const std::string &name : variables)
      {
        const auto value = parser->values.find(name);
        slots.push_back(value != parser->values.end() ? &value->second
                                                      : nullptr);
      }
  }


  std::vector<std::string>
  Formula::used_names() const
  {
    std::vector<std::string> names;
    for (const auto &value : parser->values)
      names.push_back(value.first);
    return names;
  }


  double
  Formula::operator()(const std::vector<double> &values) const
  {
    Assert(values.size() == variables.size(),
           dealii::ExcDimensionMismatch(values.size(), variables.size()));
    for (unsigned int i = 0; i < values.size(); ++i)
      if (slots[i] != nullptr)
        *slots[i] = values[i];
    const double result = parser->parser.Eval();
    if (!(std::abs(result) <= greatest_number))
      {
        // write round-off as 0
        double scale = 0;
        for (const double value : values)
          scale = std::max(scale, std::abs(value));
        std::string where;
        for (unsigned int i = 0; i < variables.size(); ++i)
          where += (where.empty() ? "" : ", ") + variables[i] + " = " +
                   coordinate_to_string(values[i], scale);
        throw InputError(
          entry,
          text,
          std::string(std::isfinite(result)
                        ? "its value must lie between -1e100 and 1e100"
                        : "it must be a finite number") +
            ", including at " + where);
      }
    return result;
  }


  Formula
  parse_position_formula(const std::string &entry, const std::string &text)
  {
    return Formula(entry, text, {"x", "y", "z", "alpha_1", "alpha_2"});
  }
} // namespace Biface
