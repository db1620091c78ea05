// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_input_parameter_text_h
#define biface_input_parameter_text_h

#include <deal.II/base/parameter_handler.h>

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


  /**
   * A name that parameter files may still use, and the one it has now: an entry
   * "Section/Entry", a section "Section/Subsection/", or one of the words in
   * the value of an entry, "Section/Entry=word". "Stage N/" stands for all
   * stages, an asterisk in the place of the entry for all of the section.
   */
  struct OldName
  {
    std::string old_name;
    std::string new_name;
  };


  /** Put the new names in the place of the old ones in a parameter file; lines
   * keep their numbers.
   * @return the names that were replaced, each once. */
  std::vector<OldName>
  replace_old_names(std::string &text, const std::vector<OldName> &names);


  /** Where a line stands, as the start of a sentence.
   * @param source what error messages call the text.
   * @param line its number. */
  std::string
  parameter_place(const std::string &source, const unsigned int line);

  /** The same for the line that sets an entry; the source alone where none
   * does. */
  std::string
  parameter_place(const std::string &source,
                  const std::string &text,
                  const std::string &entry);


  /**
   * What ParameterHandler has to say of a parameter file, as one sentence that
   * names file, line, entry, value and what is allowed; of an unknown name, the
   * nearest one that is known.
   *
   * @param exception what was thrown.
   * @param source what the sentence calls the text.
   * @param text the text of the parameter file.
   * @param prm knows the entries.
   */
  std::string
  parameter_sentence(const dealii::ExceptionBase    &exception,
                     const std::string              &source,
                     const std::string              &text,
                     const dealii::ParameterHandler &prm);
} // namespace Biface

#endif
