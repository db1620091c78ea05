// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_problem_design_variable_h
#define biface_problem_design_variable_h

#include <string>
#include <vector>

#include <biface/input/parameter_text.h>

namespace Biface
{
  struct Override;


  /**
   * A design variable: one or several numbers of a parameter file that vary
   * together. It is described by the text
   * @code
   *   name: Section/Entry[k], -Section/Entry[k], ...
   *   name: factor of Section/Entry[k], ...
   * @endcode
   * where `[k]` is the k-th number in the value of the entry, from 1; it is
   * only needed if there are several. The numbers in
   * `cord: 1.2 @ 52, cord: 1.2 @ -52` are 1.2, 52, 1.2, -52: names that contain
   * digits, such as `alpha_1` or `cord2`, and texts in quotes are not counted.
   * A sign belongs to a number unless it is an operator of a formula, or part
   * of the `+-` or `-+` before the angle of two plies.
   *
   * The value of the variable is that of each of its numbers, with the opposite
   * sign after a minus, as for the angles of a bias tire. The value of a
   * `factor` multiplies the numbers in the file.
   *
   * Without a name, a single entry stands for itself.
   */
  class DesignVariable
  {
  public:
    /** Parse the text of a design variable. Throws InputError if it is not one.
     * @param entry the entry that contains the text, for error messages. */
    DesignVariable(const std::string &entry, const std::string &text);

    const std::string &
    get_name() const
    {
      return name;
    }

    /** The names of the entries whose numbers vary. */
    std::vector<std::string>
    get_entries() const;

    /** Check that the numbers exist in a parameter file. Throws InputError. */
    void
    check(const DeclaredEntries &declared) const;

    /** The value of the variable in a parameter file; 1 for a factor. Throws
     * InputError if there is no such number, or if its numbers differ.
     * @param declared the entries of the file and their values. */
    double
    value(const DeclaredEntries &declared) const;

  private:
    /** A number in the value of an entry. */
    struct Number
    {
      std::string entry;
      /** The position in the value, from 1; 0 if it is the only number. */
      unsigned int position = 0;
      /** Whether the number has the opposite sign of the variable. */
      bool negative = false;
    };

    /** Parse the description of the k-th number of a value. Throws
     * InputError. */
    Number
    parse_number_name(const std::string &item) const;

    /** The position of a number, from 1. Throws InputError if it does not
     * exist. */
    unsigned int
    find(const Number &number, const DeclaredEntries &declared) const;

    /** The entry that contains the text, and the text, for error messages. */
    std::string where;
    std::string text;

    std::string         name;
    bool                factor = false;
    std::vector<Number> numbers;

    friend std::vector<Override>
    settings(const std::vector<DesignVariable> &variables,
             const std::vector<double>         &values,
             const DeclaredEntries             &declared,
             const std::string                 &source);
  };


  /** The shortest text from which the same number is read. */
  std::string
  exact_number(const double value);

  /** A list of design variables, separated by semicolons. Throws InputError if
   * it is anything else, or if two of them have the same name. */
  std::vector<DesignVariable>
  parse_design_variables(const std::string &entry, const std::string &text);

  /**
   * The settings that give design variables their values, one for each changed
   * entry of a parameter file: what `--set` would contain. They precede all
   * others in read_parameters().
   *
   * Throws InputError if a number does not exist, or if two variables set the
   * same one. Factors multiply what other variables have set.
   *
   * @param values one for each variable.
   * @param declared the entries of the file and their values.
   * @param source the name of the settings in error messages, see Override.
   */
  std::vector<Override>
  settings(const std::vector<DesignVariable> &variables,
           const std::vector<double>         &values,
           const DeclaredEntries             &declared,
           const std::string                 &source);
} // namespace Biface

#endif
