// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_stepping_restore_point_h
#define biface_stepping_restore_point_h

#include <map>
#include <set>
#include <utility>
#include <vector>

#include <biface/model/state/state.h>
#include <biface/stepping/progress.h>

namespace Biface
{
  /** The state and progress after a step, which are all that changes in a run:
   * stepping continues identically from a copy. */
  struct RestorePoint
  {
    State    state;
    Progress progress;
  };

  /** The ends of the stages from which others than the next one start, see
   * is_branched_from(), by the position of the stage; without the data of the
   * control and the predictor, which belong to the steps of the stage alone. */
  using StageEnds = std::map<unsigned int, RestorePoint>;

  /** The last step of a run with the ends of its stages: all that a restart
   * needs. */
  struct RestorePoints
  {
    RestorePoint last;
    StageEnds    ends;
  };

  /** All that a restart needs of the runs with changed entries, see
   * SensitivityAnalysis. */
  struct PerturbedPoints
  {
    std::vector<RestorePoints> runs;
    /** The positions of stages that the perturbed runs did not follow to the
     * end, see SensitivityAnalysis::follow(). */
    std::set<unsigned int> lost_stages;
    /** The positions of stages and entries whose runs have not settled. */
    std::set<std::pair<unsigned int, unsigned int>> unsettled{};
  };


  /** The state of the run after the last converged step: what a checkpoint
   * contains of it and of its perturbed runs. */
  struct AllPoints
  {
    RestorePoints   run;
    PerturbedPoints perturbed;
  };
} // namespace Biface

#endif
