// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_tests_model_rolling_wheel_h
#define biface_tests_model_rolling_wheel_h

#include <string>
#include <vector>

#include <biface/model/quantities/rolling_summary.h>

#include <run_analysis.h>
#include <tests.h>

/** The bias tire on a coarse mesh, pressed by 12 mm, in a third stage rolling
 * freely over the ground in two steps.
 * @return the changes of bias_tire.prm. */
inline std::vector<Biface::Override>
rolling_overrides(const std::vector<Biface::Override> &changes)
{
  std::vector<Biface::Override> overrides{
    "Contact/Multiplier mass=lumped",
    "Contact/Critical velocity=0.02",
    "Material cord/Loss factor=0.1",
    "Mesh/Intervals alpha_1=-120:120:12",
    "Mesh/Intervals alpha_2=-180:-30:4, -30:30:15, 30:180:4",
    "Stage 2/Steps=1",
    "Stage 2/Travel=12",
    "Stage 3/Contact=true",
    "Stage 3/Friction=0.5",
    "Stage 3/Ground velocity=1",
    "Stage 3/Control=axle moment",
    "Stage 3/Steps=2"};
  overrides.insert(overrides.end(), changes.begin(), changes.end());
  return overrides;
}


/** Run the wheel of rolling_overrides().
 * @return the reports of all steps. */
inline std::vector<Biface::StepReport>
rolling_reports(const std::vector<Biface::Override> &changes)
{
  return run_analysis(PRM_DIR "/bias_tire.prm", rolling_overrides(changes));
}


struct RollingRun
{
  /** The vertical force of the wheel at rest. */
  double                              standing = 0;
  std::vector<Biface::RollingSummary> rolling;
};


/** The forces of the wheel at rest and in the steps that roll, see
 * rolling_reports(). */
inline RollingRun
roll(const std::vector<Biface::Override> &changes)
{
  RollingRun run;
  for (const Biface::StepReport &report : rolling_reports(changes))
    if (report.rolling)
      run.rolling.push_back(*report.rolling);
    else
      run.standing = report.contact.force;
  return run;
}


/** Check that the powers balance but for the error of the mesh. */
inline void
check_powers(const std::string &what, const Biface::RollingSummary &rolling)
{
  check_small(what,
              rolling.mismatch,
              0.005,
              std::abs(rolling.force[0]) + rolling.force[2]);
}

#endif
