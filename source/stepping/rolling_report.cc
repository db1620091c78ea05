// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include <biface/contact/rolling.h>
#include <biface/input/parameter_tools.h>
#include <biface/model/contact/contact_interaction.h>
#include <biface/model/mesh/strip.h>
#include <biface/model/state/loads.h>
#include <biface/stepping/rolling_report.h>
#include <biface/stepping/stage_run.h>
#include <biface/stepping/step_report.h>
#include <biface/stepping/wheel_motion.h>

namespace Biface
{
  using namespace dealii;

  void
  RollingReport::end_step(const StageRun &run, StepReport &report)
  {
    if (!report.loads->rolling)
      return;
    warn_of_fast_wheel(run, report);
    if (!run.stage.contact)
      return;
    report.rolling =
      summarize_rolling(run.equations,
                        run.contact,
                        run.state,
                        *report.loads,
                        force_of_ground(report.forces_of_bodies));
    if (report.axle_moment)
      {
        report.rolling->axle_moment = *report.axle_moment;
        report.rolling->axle_power =
          *report.axle_moment * report.loads->rolling->angular_velocity;
      }
    if (run.heat && report.rolling->hysteresis)
      add_heat(run, report);
    report.slip_velocities =
      slip_velocities(run.contact.ground(), run.state, *report.loads);
    if (const auto &free_radius = run.progress.free_rolling_radius)
      report.slip_ratio = slip_ratio(report.level, *free_radius);
  }


  void
  RollingReport::add_heat(const StageRun &run, StepReport &report)
  {
    const RollingSummary &rolling = *report.rolling;
    // what relaxes is the power of axle and ground less friction, but for an
    // error of the mesh, section 10
    if (rolling.hysteresis->of_relaxation > 0 &&
        std::abs(rolling.mismatch) > 0.1 * rolling.hysteresis_power)
      out << "  Warning: axle and ground have "
          << std::round(100 * std::abs(rolling.mismatch) /
                        rolling.hysteresis_power)
          << " % of the power of the hysteresis too "
          << (rolling.mismatch > 0 ? "much" : "little")
          << ": drag and rolling resistance need smaller cells around the axle"
          << std::endl;
    report.heat = run.heat->field(*rolling.hysteresis,
                                  run.heat->parts_in_contact(run.state),
                                  *report.loads);
    if (!run.heat->is_computed())
      return;
    if (run.heat->is_coupled())
      report.heat->temperature = run.heat->followed(run.state);
    double lowest  = std::numeric_limits<double>::infinity(),
           highest = -std::numeric_limits<double>::infinity();
    for (const double T : report.heat->temperature)
      {
        // not a number where there is no ply
        lowest  = std::fmin(lowest, T);
        highest = std::fmax(highest, T);
      }
    out << "  temperatures of the plies: " << lowest << " to " << highest;
    if (report.n_heat_rounds > 0)
      out << ", settled in " << report.n_heat_rounds << " rounds";
    out << std::endl;
  }


  void
  RollingReport::warn_of_fast_wheel(const StageRun   &run,
                                    const StepReport &report)
  {
    // without mass there are neither centrifugal forces nor standing waves
    const auto &strips = run.contact.mesh.strips;
    if (warned || report.n_negative_pivots.value_or(0) == 0 ||
        report.loads->rolling->angular_velocity == 0 ||
        std::none_of(strips.begin(), strips.end(), [](const Strip &strip) {
          return strip.laminate.mass_moments()[0][0] > 0;
        }))
      return;
    const std::vector<double> &lines = run.contact.mesh.grid.lines[1];
    double                     angle = 0;
    for (std::size_t i = 1; i < lines.size(); ++i)
      angle = std::max(angle, lines[i] - lines[i - 1]);
    out << "  Warning: the tangent has negative pivots at the angular velocity "
        << number_to_string(report.loads->rolling->angular_velocity)
        << ". Either it is above the critical velocity at which standing "
           "waves form, or the cells, of up to "
        << number_to_string(std::round(angle * 180 / numbers::PI))
        << " degrees around the axle, are too large to resolve the inertia: "
           "compare with cells of half the angle."
        << std::endl;
    warned = true;
  }
} // namespace Biface
