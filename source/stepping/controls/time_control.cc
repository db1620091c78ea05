// SPDX-License-Identifier: LGPL-2.1-or-later

#include <algorithm>
#include <cmath>
#include <limits>

#include <biface/stepping/controls/time_control.h>

namespace Biface
{
  TimeControl::TimeControl(const Stage                &stage,
                           const Parameters           &parameters,
                           const ControlledResultants &forces)
    : LoadControl(stage, parameters), forces(forces)
  {}


  void
  TimeControl::check(const std::string &section, const KnownStart &start) const
  {
    LoadControl::check(section, start);
    for (const auto &resultant : forces)
      resultant->check(stage, section, start);
  }


  void
  TimeControl::check(const std::string &section, const ShellMesh &mesh) const
  {
    Biface::check(forces, section, mesh);
  }


  Control::KnownStart
  TimeControl::known_end(const KnownStart &start) const
  {
    return without_found_loads(forces, LoadControl::known_end(start));
  }


  Control::Trial
  TimeControl::propose(const Equilibrium &from) const
  {
    const double begin = fraction, end = next();
    // masses start from where they are
    const LoadParameters here = found_loads(forces, from.level);
    const auto           at   = [this, begin, end, here](const double part) {
      return with_found_loads(
        forces, level_in_time(begin + part * (end - begin)), here);
    };
    Trial trial  = LoadControl::propose(from);
    trial.within = at;
    if (forces.empty())
      {
        trial.level = [this](const LoadParameters &mu) {
          return level_in_time(mu[0]);
        };
        return trial;
      }
    trial.level = [this, at_end = at(1)](const LoadParameters &mu) {
      return with_found_loads(forces, at_end, mu);
    };
    trial.mu        = here;
    trial.equations = std::make_shared<const ResultantEquations>(
      forces, forces_at((begin + end) / 2), &from.contact);
    return trial;
  }


  std::vector<double>
  TimeControl::forces_at(const double at) const
  {
    std::vector<double> result;
    for (const MotionByForce &motion : stage.motions_by_force)
      result.push_back(stage.histories.value(motion.name(), at * stage.duration)
                         .value_or(motion.force));
    if (stage.prescribes_axle_moment())
      result.push_back(stage.histories.value("axle moment", at * stage.duration)
                         .value_or(stage.axle_moment));
    return result;
  }


  void
  TimeControl::change_path(const Stage &now, const LoadLevel &reached)
  {
    // loads that forces find follow no path
    const LoadParameters at_start = found_loads(forces, start);
    go_on_from(common_part(progressions_of_loads(
                 with_found_loads(forces, reached, at_start),
                 with_found_loads(forces, now.end(start), at_start))),
               reached);
  }


  LoadLevel
  TimeControl::level_in_time(const double fraction) const
  {
    LoadLevel    level = level_at(fraction);
    const double t     = fraction * stage.duration;
    const auto   value = [&](const std::string &name) {
      return stage.histories.value(name, t);
    };
    const auto common = value("load factor");
    for (unsigned int i = 0; i < level.factors.size(); ++i)
      {
        // of each load the last name that is given counts
        std::optional<double> factor = common;
        for (const std::string &name : stage.names_of_factors[i])
          for (const auto &own : stage.own_factors)
            if (own.first == name)
              factor = value(name);
        level.factors[i] = factor.value_or(level.factors[i]);
      }
    level.pressure = value("pressure").value_or(level.pressure);
    level.travel   = value("travel").value_or(level.travel);
    level.turn     = value("turn").value_or(level.turn);
    level.angular_velocity =
      value("angular velocity").value_or(level.angular_velocity);
    level.ground_velocity =
      value("ground velocity").value_or(level.ground_velocity);
    level.slip_angle = value("slip angle").value_or(level.slip_angle);
    return level;
  }


  bool
  TimeControl::shorten(const double error_in_time)
  {
    constexpr double reserve = 0.9, minimum = 0.1, maximum = 0.7;
    // part of the stage below which round-off of the time matters
    constexpr double shortest = 1e-9;

    const double part = std::clamp(
      reserve * std::sqrt(stage.time_error / error_in_time), minimum, maximum);
    if (!(part * step_size() > shortest))
      return false;
    scale_step(part);
    return true;
  }


  void
  TimeControl::accept(const Step &step)
  {
    // the next step has the error that is wanted if this one tells, with some
    // reserve; steps at rest do not
    constexpr double reserve = 0.9, maximum_growth = 2, minimum_growth = 0.2;
    // however quiet it is, a stage has as many steps
    constexpr double minimum_steps = 20;

    if (stage.time_error == 0)
      {
        LoadControl::accept(step);
        return;
      }
    fraction = next();
    const double growth =
      step.error_in_time > 0
        ? reserve * std::sqrt(stage.time_error / step.error_in_time)
        : maximum_growth;
    size.succeeded(std::clamp(growth, minimum_growth, maximum_growth),
                   1 / minimum_steps);
  }
} // namespace Biface
