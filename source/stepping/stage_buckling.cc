// SPDX-License-Identifier: LGPL-2.1-or-later

#include <biface/model/forces/nodal_forces.h>
#include <biface/model/mesh/rigid_motions.h>
#include <biface/stepping/buckling.h>
#include <biface/stepping/buckling_start.h>
#include <biface/stepping/stage_buckling.h>
#include <biface/stepping/stage_run.h>
#include <biface/stepping/step_report.h>

namespace Biface
{
  void
  StageBuckling::follow(const Step &step)
  {
    if (step.run.stage.n_buckling == 0 || !step.run.is_complete())
      return;
    // index 0 of section 9: the step is about to replace this state
    before       = step.run.state;
    level_before = step.level_before;
  }


  void
  StageBuckling::end_stage(const StageRun &run, StepReport &report)
  {
    if (run.stage.n_buckling == 0)
      return;
    const LoadLevel    &start = run.progress.control.start;
    const LoadLevel    &level = run.progress.reached;
    const BucklingStart from  = buckling_start(
      run.state, start, {before, level_before}, [&](const LoadLevel &of) {
        return run.loads_at(of);
      });
    const Loads loads  = run.loads_at(level);
    LoadRates   change = change_of(from.level, level);
    // the gas makes its own pressure, which is no load that is given
    if (run.stage.sealed)
      change.pressure = 0;
    const BucklingModes found =
      buckling_analysis.compute({from.state, from.loads},
                                {run.state, loads},
                                change,
                                run.stage.n_buckling,
                                with_left(report.instant.stage));
    const std::vector<ForceOnShell> first =
      forces_on_shell(run.equations,
                      from.state,
                      run.equations.nodal_forces(from.state, from.loads));
    // it takes as much memory as the state of the run, and is of no use any
    // more
    before = State();
    if (!found.success)
      {
        out << "  Warning: the buckling loads of " << run.stage.name
            << " were not found: " << found.message << std::endl;
        return;
      }
    if (!found.free_motions.empty())
      out << "  buckling is sought without the rigid motions that nothing "
             "holds: "
          << in_words(found.free_motions) << std::endl;
    const auto buckling = std::make_shared<Buckling>(
      buckling_from(found, start, from.level, level, run.stage.sealed));
    for (const BucklingMode &mode : buckling->modes)
      buckling->forces.push_back(
        interpolated_forces(first, report.forces_of_bodies, mode.position));
    if (buckling->modes.empty())
      {
        out << "  no buckling is predicted for this change of the loads"
            << std::endl;
        return;
      }
    out << "  buckling at factors of the loads of the stage:";
    for (const CriticalLoads &critical : buckling->loads)
      out << ' ' << critical.factor;
    out << std::endl;
    report.buckling = buckling;
  }
} // namespace Biface
