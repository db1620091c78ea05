// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_stepping_branch_switching_h
#define biface_stepping_branch_switching_h

#include <deal.II/base/conditional_ostream.h>

#include <optional>

#include <biface/stepping/attempt.h>

namespace Biface
{
  struct ControlTrial;


  /** Attempt a step to the other branch at the bifurcation where the last step
   * ended, see Progress::branch.
   * @param trial the next step; that to the branch if it is found.
   * @return none if the branch is not found. */
  std::optional<Attempt>
  attempt_other_branch(Newton                     &newton,
                       const StageRun             &run,
                       ControlTrial               &trial,
                       dealii::ConditionalOStream &out);
} // namespace Biface

#endif
