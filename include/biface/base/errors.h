// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_base_errors_h
#define biface_base_errors_h

#include <stdexcept>
#include <string>

namespace Biface
{
  /**
   * A text from outside as it can stand in a sentence: in quotation marks,
   * without what a terminal cannot show, and cut after @p limit bytes.
   */
  std::string
  quoted(const std::string &text, const std::size_t limit = 200);


  /**
   * A value from outside the program that cannot be used.
   *
   * Thrown where the value enters: every message is one plain sentence that
   * names the entry, its value, and what is allowed. The name of the file is
   * put in front by the reader of the file.
   *
   * It must be thrown on all ranks alike, which holds for everything that is
   * decided from the parameters alone.
   */
  class InputError : public std::runtime_error
  {
  public:
    /** A sentence of the form "`entry` is `value`, but `allowed`." The first
     * two are quoted as by quoted(). */
    InputError(const std::string &entry,
               const std::string &value,
               const std::string &allowed);

    /** Any other sentence; what a terminal cannot show is left out. */
    explicit InputError(const std::string &sentence);
  };


  /**
   * A file of results that cannot be written, for want of space, say. The
   * message is one plain sentence that names the file and the reason.
   *
   * It must be thrown on all ranks alike.
   */
  class OutputError : public std::runtime_error
  {
  public:
    OutputError(const std::string &file, const std::string &reason)
      : std::runtime_error("the file '" + file + "' cannot be written (" +
                           reason + "), but results must go somewhere.")
    {}
  };
} // namespace Biface

#endif
