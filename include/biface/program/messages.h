// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_program_messages_h
#define biface_program_messages_h

#include <deal.II/base/conditional_ostream.h>
#include <deal.II/base/timer.h>

#include <string>
#include <vector>

#include <biface/program/simulation.h>
#include <biface/stepping/load_stepping.h>
#include <biface/stepping/progress.h>
#include <biface/stepping/stage.h>
#include <biface/stepping/step_report.h>

namespace Biface
{
  /** Version, ranks, size of the mesh, BLAS, and rigid motions left free. */
  void
  print_header(const Simulation &simulation, dealii::ConditionalOStream &out);


  /** How far a run has come: for a line after every step. */
  class StepCounter
  {
  public:
    /** @param stages of the run, which are kept by reference.
     * @param progress with which it starts. */
    StepCounter(const std::vector<Stage> &stages, const Progress &progress);

    /** "step 3 of 21: ...; 2.1 s so far, about 12 s left". How many steps
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


  /** Times of the parts of the run, and the peak of the memory of all ranks
   * together. Must be called on all ranks. */
  void
  print_costs(Simulation &simulation, dealii::ConditionalOStream &out);

  /** Where the results are. @param files see ResultsWriter::list(). */
  void
  print_files(const std::string              &directory,
              const std::vector<std::string> &files,
              dealii::ConditionalOStream     &out);

  /** What the failure of a step means, what may help, and how far the run
   * came: indented lines. */
  std::string
  failure_paragraph(const LoadSteppingResult &result);
} // namespace Biface

#endif
