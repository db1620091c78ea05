// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_input_formula_h
#define biface_input_formula_h

#include <memory>
#include <string>
#include <vector>

namespace Biface
{
  /** A function of one argument that a formula may call. It may also depend on
   * variables that need not be written; those of functions only start with
   * '_'. */
  struct FormulaFunction
  {
    /** The pointer to a function that computes the value.
     * @param values those of the variables, in their order. */
    using Value = double (*)(const double               argument,
                             const std::vector<double> &values);

    FormulaFunction(const std::string              &name,
                    const std::vector<std::string> &variables,
                    const Value                     value)
      : name(name), variables(variables), value(value)
    {}

    std::string              name;
    std::vector<std::string> variables;
    Value                    value;
  };


  /**
   * A formula of named variables, evaluated by the muParser library, with its
   * operators and functions (`sin`, `sqrt`, `abs`, `min`, ... with angles in
   * radians) and the constant `pi`.
   */
  class Formula
  {
  public:
    /**
     * @param entry the entry of the formula, for error messages.
     * @param text the formula.
     * @param variables names of the variables.
     *
     * Throws InputError if the text is not a single formula of these variables.
     */
    Formula(const std::string              &entry,
            const std::string              &text,
            const std::vector<std::string> &variables);

    /** A formula of variables that are not known yet, see bind(). Throws
     * InputError if the text is not a formula for any variables. */
    Formula(const std::string &entry, const std::string &text);

    /** A formula of variables that are not known yet, which may call
     * @p function. */
    Formula(const std::string     &entry,
            const std::string     &text,
            const FormulaFunction &function);

    /** Set the variables. Throws InputError if the formula uses another
     * name, or a function of another variable. */
    void
    bind(const std::vector<std::string> &variables);

    /** The names that the formula uses, in alphabetical order. */
    std::vector<std::string>
    used_names() const;

    const std::string &
    get_text() const
    {
      return text;
    }

    /**
     * The value of the formula for values of the variables, in their order. The
     * variables must be known.
     *
     * Throws InputError if it is not a finite number.
     */
    double
    operator()(const std::vector<double> &values) const;

    /** The value of the formula for values of the variables, without an
     * exception: it may be infinite or not a number. */
    double
    unchecked(const std::vector<double> &values) const;

  private:
    struct Parser;

    /** Compile the formula.
     * @param allowed the allowed values of the entry, for error messages.
     * @param function one that the formula may call, or null. */
    void
    compile(const std::string     &allowed,
            const FormulaFunction *function = nullptr);

    std::string                   entry;
    std::string                   text;
    std::vector<std::string>      variables;
    std::shared_ptr<const Parser> parser;
    /** The address from which the parser reads each variable; null for unused
     * variables. */
    std::vector<double *> slots;
  };


  /** Parse a formula of the position on the undeformed reference surface, with
   * the variables `x, y, z, alpha_1, alpha_2`, the coordinates in the units of
   * parameter files. Throws InputError like Formula. */
  Formula
  parse_position_formula(const std::string &entry, const std::string &text);
} // namespace Biface

#endif
