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
    /** @param stages the stages of the run, kept by reference.
     * @param last_stage the last one of them that is run.
     * @param progress the progress at the start. */
    StepCounter(const std::vector<Stage> &stages,
                const unsigned int        last_stage,
                const Progress           &progress);

    /** The line of a step, such as "step 3 of 21: ...; 2.1 s so far, about 12 s
     * left". The total number of steps and the remaining time are given if each
     * step is a given fraction of its stage. */
    std::string
    line(const StepReport &report, const Progress &progress) const;

  private:
    /** The number of completed steps of those planned by the stages, including
     * fractions. */
    double
    done(const Progress &progress) const;

    const std::vector<Stage> &stages;
    const double              at_begin;
    double                    planned     = 0;
    bool                      predictable = true;
    dealii::Timer             timer;
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
