// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_input_parameter_text_h
#define biface_input_parameter_text_h

#include <string>
#include <vector>

namespace Biface
{
  /** A line of a parameter file. */
  struct ParameterLine
  {
    /** The section it stands in, as "Section/Subsection/". */
    std::string section;
    /** `set`, `subsection`, `end`, `include`, or anything else. */
    std::string keyword;
    /** What stands before and after the first '='. */
    std::string name;
    std::string value;
    /** How many sections are open after it. */
    unsigned int depth = 0;
  };


  /** The lines of a parameter file, the first one with the number 1. */
  std::vector<ParameterLine>
  scan_parameter_text(const std::string &text);


  /**
   * Refuse what ParameterHandler would take without a word, and not as meant:
   * two settings of one entry, of which it takes the last; braces, which it
   * takes for a list of alternatives; other files, which every rank would
   * read; numbers that would overflow; sections without end.
   *
   * Throws InputError.
   *
   * @param source what error messages call the text.
   * @param text that of a whole parameter file.
   */
  void
  check_parameter_text(const std::string &source, const std::string &text);


  /** Where something stands, as the begin of a sentence.
   * @param source what error messages call the text.
   * @param line its number. */
  std::string
  parameter_place(const std::string &source, const std::string &line);
} // namespace Biface

#endif
