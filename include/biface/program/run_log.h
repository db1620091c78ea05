// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_program_run_log_h
#define biface_program_run_log_h

#include <deal.II/base/timer.h>

#include <fstream>
#include <ostream>
#include <streambuf>
#include <string>
#include <vector>

#include <biface/stepping/load_stepping.h>
#include <biface/stepping/progress.h>
#include <biface/stepping/stage.h>

namespace Biface
{
  /**
   * What a run says: on the screen, unless that is to be quiet, and in a file.
   * A rank other than the first says nothing.
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
     * Print to a file, too; what was printed before is at its head.
     * @param append whether to go on with the file of an earlier run.
     */
    void
    open(const std::string &file_name, const bool append);

    /** Write to the file what the screen has from elsewhere, such as errors. */
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
    /** Until the file is open. */
    std::string  waiting;
    std::ostream out;
  };


  /** How far a run has come: for a line after every step. */
  class StepCounter
  {
  public:
    /** @param stages of the run, which are kept by reference.
     * @param progress with which it begins. */
    StepCounter(const std::vector<Stage> &stages, const Progress &progress);

    /** "step 3 of 21: ...; 2.1 s so far, about 12 s to go". How many steps
     * there will be, and the time, are told where each step is a given part of
     * its stage. */
    std::string
    line(const StepReport &report, const Progress &progress) const;

  private:
    /** Steps done of those that the stages plan, with parts of one. */
    double
    done(const Progress &progress) const;

    const std::vector<Stage> &stages;
    const double              at_begin;
    double                    planned     = 0;
    bool                      predictable = true;
    dealii::Timer             timer;
  };
} // namespace Biface

#endif
