// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <map>
#include <optional>

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
      // values of a map stay where they are when others are added
      return &static_cast<Parser *>(parser)->values[name];
    }

    /** A function, and where the values of its variables are. */
    struct Call
    {
      FormulaFunction             function;
      std::vector<const double *> variables;

      static double
      evaluate(void *call, const double argument)
      {
        const Call         &c = *static_cast<const Call *>(call);
        std::vector<double> values;
        for (const double *variable : c.variables)
          values.push_back(*variable);
        return c.function.value(argument, values);
      }
    };

    /** The function, if the formula calls it. */
    std::optional<Call> call;
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


    /** Whether the text calls a function of the given name. */
    bool
    calls(const std::string &text, const std::string &name)
    {
      for (auto at = text.find(name); at != std::string::npos;
           at      = text.find(name, at + 1))
        {
               const bool is_start =
                 at == 0 ||
                 !(std::isalnum(static_cast<unsigned char>(text[at - 1])) ||
              text[at - 1] == '_');
               const auto next = text.find_first_not_of(" \t", at + name.size());
               if (is_start && next != std::string::npos && text[next] == '(')
            return true;
        }
      return false;
    }


    std::string
    allowed_form(const std::vector<std::string> &variables)
    {
      std::string names;
      for (const std::string &name : variables)
        if (name[0] != '_')
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


  Formula::Formula(const std::string     &entry,
                   const std::string     &text,
                   const FormulaFunction &function)
    : entry(entry), text(text)
  {
    compile(allowed_form({}), &function);
  }


  void
  Formula::compile(const std::string &allowed, const FormulaFunction *function)
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
        if (function != nullptr && calls(text, function->name))
          {
            new_parser->call.emplace(Parser::Call{*function, {}});
            for (const std::string &name : function->variables)
              new_parser->call->variables.push_back(&new_parser->values[name]);
            // not constant, even if its argument is
            p.DefineFunUserData(function->name,
                                &Parser::Call::evaluate,
                                &*new_parser->call,
                                false);
          }
        p.SetExpr(text);
        int n_values = 0;
        p.Eval(n_values);
        // a list of several formulas
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
        for (const auto &value : new_parser->values)
          if (calls(text, value.first))
            reason = quoted(value.first) +
                     " is no function: variables and tables are used by name, "
                     "without arguments";
        throw InputError(entry, text, allowed + " (" + reason + ")");
      }
    parser = new_parser;
  }


  void
  Formula::bind(const std::vector<std::string> &variables)
  {
    const auto is_known = [&](const std::string &name) {
      return std::find(variables.begin(), variables.end(), name) !=
             variables.end();
    };
    if (parser->call)
      {
        const FormulaFunction &function = parser->call->function;
        if (!std::all_of(
              function.variables.begin(), function.variables.end(), is_known))
          throw InputError(entry,
                           text,
                           allowed_form(variables) + " (there is no " +
                             quoted(function.name) + ")");
      }
    for (const auto &value : parser->values)
      if (!is_known(value.first))
        throw InputError(entry,
                         text,
                         allowed_form(variables) + " (there is no " +
                           quoted(value.first) + ")");
    this->variables = variables;
    slots.clear();
    for (const std::string &name : variables)
      {
        // null for a variable that the formula does not use
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
  Formula::unchecked(const std::vector<double> &values) const
  {
    Assert(values.size() == variables.size(),
           dealii::ExcDimensionMismatch(values.size(), variables.size()));
    for (unsigned int i = 0; i < values.size(); ++i)
      if (slots[i] != nullptr)
        *slots[i] = values[i];
    return parser->parser.Eval();
  }


  double
  Formula::operator()(const std::vector<double> &values) const
  {
    const double result = unchecked(values);
    // also what is not a number, which has no order
    if (!(std::abs(result) <= maximum_number))
      {
        // write round-off as 0
        double scale = 0;
        for (const double value : values)
          scale = std::max(scale, std::abs(value));
        std::string where;
        for (unsigned int i = 0; i < variables.size(); ++i)
          // a mesh has no coordinates
          if (variables[i][0] != '_' && !std::isnan(values[i]))
            where += (where.empty() ? "" : ", ") + variables[i] + " = " +
                     coordinate_to_string(values[i], scale);
        throw InputError(
          entry,
          text,
          std::string(std::isfinite(result)
                        ? "its value must lie between -1e100 and 1e100"
                        : "it must be a finite number") +
            (where.empty() ? "" : ", including at " + where));
      }
    return result;
  }


  Formula
  parse_position_formula(const std::string &entry, const std::string &text)
  {
    return Formula(entry, text, {"x", "y", "z", "alpha_1", "alpha_2"});
  }
} // namespace Biface
