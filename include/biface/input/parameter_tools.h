// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_input_parameter_tools_h
#define biface_input_parameter_tools_h

#include <deal.II/base/tensor.h>

#include <mpi.h>

#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <biface/input/entry_declarations.h>

namespace Biface
{
  /** Throw an InputError that names @p entry unless @p value is a finite
   * number above 0. */
  void
  check_positive(const std::string &entry, const double value);

  /** Throw an InputError that names @p entry unless @p value is a finite
   * number that is not negative. */
  void
  check_not_negative(const std::string &entry, const double value);

  /** Throw an InputError that names @p entry unless @p value is a number not
   * less than @p minimum. */
  void
  check_at_least(const std::string &entry,
                 const double       value,
                 const double       minimum);

  /** Throw an InputError that names @p entry unless @p value is a number not
   * greater than @p maximum. */
  void
  check_at_most(const std::string &entry,
                const double       value,
                const double       maximum);

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

  /** The unit vector along @p vector. Throws an InputError that names @p entry
   * if there is none. */
  dealii::Tensor<1, 3>
  unit_vector(const std::string &entry, const dealii::Tensor<1, 3> &vector);

  /** Throw an InputError that names @p entry, the vector @p a, if it is
   * parallel to the vector @p b of the entry @p other. */
  void
  check_not_parallel(const std::string          &entry,
                     const dealii::Tensor<1, 3> &a,
                     const std::string          &other,
                     const dealii::Tensor<1, 3> &b);

  /** A number with up to ten digits, without trailing zeros. */
  std::string
  number_to_string(const double value);

  /** The components of a vector in the form of parameter files. */
  std::string
  vector_to_string(const dealii::Tensor<1, 3> &vector);

  /** A coordinate in a message, like number_to_string(), but 0 if it is only
   * round-off of numbers of size @p scale. */
  std::string
  coordinate_to_string(const double value, const double scale);

  /** The limit beyond which numbers are refused, whatever their unit: products
   * of a few of them would overflow. */
  constexpr double maximum_number = 1e100;

  /** The message on numbers beyond maximum_number. */
  constexpr const char *number_too_large =
    "a number must lie between -1e100 and 1e100";

  /**
   * Read a text as a number. Throws InputError "@p entry is @p text, but
   * @p allowed" if it is anything else, or beyond maximum_number.
   */
  double
  parse_number(const std::string &entry,
               const std::string &text,
               const std::string &allowed);

  /** Read a list 'a, b, c' of numbers, in which 'begin:end:number' stands for
   * so many equidistant ones; see parse_number(). Throws InputError also if
   * there are more than @p limit. */
  std::vector<double>
  parse_values(const std::string &entry,
               const std::string &text,
               const std::string &allowed,
               const unsigned int limit);

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
   * Split a list at a separator, except within parentheses or double quotes.
   * An empty text has no items.
   *
   * Throws InputError if an item is empty, or if there are more than
   * @p limit items. This is checked before any of them is read, since reading
   * may cost far more than the text.
   */
  std::vector<std::string>
  split_list(const std::string &entry,
             const std::string &text,
             const char         separator = ',',
             const unsigned int limit     = 10000);

  /** Split "name: rest" at its colon. Throws InputError, like parse_number(),
   * if there is none or the name is empty. */
  std::pair<std::string, std::string>
  split_named(const std::string &entry,
              const std::string &text,
              const std::string &allowed);

  /** Split a list of "name: rest" with different names, whose words are
   * separated by single blanks in the result. Throws InputError, like
   * split_named(), also if nothing follows a colon. */
  std::vector<std::pair<std::string, std::string>>
  split_named_list(const std::string &entry,
                   const std::string &text,
                   const std::string &allowed);

  /** A text with '_' in place of blanks, for names of files and columns. */
  std::string
  with_underscores(const std::string &text);

  /** Call a function that may throw InputError on some ranks only, and throw
   * the first of these errors on all ranks. Must be called on all ranks. */
  void
  agree_on_errors(const MPI_Comm               communicator,
                  const std::function<void()> &function);

  /** Declare the entry @p name, whose text is parsed into @p value when it is
   * read, by `parse(entry, text)` with the full name of the entry. */
  template <typename Value, typename Parse>
  void
  add_parsed(EntryDeclarations     &prm,
             const std::string     &name,
             const std::string     &default_text,
             Value                 &value,
             const Parse           &parse,
             const std::string     &documentation,
             const EntryAttributes &attributes = {})
  {
    const std::string entry = prm.full_name(name);
    value                   = parse(entry, default_text);
    prm.declare_entry(name,
                      default_text,
                      dealii::Patterns::Anything(),
                      documentation,
                      attributes);
    prm.add_action(name, [&value, parse, entry](const std::string &text) {
      value = parse(entry, text);
    });
  }

  /** Declare the entry @p name, whose value is a number, or @p word for none.
   * @param attributes include the unit of the number. */
  void
  add_optional_number(EntryDeclarations     &prm,
                      const std::string     &name,
                      std::optional<double> &value,
                      const std::string     &word,
                      const std::string     &documentation,
                      const EntryAttributes &attributes);

  /** Declare the entry @p name, whose value is a vector of three components,
   * separated by commas, or @p word for none.
   * @param attributes include the unit of the components. */
  void
  add_optional_vector(EntryDeclarations                   &prm,
                      const std::string                   &name,
                      std::optional<dealii::Tensor<1, 3>> &value,
                      const std::string                   &word,
                      const std::string                   &documentation,
                      const EntryAttributes               &attributes);

  /** Declare the entry @p name, whose value is one of @p names, and set
   * @p value to the enumerator at the position of the text in @p names. */
  template <typename Enum>
  void
  add_choice(EntryDeclarations              &prm,
             const std::string              &name,
             Enum                           &value,
             const std::vector<std::string> &names,
             const std::string              &documentation,
             const EntryAttributes          &attributes = {})
  {
    std::string selection;
    for (const std::string &n : names)
      selection += (selection.empty() ? "" : "|") + n;
    prm.declare_entry(name,
                      names[static_cast<unsigned int>(value)],
                      dealii::Patterns::Selection(selection),
                      documentation,
                      attributes);
    prm.add_action(name, [&value, names](const std::string &text) {
      for (unsigned int i = 0; i < names.size(); ++i)
        if (names[i] == text)
          value = static_cast<Enum>(i);
    });
  }
} // namespace Biface

#endif
