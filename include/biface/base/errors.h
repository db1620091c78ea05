// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_base_errors_h
#define biface_base_errors_h

#include <stdexcept>
#include <string>

namespace Biface
{
  /**
   * External text prepared for a message: quoted, without unprintable
   * characters, and truncated after @p limit bytes.
   */
  std::string
  quoted(const std::string &text, const std::size_t limit = 200);


  /**
   * Invalid input.
   *
   * Thrown where the value is read. Every message is one plain sentence that
   * names the entry, its value, and what is allowed. The reader of a file
   * prepends its name.
   *
   * It must be thrown on all ranks, which is true of everything that depends on
   * the parameters alone.
   */
  class InputError : public std::runtime_error
  {
  public:
    /** The sentence "`entry` is `value`, but `allowed`.", whose first two parts
     * are passed through quoted(). */
    InputError(const std::string &entry,
               const std::string &value,
               const std::string &allowed);

    /** Any sentence; unprintable characters are removed. */
    explicit InputError(const std::string &sentence);

    /** The name of the entry; empty where only the sentence was given. */
    const std::string &
    get_entry() const
    {
      return entry;
    }

  private:
    std::string entry;
  };


  /**
   * A file of results that cannot be written, for example because the disk is
   * full. The message is one plain sentence that names the file and the reason.
   *
   * It must be thrown on all ranks.
   */
  class OutputError : public std::runtime_error
  {
  public:
    OutputError(const std::string &file, const std::string &reason)
      : std::runtime_error("the file '" + file + "' cannot be written (" +
                           reason + ").")
    {}
  };
} // namespace Biface

#endif
