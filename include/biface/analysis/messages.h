// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_analysis_messages_h
#define biface_analysis_messages_h

#include <deal.II/base/conditional_ostream.h>
#include <deal.II/base/timer.h>

#include <string>
#include <vector>

#include <biface/analysis/simulation.h>
#include <biface/stepping/load_stepping.h>
#include <biface/stepping/progress.h>
#include <biface/stepping/stage.h>
#include <biface/stepping/step_report.h>

namespace Biface
{
  /** Print version, ranks, size of the mesh, BLAS, and free rigid motions. */
  void
  print_header(const Simulation &simulation, dealii::ConditionalOStream &out);


  /** The progress of a run, for a line after every step. */
  class StepCounter
  {
  public:
    /** @param progress the progress at the start. */
    StepCounter(const Parameters &parameters, const Progress &progress);

    /** The line of a step, such as "step 3 of 21: ...; 2.1 s so far, about 12 s
     * left". The total number of steps and the remaining time, which follows
     * from expected_iterations(), are given if each step is a given fraction of
     * its stage. Steps that were halved are expected to stay as short to the
     * end of their stage. To be called for each step. */
    std::string
    line(const StepReport &report, const Progress &progress);

  private:
    /** The fraction of a stage that is done; 0 of one that has not begun. */
    static double
    done(const Progress &progress);

    /** The planned steps of each stage, and what a step takes, see
     * expected_iterations(). */
    std::vector<double> steps, iterations;
    bool                predictable = true;
    dealii::Timer       timer;
    /** The place of the last step, and what all steps so far have taken. */
    unsigned int last_stage = 0;
    double       last_done = 0, iterations_done = 0;
  };


  /** Print the times of the parts of the run, and the peak memory of all ranks.
   * Must be called on all ranks. */
  void
  print_costs(Simulation &simulation, dealii::ConditionalOStream &out);

  /** Print the location of the results. */
  void
  print_files(const std::string              &directory,
              const std::vector<std::string> &files,
              dealii::ConditionalOStream     &out);

  /** Indented lines with the meaning of the failure of a step, possible
   * remedies, and the progress of the run. */
  std::string
  failure_paragraph(const LoadSteppingResult &result);
} // namespace Biface

#endif
