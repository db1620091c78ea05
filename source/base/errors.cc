// SPDX-License-Identifier: LGPL-2.1-or-later

#include <biface/base/errors.h>

namespace Biface
{
  namespace
  {
    /** Whether a byte goes on with a letter of UTF-8. */
    bool
    continues(const char c)
    {
      return (static_cast<unsigned char>(c) & 0xC0) == 0x80;
    }


    /** Length of the letter of UTF-8 that begins at a place, 0 if none does. */
    std::size_t
    letter_length(const std::string &text, const std::size_t at)
    {
      const auto        first = static_cast<unsigned char>(text[at]);
      const std::size_t n     = (first < 0x80                    ? 1
                                 : first >= 0xC2 && first < 0xE0 ? 2
                                 : first >= 0xE0 && first < 0xF0 ? 3
                                 : first >= 0xF0 && first < 0xF5 ? 4
                                                                 : 0);
      for (std::size_t i = 1; i < n; ++i)
        if (at + i >= text.size() || !continues(text[at + i]))
          return 0;
      return n;
    }


    /** A text without what a terminal cannot show, cut after some bytes. */
    std::string
    shown(const std::string &text, const std::size_t limit)
    {
      std::string result;
      for (std::size_t i = 0; i < text.size();)
        {
          if (result.size() >= limit)
            return result + "...";
          const std::size_t n     = letter_length(text, i);
          const auto        first = static_cast<unsigned char>(text[i]);
          const bool control = (n == 1 && (first < 0x20 || first == 0x7F)) ||
                               (n == 2 && first == 0xC2 &&
                                static_cast<unsigned char>(text[i + 1]) < 0xA0);
          if (first == '\t')
            result += ' ';
          else if (n == 0 || control)
            result += '?';
          else
            result.append(text, i, n);
          i += (n == 0 ? 1 : n);
        }
      return result;
    }
  } // namespace


  std::string
  quoted(const std::string &text, const std::size_t limit)
  {
    return "'" + shown(text, limit) + "'";
  }


  InputError::InputError(const std::string &entry,
                         const std::string &value,
                         const std::string &allowed)
    // an entry may contain the path of a file
    : InputError("the entry " + quoted(entry, 1000) + " is " + quoted(value) +
                 ", but " + allowed + ".")
  {
    this->entry = entry;
  }


  InputError::InputError(const std::string &sentence)
    : std::runtime_error(shown(sentence, 5000))
  {}
} // namespace Biface
