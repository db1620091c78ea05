// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_input_formula_h
#define biface_input_formula_h

#include <memory>
#include <string>
#include <vector>

namespace Biface
{
  /**
   * A formula of named variables, read by the muParser library: its operators
   * and functions (`sin`, `sqrt`, `abs`, `min`, ... with angles in radians),
   * and the constant `pi`.
   */
  class Formula
  {
  public:
    /**
     * @param entry the entry that holds the formula, for error messages.
     * @param text the formula.
     * @param variables names of the variables.
     *
     * Throws InputError where the text is not one formula of these variables.
     */
    Formula(const std::string              &entry,
            const std::string              &text,
            const std::vector<std::string> &variables);

    /** The same with names that are not known yet; see bind(). Throws
     * InputError where the text is no formula whatever names there are. */
    Formula(const std::string &entry, const std::string &text);

    /** Say which variables there are. Throws InputError where the formula needs
     * another one. */
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
     * The value for values of the variables, in their order. Names must be
     * known.
     *
     * Throws InputError where it is not a finite number.
     */
    double
    operator()(const std::vector<double> &values) const;

  private:
    struct Parser;

    /** @param allowed what the entry must be, for error messages. */
    void
    compile(const std::string &allowed);

    std::string                   entry;
    std::string                   text;
    std::vector<std::string>      variables;
    std::shared_ptr<const Parser> parser;
    /** Where the parser reads each of the variables; null for those that the
     * formula does not use. */
    std::vector<double *> slots;
  };
} // namespace Biface

#endif
