// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_analysis_run_log_h
#define biface_analysis_run_log_h

#include <fstream>
#include <ostream>
#include <streambuf>
#include <string>

namespace Biface
{
  /**
   * The output of a run, to the screen unless it is quiet, and to a file. Only
   * the first rank prints.
   */
  class RunLog : private std::streambuf
  {
  public:
    /** The screen is kept by reference. */
    RunLog(std::ostream &screen, const bool quiet, const bool is_first_rank);

    /** The stream to print to. */
    std::ostream &
    stream()
    {
      return out;
    }

    /**
     * Print also to a file, starting with everything printed before. If the
     * file cannot be opened, a line on the screen says so, and the run
     * continues.
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
    /** The output before open(), which the file is to start with. */
    std::string  waiting;
    bool         opened = false;
    std::ostream out;
  };
} // namespace Biface

#endif
