// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/utilities.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <map>
#include <optional>

#include <biface/base/errors.h>
#include <biface/input/parameter_text.h>
#include <biface/input/parameter_tools.h>
#include <biface/problem/design_variable.h>
#include <biface/problem/override.h>

namespace Biface
{
  using namespace dealii;

  namespace
  {
    constexpr const char *form =
      "it must have the form 'name: Section/Entry[k], -Section/Entry[k], ...' "
      "or 'name: factor of Section/Entry[k], ...'";


    /** A part of a text. */
    struct Span
    {
      std::size_t begin;
      std::size_t size;
    };


    bool
    is_digit(const char c)
    {
      return std::isdigit(static_cast<unsigned char>(c)) != 0;
    }


    bool
    is_blank(const char c)
    {
      return c == ' ' || c == '\t';
    }


    /** Whether a character can belong to a name or a number. */
    bool
    is_word(const char c)
    {
      return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' ||
             c == '.';
    }


    /** The end of a number without sign that begins at a place. */
    std::size_t
    end_of_number(const std::string &text, std::size_t at)
    {
      const auto skip_digits = [&]() {
        while (at < text.size() && is_digit(text[at]))
          ++at;
      };
      skip_digits();
      if (at < text.size() && text[at] == '.')
        ++at;
      skip_digits();
      if (at < text.size() && (text[at] == 'e' || text[at] == 'E'))
        {
          // an e without digits begins a word, such as a unit
          std::size_t digits = at + 1;
          if (digits < text.size() &&
              (text[digits] == '+' || text[digits] == '-'))
            ++digits;
          if (digits < text.size() && is_digit(text[digits]))
            {
              at = digits;
              skip_digits();
            }
        }
      return at;
    }


    /** The numbers in the value of an entry. */
    std::vector<Span>
    find_numbers(const std::string &text)
    {
      std::vector<Span> result;
      // the last character that was not blank, 'x' for words and '0' for
      // numbers, and its place
      char        before = '\0';
      std::size_t last   = 0;
      // whether it is a sign that belongs to a number
      bool sign = false;
      for (std::size_t at = 0; at < text.size();)
        {
          const char c = text[at];
          if (c == '"')
            {
              // what is quoted is a name, whatever digits it contains
              const std::size_t end = text.find('"', at + 1);
              if (end == std::string::npos)
                return result;
              before = c;
              sign   = false;
              at     = end + 1;
            }
          else if (is_word(c))
            {
              // a word that begins with digits but goes on with letters is no
              // number
              std::size_t       end    = at;
              const bool        number = is_digit(c) || c == '.';
              const std::size_t number_end =
                (number ? end_of_number(text, at) : at);
              while (end < std::max(number_end, text.size()) &&
                     (end < number_end || is_word(text[end])))
                ++end;
              if (number && end == number_end &&
                  std::any_of(text.begin() + at, text.begin() + end, is_digit))
                {
                  const std::size_t begin = (sign ? last : at);
                  result.push_back({begin, end - begin});
                }
              before = (number ? '0' : 'x');
              sign   = false;
              at     = end;
            }
          else
            {
              if (!is_blank(c))
                {
                  // after an operand it is an operator, but after a number
                  // and a blank, as in lists, a sign; a sign is next to its
                  // number; +- and -+ are two plies with the same number
                  const bool both = sign && last + 1 == at &&
                                    (c == '-' || c == '+') && c != before;
                  const bool next_item =
                    before == '0' && is_blank(text[at - 1]) &&
                    at + 1 < text.size() &&
                    (is_digit(text[at + 1]) || text[at + 1] == '.');
                  sign = (c == '-' || c == '+') && !both &&
                         (next_item || (before != 'x' && before != '0')) &&
                         before != ')' && before != '"' &&
                         at + 1 < text.size() && !is_blank(text[at + 1]);
                  before = c;
                  last   = at;
                }
              ++at;
            }
        }
      return result;
    }


    /** Remove a word at the start of a text, and the blanks behind it.
     * @return whether it was there. */
    bool
    remove_prefix(std::string &text, const std::string &prefix)
    {
      if (text.rfind(prefix, 0) != 0)
        return false;
      text = Utilities::trim(text.substr(prefix.size()));
      return true;
    }
  } // namespace


  DesignVariable::DesignVariable(const std::string &entry,
                                 const std::string &full_text)
    : where(entry), text(Utilities::trim(full_text))
  {
    std::string rest  = text;
    const auto  colon = text.find(':');
    if (colon != std::string::npos)
      {
        name = Utilities::trim(text.substr(0, colon));
        rest = Utilities::trim(text.substr(colon + 1));
        if (name.empty() || name.find_first_of("\",") != std::string::npos)
          throw InputError(where,
                           text,
                           "a name must not be empty or contain a comma or a "
                           "quote");
      }
    if (remove_prefix(rest, "factor of "))
      factor = true;
    for (const std::string &item : split_list(where, rest))
      numbers.push_back(parse_number_name(item));
    if (numbers.empty())
      throw InputError(where, text, form);
    if (colon == std::string::npos)
      {
        if (numbers.size() > 1)
          throw InputError(
            where,
            text,
            "several numbers need a name, as in 'angle: " + text + "'");
        name = text;
      }
  }


  DesignVariable::Number
  DesignVariable::parse_number_name(const std::string &item) const
  {
    Number      result;
    std::string rest = Utilities::trim(item);
    if (remove_prefix(rest, "-"))
      {
        result.negative = true;
        if (factor)
          throw InputError(where, text, "a factor has no minus");
      }
    const auto bracket = rest.find('[');
    if (bracket != std::string::npos)
      {
        const std::string position =
          rest.substr(bracket + 1, rest.size() - bracket - 2);
        if (rest.back() != ']' || position.empty() || position.size() > 6 ||
            !std::all_of(position.begin(), position.end(), is_digit) ||
            std::stoul(position) == 0)
          throw InputError(where,
                           text,
                           "the number in brackets must be the position of a "
                           "number in the value of the entry, from 1");
        result.position = std::stoul(position);
        rest            = Utilities::trim(rest.substr(0, bracket));
      }
    const std::vector<std::string> path =
      Utilities::split_string_list(rest, '/');
    if (path.empty() || std::find(path.begin(), path.end(), "") != path.end())
      throw InputError(where, text, form);
    for (const std::string &part : path)
      result.entry += (result.entry.empty() ? "" : "/") + part;
    return result;
  }


  unsigned int
  DesignVariable::find(const Number          &number,
                       const DeclaredEntries &declared) const
  {
    const std::optional<std::string> value = declared.value(number.entry);
    if (!value)
      throw InputError(where, text, no_such_entry(declared.prm, number.entry));
    const std::string what =
      "the entry " + quoted(number.entry) + " is " + quoted(*value);
    const std::size_t n = find_numbers(*value).size();
    if (n == 0)
      throw InputError(where, text, what + ", which contains no number");
    if (number.position == 0 && n > 1)
      throw InputError(where,
                       text,
                       what + ", which contains " + std::to_string(n) +
                         " numbers; choose one of them, as in " +
                         quoted(number.entry + "[1]"));
    if (number.position > n)
      throw InputError(where,
                       text,
                       what + ", which contains only " + std::to_string(n) +
                         (n == 1 ? " number" : " numbers"));
    return std::max(number.position, 1U);
  }


  std::vector<std::string>
  DesignVariable::get_entries() const
  {
    std::vector<std::string> entries;
    for (const Number &number : numbers)
      entries.push_back(number.entry);
    return entries;
  }


  void
  DesignVariable::check(const DeclaredEntries &declared) const
  {
    for (const Number &number : numbers)
      find(number, declared);
  }


  double
  DesignVariable::value(const DeclaredEntries &declared) const
  {
    std::vector<double> values;
    for (const Number &number : numbers)
      {
        const unsigned int position = find(number, declared);
        const std::string  given    = *declared.value(number.entry);
        const Span         span     = find_numbers(given)[position - 1];
        const double       found    = parse_number(where,
                                          given.substr(span.begin, span.size),
                                          "the entry " + quoted(number.entry) +
                                            " must contain a number there");
        values.push_back(number.negative ? -found : found);
      }
    if (factor)
      return 1;
    // one value stands for all of them, whose signs are in the names
    for (const double other : values)
      if (std::abs(other - values[0]) > 1e-12 * std::abs(values[0]))
        throw InputError(where,
                         text,
                         "its numbers must be equal, and are " +
                           number_to_string(values[0]) + " and " +
                           number_to_string(other) + " in the file");
    return values[0];
  }


  std::string
  exact_number(const double value)
  {
    // the shortest text that is read as the same number again
    std::array<char, 32> text;
    const auto           end =
      std::to_chars(text.data(), text.data() + text.size(), value);
    return {text.data(), end.ptr};
  }


  std::vector<DesignVariable>
  parse_design_variables(const std::string &entry, const std::string &text)
  {
    std::vector<DesignVariable> result;
    for (const std::string &item : split_list(entry, text, ';', 1000))
      {
        result.emplace_back(entry, item);
        for (std::size_t i = 0; i + 1 < result.size(); ++i)
          if (result[i].get_name() == result.back().get_name())
            throw InputError(entry,
                             text,
                             "two variables are called " +
                               quoted(result[i].get_name()));
      }
    return result;
  }


  std::vector<Override>
  settings(const std::vector<DesignVariable> &variables,
           const std::vector<double>         &values,
           const DeclaredEntries             &declared,
           const std::string                 &source)
  {
    AssertDimension(variables.size(), values.size());
    struct Change
    {
      std::optional<double> value;
      double                factor = 1;
    };
    // by entry and position
    std::map<std::string, std::map<unsigned int, Change>> changes;
    for (unsigned int i = 0; i < variables.size(); ++i)
      for (const DesignVariable::Number &number : variables[i].numbers)
        {
          Change &change =
            changes[number.entry][variables[i].find(number, declared)];
          // a variable may scale what another one sets; two must not set it
          if (variables[i].factor)
            change.factor *= values[i];
          else if (change.value)
            throw InputError(variables[i].where,
                             variables[i].text,
                             "another variable sets the same number of " +
                               quoted(number.entry));
          else
            change.value = (number.negative ? -values[i] : values[i]);
        }

    std::vector<Override> result;
    for (const auto &[entry, numbers] : changes)
      {
        const std::string given = *declared.value(entry);
        const auto        spans = find_numbers(given);
        std::string       text;
        std::size_t       copied = 0;
        for (const auto &[position, change] : numbers)
          {
            const Span span = spans[position - 1];
            // the rest of the value stays as it is in the file
            text += given.substr(copied, span.begin - copied);
            copied = span.begin + span.size;
            const double value =
              (change.value ? *change.value
                            : parse_number(entry,
                                           given.substr(span.begin, span.size),
                                           "it must contain numbers")) *
              change.factor;
            text += exact_number(value);
          }
        text += given.substr(copied);
        result.emplace_back(entry + "=" + text, source);
      }
    return result;
  }
} // namespace Biface
