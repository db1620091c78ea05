// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_stepping_stage_buckling_h
#define biface_stepping_stage_buckling_h

#include <deal.II/base/conditional_ostream.h>

#include <functional>

#include <biface/model/state/state.h>
#include <biface/solver/buckling_analysis.h>
#include <biface/stepping/load_level.h>
#include <biface/stepping/stage_analysis.h>

namespace Biface
{
  /** The prediction of buckling at the ends of stages that ask for it. */
  class StageBuckling : public StageAnalysis
  {
  public:
    /** The first and the last object are kept by reference.
     * @param with_left whether the left eigenvectors of a stage are read. */
    StageBuckling(BucklingAnalysis                        &buckling_analysis,
                  const std::function<bool(unsigned int)> &with_left,
                  dealii::ConditionalOStream              &out)
      : buckling_analysis(buckling_analysis), with_left(with_left), out(out)
    {}

    /** Keep the equilibrium before the last step of a stage. */
    void
    follow(const Step &step) override;

    void
    end_stage(const StageRun &run, StepReport &report) override;

  private:
    BucklingAnalysis                       &buckling_analysis;
    const std::function<bool(unsigned int)> with_left;
    dealii::ConditionalOStream             &out;

    State     before;
    LoadLevel level_before;
  };
} // namespace Biface

#endif
