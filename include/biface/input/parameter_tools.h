// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_input_parameter_tools_h
#define biface_input_parameter_tools_h

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/tensor.h>

#include <mpi.h>

#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace Biface
{
  /** Throw an InputError that names @p entry unless @p value is a finite
   * number above 0. */
  void
  check_positive(const std::string &entry, const double value);

  /** Throw an InputError that names @p entry unless @p value is a finite
   * number, 0 or above. */
  void
  check_not_negative(const std::string &entry, const double value);

  /** Throw an InputError that names @p entry unless @p value is a finite
   * number other than 0. */
  void
  check_not_zero(const std::string &entry, const double value);

  /** Throw an InputError that names @p entry unless @p value is a finite
   * number. */
  void
  check_finite(const std::string &entry, const double value);

  /** Throw an InputError that names @p entry unless the length of a vector is a
   * finite number. */
  void
  check_finite(const std::string &entry, const dealii::Tensor<1, 3> &vector);

  /** The unit vector along @p vector. Throws an InputError that names
   * @p entry where there is none. */
  dealii::Tensor<1, 3>
  unit_vector(const std::string &entry, const dealii::Tensor<1, 3> &vector);

  /** Throw an InputError that names @p entry, which is the vector @p a, where
   * it is parallel to the vector @p b of the entry @p other. */
  void
  check_not_parallel(const std::string          &entry,
                     const dealii::Tensor<1, 3> &a,
                     const std::string          &other,
                     const dealii::Tensor<1, 3> &b);

  /** A number as a person would write it, with up to ten digits. */
  std::string
  number_to_string(const double value);

  /** A coordinate for a sentence: the same, but 0 where it is only round-off
   * of numbers of the size @p scale. */
  std::string
  coordinate_to_string(const double value, const double scale);

  /** Numbers beyond this size are refused, whatever their unit: products of a
   * few of them would overflow. */
  constexpr double greatest_number = 1e100;

  /** What is said where a number is beyond greatest_number. */
  constexpr const char *number_too_large =
    "a number must lie between -1e100 and 1e100";

  /**
   * Read a whole text as a number. Throws InputError that says "@p entry is
   * @p text, but @p allowed" where it is anything else, or beyond
   * greatest_number.
   */
  double
  parse_number(const std::string &entry,
               const std::string &text,
               const std::string &allowed);

  /** The words of a text. */
  std::vector<std::string>
  split_words(const std::string &text);

  /** Read a text of exactly @p n numbers, separated by blanks; see
   * parse_number(). */
  std::vector<double>
  parse_numbers(const std::string &entry,
                const std::string &text,
                const unsigned int n,
                const std::string &allowed);

  /**
   * Split a list at a separator, but not within parentheses or double quotes.
   * A separator may follow the last item, too; an empty text has no items.
   *
   * Throws InputError where another item is empty, or where there are more than
   * @p limit, before any of them is read: each may cost far more than its text.
   */
  std::vector<std::string>
  split_list(const std::string &entry,
             const std::string &text,
             const char         separator = ',',
             const unsigned int limit     = 10000);

  /** Split "name: rest" at its colon. Throws InputError, as parse_number()
   * does, where there is none or the name is empty. */
  std::pair<std::string, std::string>
  split_named(const std::string &entry,
              const std::string &text,
              const std::string &allowed);

  /** Call a function that may throw InputError on some ranks only, and throw
   * the first of these errors on all ranks. Must be called on all of them. */
  void
  agree_on_errors(const MPI_Comm               communicator,
                  const std::function<void()> &function);

  /** Declare the entry @p name of @p section ("Section/", empty for none),
   * whose text is parsed into @p value when it is read, by `parse(entry, text)`
   * with the full name of the entry. */
  template <typename Value, typename Parse>
  void
  add_parsed(dealii::ParameterHandler &prm,
             const std::string        &section,
             const std::string        &name,
             const std::string        &default_text,
             Value                    &value,
             const Parse              &parse,
             const std::string        &documentation)
  {
    const std::string entry = section + name;
    value                   = parse(entry, default_text);
    prm.declare_entry(
      name, default_text, dealii::Patterns::Anything(), documentation);
    prm.add_action(name, [&value, parse, entry](const std::string &text) {
      value = parse(entry, text);
    });
  }

  /** Declare the entry @p name, whose value is a number, or @p word for none.
   */
  void
  add_optional_number(dealii::ParameterHandler &prm,
                      const std::string        &name,
                      std::optional<double>    &value,
                      const std::string        &word,
                      const std::string        &documentation);

  /** Declare the entry @p name, whose value is one of @p names, and set
   * @p value to the enumerator whose place in @p names the text has. */
  template <typename Enum>
  void
  add_choice(dealii::ParameterHandler       &prm,
             const std::string              &name,
             Enum                           &value,
             const std::vector<std::string> &names,
             const std::string              &documentation)
  {
    std::string selection;
    for (const std::string &n : names)
      selection += (selection.empty() ? "" : "|") + n;
    prm.declare_entry(name,
                      names[static_cast<unsigned int>(value)],
                      dealii::Patterns::Selection(selection),
                      documentation);
    prm.add_action(name, [&value, names](const std::string &text) {
      for (unsigned int i = 0; i < names.size(); ++i)
        if (names[i] == text)
          value = static_cast<Enum>(i);
    });
  }
} // namespace Biface

#endif
