// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/mpi.h>
#include <deal.II/base/utilities.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <iterator>
#include <memory>
#include <sstream>

#include <biface/base/errors.h>
#include <biface/input/parameter_tools.h>

namespace Biface
{
  void
  check_positive(const std::string &entry, const double value)
  {
    if (!(std::isfinite(value) && value > 0))
      throw InputError(
        entry, number_to_string(value), "it must be a positive number");
  }


  void
  check_not_negative(const std::string &entry, const double value)
  {
    if (!(std::isfinite(value) && value >= 0))
      throw InputError(
        entry, number_to_string(value), "it must be a number not less than 0");
  }


  void
  check_at_least(const std::string &entry,
                 const double       value,
                 const double       minimum)
  {
    // also refuses what is not a number
    if (!(value >= minimum))
      throw InputError(entry,
                       number_to_string(value),
                       "it must be at least " + number_to_string(minimum));
  }


  void
  check_at_most(const std::string &entry,
                const double       value,
                const double       maximum)
  {
    if (!(value <= maximum))
      throw InputError(entry,
                       number_to_string(value),
                       "it must be at most " + number_to_string(maximum));
  }


  void
  check_not_zero(const std::string &entry, const double value)
  {
    if (!(std::isfinite(value) && value != 0))
      throw InputError(
        entry, number_to_string(value), "it must be a number other than 0");
  }


  void
  check_finite(const std::string &entry, const dealii::Tensor<1, 3> &vector)
  {
    if (!std::isfinite(vector.norm()))
      throw InputError(
        entry, vector_to_string(vector), "its length must be a finite number");
  }


  dealii::Tensor<1, 3>
  unit_vector(const std::string &entry, const dealii::Tensor<1, 3> &vector)
  {
    if (!(std::isfinite(vector.norm()) && vector.norm() > 0))
      throw InputError(entry,
                       vector_to_string(vector),
                       "a direction must be finite and not the zero vector");
    return vector / vector.norm();
  }


  void
  check_not_parallel(const std::string          &entry,
                     const dealii::Tensor<1, 3> &a,
                     const std::string          &other,
                     const dealii::Tensor<1, 3> &b)
  {
    if (dealii::cross_product_3d(a, b).norm() < 1e-6 * a.norm() * b.norm())
      throw InputError(entry,
                       vector_to_string(a),
                       "it must not be parallel to '" + other + "'");
  }


  void
  check_finite(const std::string &entry, const double value)
  {
    if (!std::isfinite(value))
      throw InputError(
        entry, number_to_string(value), "it must be a finite number");
  }


  std::string
  number_to_string(const double value)
  {
    char text[32];
    std::snprintf(text, sizeof(text), "%.10g", value);
    return text;
  }


  std::string
  vector_to_string(const dealii::Tensor<1, 3> &vector)
  {
    return number_to_string(vector[0]) + ", " + number_to_string(vector[1]) +
           ", " + number_to_string(vector[2]);
  }


  std::string
  coordinate_to_string(const double value, const double scale)
  {
    return number_to_string(std::abs(value) <= 1e-12 * scale ? 0. : value);
  }


  double
  parse_number(const std::string &entry,
               const std::string &text,
               const std::string &allowed)
  {
    // from_chars() does not depend on the locale, and knows no plus sign
    std::string trimmed = dealii::Utilities::trim(text);
    if (trimmed.size() > 1 && trimmed[0] == '+' && trimmed[1] != '-')
      trimmed.erase(0, 1);
    double     value = 0;
    const auto result =
      std::from_chars(trimmed.data(), trimmed.data() + trimmed.size(), value);
    if (trimmed.empty() || result.ec != std::errc() ||
        result.ptr != trimmed.data() + trimmed.size() || !std::isfinite(value))
      throw InputError(entry, trimmed, allowed);
    if (std::abs(value) > maximum_number)
      throw InputError(entry, trimmed, number_too_large);
    return value;
  }


  std::vector<double>
  parse_values(const std::string &entry,
               const std::string &text,
               const std::string &allowed,
               const unsigned int limit)
  {
    std::vector<double> values;
    for (const std::string &item : split_list(entry, text, ',', limit))
      {
        std::vector<double> numbers;
        for (const std::string &number :
             dealii::Utilities::split_string_list(item, ':'))
          numbers.push_back(parse_number(entry, number, allowed));
        if (numbers.size() == 1)
          {
            values.push_back(numbers[0]);
            continue;
          }
        const double n = numbers.size() == 3 ? numbers[2] : 0;
        if (!(n >= 2 && n <= limit) || n != std::floor(n))
          throw InputError(entry, text, allowed);
        for (unsigned int i = 0; i < n; ++i)
          // the last one without round-off
          values.push_back(i + 1 == n ? numbers[1]
                                      : numbers[0] + (numbers[1] - numbers[0]) *
                                                       i / (n - 1));
      }
    if (values.size() > limit)
      throw InputError(entry, text, allowed);
    return values;
  }


  std::vector<std::string>
  split_words(const std::string &text)
  {
    std::istringstream stream(text);
    return {std::istream_iterator<std::string>(stream), {}};
  }


  std::vector<std::string>
  split_list(const std::string &entry,
             const std::string &text,
             const char         separator,
             const unsigned int limit)
  {
    std::vector<std::string> items(1);
    int                      depth  = 0;
    bool                     quotes = false;
    for (const char c : text)
      {
        if (c == '"')
          quotes = !quotes;
        else if (!quotes)
          depth += (c == '(') - (c == ')');
        // separators in parentheses or quotes are part of an item
        if (c == separator && depth <= 0 && !quotes)
          {
            if (items.size() > limit)
              throw InputError("the entry '" + entry + "' has more than " +
                               std::to_string(limit) + " items.");
            items.emplace_back();
          }
        else
          items.back() += c;
      }
    for (std::string &item : items)
      item = dealii::Utilities::trim(item);
    if (items.size() == 1 && items[0].empty())
      return {};
    for (const std::string &item : items)
      if (item.empty())
        throw InputError(
          entry,
          text,
          std::string("there must be an item before and after each '") +
            separator + "'");
    return items;
  }


  std::vector<double>
  parse_numbers(const std::string &entry,
                const std::string &text,
                const unsigned int n,
                const std::string &allowed)
  {
    const std::vector<std::string> words = split_words(text);
    if (words.size() != n)
      throw InputError(entry, text, allowed);
    std::vector<double> numbers;
    for (const std::string &word : words)
      {
        // the message quotes the whole text
        try
          {
            numbers.push_back(parse_number(entry, word, allowed));
          }
        catch (const InputError &)
          {
            throw InputError(entry, text, allowed);
          }
      }
    return numbers;
  }


  void
  agree_on_errors(const MPI_Comm               communicator,
                  const std::function<void()> &function)
  {
    std::string message;
    try
      {
        function();
      }
    catch (const InputError &error)
      {
        message = error.what();
      }
    // ranks may find different faults or none: all throw that of the first one
    for (const std::string &text :
         dealii::Utilities::MPI::all_gather(communicator, message))
      if (!text.empty())
        throw InputError(text);
  }


  std::pair<std::string, std::string>
  split_named(const std::string &entry,
              const std::string &text,
              const std::string &allowed)
  {
    const auto        colon = text.find(':');
    const std::string name  = dealii::Utilities::trim(text.substr(0, colon));
    if (colon == std::string::npos || name.empty())
      throw InputError(entry, text, allowed);
    return {name, dealii::Utilities::trim(text.substr(colon + 1))};
  }


  std::vector<std::pair<std::string, std::string>>
  split_named_list(const std::string &entry,
                   const std::string &text,
                   const std::string &allowed)
  {
    std::vector<std::pair<std::string, std::string>> list;
    for (const std::string &item : split_list(entry, text, ',', 1000))
      {
        const auto named = split_named(entry, item, allowed);
        if (named.second.empty())
          throw InputError(entry, item, allowed);
        std::string name;
        for (const std::string &word : split_words(named.first))
          name += (name.empty() ? "" : " ") + word;
        for (const auto &other : list)
          if (other.first == name)
            throw InputError(entry, text, "'" + name + "' is named twice");
        list.emplace_back(name, named.second);
      }
    return list;
  }


  std::string
  with_underscores(const std::string &text)
  {
    std::string result = text;
    std::replace(result.begin(), result.end(), ' ', '_');
    return result;
  }


  namespace
  {
    /** A number, or a word. */
    class NumberOrWord : public dealii::Patterns::PatternBase
    {
    public:
      explicit NumberOrWord(const std::string &word) : word(word)
      {}

      bool
      match(const std::string &text) const override
      {
        return text == word || dealii::Patterns::Double().match(text);
      }

      std::string
      description(const OutputStyle = Machine) const override
      {
        return "[Number or " + word + "]";
      }

      std::unique_ptr<dealii::Patterns::PatternBase>
      clone() const override
      {
        return std::make_unique<NumberOrWord>(word);
      }

    private:
      const std::string word;
    };
  } // namespace


  void
  add_optional_number(EntryDeclarations     &prm,
                      const std::string     &name,
                      std::optional<double> &value,
                      const std::string     &word,
                      const std::string     &documentation,
                      const EntryAttributes &attributes)
  {
    prm.declare_entry(name,
                      value ? number_to_string(*value) : word,
                      NumberOrWord(word),
                      documentation,
                      attributes);
    prm.add_action(name, [&value, word](const std::string &text) {
      if (text == word)
        value.reset();
      else
        value = dealii::Utilities::string_to_double(text);
    });
  }


  void
  add_optional_vector(EntryDeclarations                   &prm,
                      const std::string                   &name,
                      std::optional<dealii::Tensor<1, 3>> &value,
                      const std::string                   &word,
                      const std::string                   &documentation,
                      const EntryAttributes               &attributes)
  {
    const auto parse =
      [word](const std::string &entry,
             const std::string &text) -> std::optional<dealii::Tensor<1, 3>> {
      if (text == word)
        return {};
      const std::string allowed =
        "it must be three numbers, separated by commas, or '" + word + "'";
      const std::vector<std::string> numbers = split_list(entry, text);
      if (numbers.size() != 3)
        throw InputError(entry, text, allowed);
      dealii::Tensor<1, 3> vector;
      for (unsigned int i = 0; i < 3; ++i)
        vector[i] = parse_number(entry, numbers[i], allowed);
      return vector;
    };
    add_parsed(prm,
               name,
               value ? vector_to_string(*value) : word,
               value,
               parse,
               documentation,
               attributes);
  }
} // namespace Biface
