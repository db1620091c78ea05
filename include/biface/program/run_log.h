// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_program_run_log_h
#define biface_program_run_log_h

#include <fstream>
#include <ostream>
#include <streambuf>
#include <string>

namespace Biface
{
  /**
   * What a run prints: to the screen, unless it is to be quiet, and to a file.
   * Only the first rank prints.
   */
  class RunLog : private std::streambuf
  {
  public:
    /** The screen is kept by reference. */
    RunLog(std::ostream &screen, const bool quiet, const bool is_first_rank);

    /** Where to print. */
    std::ostream &
    stream()
    {
      return out;
    }

    /**
     * Print to a file, too; what was printed before is at its head. A file that
     * cannot be opened does not end the run: a line on the screen says so.
     * @param append whether to continue the file of an earlier run.
     */
    void
    open(const std::string &file_name, const bool append);

    /** Write to the file only, such as errors that the screen already shows. */
    void
    note(const std::string &text);

  private:
    int_type
    overflow(int_type c) override;

    std::streamsize
    xsputn(const char *text, std::streamsize n) override;

    int
    sync() override;

    std::ostream &screen;
    const bool    on_screen;
    const bool    is_first_rank;
    std::ofstream file;
    /** What was printed before open(). */
    std::string  waiting;
    bool         opened = false;
    std::ostream out;
  };
} // namespace Biface

#endif
