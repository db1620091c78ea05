// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_stepping_stage_modes_h
#define biface_stepping_stage_modes_h

#include <deal.II/base/conditional_ostream.h>

#include <functional>

#include <biface/solver/modal_analysis.h>
#include <biface/stepping/stage_analysis.h>

namespace Biface
{
  /** Natural frequencies and modes at the ends of stages that ask for them. */
  class StageModes : public StageAnalysis
  {
  public:
    /** The objects are kept by reference.
     * @param air see ModalAnalysis.
     * @param with_left whether the left eigenvectors of a stage are read. */
    StageModes(ShellEquations                          &equations,
               const ContactInteraction                &contact,
               LinearSolver                            &linear_solver,
               dealii::TimerOutput                     &timer,
               const AirColumn                         *air,
               const std::function<bool(unsigned int)> &with_left,
               dealii::ConditionalOStream              &out)
      : modal_analysis(equations, contact, linear_solver, timer, air)
      , with_left(with_left)
      , out(out)
    {}

    void
    end_stage(const StageRun &run, StepReport &report) override;

  private:
    ModalAnalysis                           modal_analysis;
    const std::function<bool(unsigned int)> with_left;
    dealii::ConditionalOStream             &out;
  };
} // namespace Biface

#endif
