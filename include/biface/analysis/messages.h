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
     * its stage. */
    std::string
    line(const StepReport &report, const Progress &progress) const;

  private:
    /** A quantity of which each stage has its part. */
    struct Amount
    {
      std::vector<double> of_stages;
      double              at_begin = 0;

      /** What is completed, fractions of stages included. */
      double
      done(const Progress &progress) const;

      double
      left(const Progress &progress) const;
    };

    /** The planned steps, and their iterations. */
    Amount        steps, iterations;
    bool          predictable = true;
    dealii::Timer timer;
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
