// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_input_parameter_text_h
#define biface_input_parameter_text_h

#include <deal.II/base/parameter_handler.h>

#include <optional>
#include <set>
#include <string>
#include <vector>

namespace Biface
{
  /**
   * The text of a parameter file with each entry in one line, and without
   * comments. A backslash at the end of a line joins it with the next one, also
   * if one of the two stands before or in a comment; a line that is a comment
   * hides nothing but itself. Lines keep their numbers: an entry is in its last
   * line.
   *
   * Throws InputError if what follows a backslash is another setting or
   * section.
   *
   * @param source the name of the text in error messages.
   */
  std::string
  join_lines(const std::string &source, const std::string &text);


  /** A line of a parameter file. */
  struct ParameterLine
  {
    /** The section of the line, as "Section/Subsection/". */
    std::string section;
    /** The first word of the line: `set`, `subsection`, `end`, `include`, or
     * anything else. */
    std::string keyword;
    /** The texts before and after the first '='. */
    std::string name;
    std::string value;
    /** The number of open sections after the line. */
    unsigned int depth = 0;
  };


  /** The lines of a parameter file by their numbers, which start at 1.
   * @param text see join_lines(). */
  std::vector<ParameterLine>
  scan_parameter_text(const std::string &text);


  /**
   * Refuse what ParameterHandler would silently misinterpret: an entry that is
   * set twice, of which it takes the last value; braces, which it takes for a
   * list of alternatives; included files, which every rank would read; numbers
   * that would overflow; sections within too many others. Also refuse a list
   * that ends with a comma or a semicolon, which may have lost its last items.
   *
   * Throws InputError.
   *
   * @param source the name of the text in error messages.
   * @param text the text of a complete parameter file, see join_lines().
   */
  void
  check_parameter_text(const std::string &source, const std::string &text);


  /** The position of a line, as the start of a message.
   * @param source the name of the text in error messages.
   * @param line its number. */
  std::string
  parameter_place(const std::string &source, const unsigned int line);

  /** The position of the line that sets an entry, as the start of a message;
   * the source alone if there is none. */
  std::string
  parameter_place(const std::string &source,
                  const std::string &text,
                  const std::string &entry);


  /**
   * Parse a parameter file.
   *
   * Throws InputError, see parameter_sentence().
   *
   * @param prm the declared entries.
   * @param source the name of the text in error messages.
   * @param skip_undefined whether entries that are not declared are ignored.
   */
  void
  parse_parameter_text(dealii::ParameterHandler &prm,
                       const std::string        &source,
                       const std::string        &text,
                       const bool                skip_undefined = false);


  /** The names of all declared entries, "Section/Entry", and sections,
   * "Section/". */
  std::vector<std::string>
  declared_names(const dealii::ParameterHandler &prm);

  /** The declared entries by their names, to look up many of them. */
  class DeclaredEntries
  {
  public:
    /** The entries of a handler, which is kept by reference. Not explicit: the
     * object stands for its entries. */
    DeclaredEntries(const dealii::ParameterHandler &prm);

    /** The value of an entry "Section/Entry"; nothing if it does not exist. */
    std::optional<std::string>
    value(const std::string &entry) const;

    const dealii::ParameterHandler &prm;

  private:
    std::set<std::string> names;
  };


  /** The statement that an entry or a section does not exist, as part of a
   * sentence, with the declared name nearest to it if one is near: of its
   * section or, if this does not exist either, of all names. */
  std::string
  no_such_entry(const dealii::ParameterHandler &prm, const std::string &name);


  /**
   * An error of ParameterHandler as one sentence that names file, line, entry,
   * value and what is allowed, or a known name near to an unknown one.
   *
   * @param exception the exception.
   * @param source the name of the text in the sentence.
   * @param text the text of the parameter file.
   * @param prm the declared entries.
   */
  std::string
  parameter_sentence(const dealii::ExceptionBase    &exception,
                     const std::string              &source,
                     const std::string              &text,
                     const dealii::ParameterHandler &prm);
} // namespace Biface

#endif
