// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_stepping_frequency_responses_h
#define biface_stepping_frequency_responses_h

#include <deal.II/base/conditional_ostream.h>

#include <biface/solver/harmonic_response.h>
#include <biface/stepping/stage_analysis.h>

namespace Biface
{
  /** The steady response to harmonic excitations at the ends of stages that ask
   * for it. */
  class FrequencyResponses : public StageAnalysis
  {
  public:
    /** The objects are kept by reference.
     * @param air see HarmonicResponse. */
    FrequencyResponses(ShellEquations             &equations,
                       const ContactInteraction   &contact,
                       const AirColumn            *air,
                       dealii::TimerOutput        &timer,
                       dealii::ConditionalOStream &out)
      : response(equations, contact, air, timer), out(out)
    {}

    void
    end_stage(const StageRun &run, StepReport &report) override;

  private:
    HarmonicResponse            response;
    dealii::ConditionalOStream &out;
  };
} // namespace Biface

#endif
