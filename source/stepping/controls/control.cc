// SPDX-License-Identifier: LGPL-2.1-or-later

#include <algorithm>
#include <cmath>

#include <biface/base/errors.h>
#include <biface/input/entry_declarations.h>
#include <biface/model/mesh/shell_mesh.h>
#include <biface/stepping/controls/control.h>

namespace Biface
{
  using namespace dealii;

  void
  ControlParameters::add_parameters(EntryDeclarations &prm)
  {
    prm.add_parameter("Maximum cuts",
                      max_cuts,
                      "Number of times a step that does not converge is "
                      "halved before the run ends.",
                      Patterns::Integer(0, 30));
    prm.add_parameter("Maximum arc steps",
                      max_arc_steps,
                      "Maximum number of steps of a stage with arc-length "
                      "control, after which it ends even if its loads were "
                      "not reached.",
                      Patterns::Integer(1));
    prm.add_parameter("Maximum growth",
                      maximum_growth,
                      "Maximum size of a step in arc-length control or with "
                      "'Adaptive steps', relative to the first step.",
                      Patterns::Double(1),
                      Unit::none());
  }


  Control::Control(const Stage &stage, const Parameters &parameters)
    : stage(stage), parameters(parameters)
  {}


  Control::KnownStart
  Control::known_end(const KnownStart &start) const
  {
    const KnownStart from = with_factors(start, stage.factors.size());
    KnownStart       end  = with_factors(KnownStart(), stage.factors.size());
    for_each_load(
      [](auto &known, const auto &prescribed, const auto &at_start) {
        known = (prescribed ? prescribed : at_start);
      },
      end,
      stage,
      from);
    // it follows from the rolling radius that the run will find
    if (stage.slip_ratio)
      end.angular_velocity.reset();
    return end;
  }


  void
  Control::begin(const Equilibrium &from)
  {
    start = from.level;
    size  = StepSize(1. / stage.n_steps);
  }


  Control::Memory
  Control::get_memory() const
  {
    Memory memory;
    memory.start = start;
    memory.size  = size;
    memory.done  = done();
    return memory;
  }


  void
  Control::restore(const Memory &memory)
  {
    start = memory.start;
    size  = memory.size;
  }


  bool
  Control::change_stage(const Stage &now, const LoadLevel &reached)
  {
    // other values change where the stage goes, the steps only how it is
    // divided
    bool same_path = stage.force == now.force &&
                     stage.axle_moment == now.axle_moment &&
                     stage.control_value == now.control_value;
    for_each_load(
      [&same_path](const auto &load, const auto &new_load) {
        same_path = same_path && load == new_load;
      },
      stage,
      now);
    if (same_path && stage.n_steps == now.n_steps &&
        stage.adaptive == now.adaptive)
      return false;

    if (!same_path)
      change_path(now, reached);
    stage = now;
    change_size();
    return !same_path;
  }


  std::optional<double>
  Control::common_part(const std::vector<Progression> &progressions)
  {
    std::optional<double> part;
    // by the first one that changes
    for (const Progression &progression : progressions)
      if (!part && progression.end != progression.start)
        part = (progression.now - progression.start) /
               (progression.end - progression.start);
    // if the others have gone another part of their way, the new path does not
    // pass through what was reached; sums of steps have round-off
    for (const Progression &progression : progressions)
      {
        const double done = progression.now - progression.start;
        const double expected =
          part.value_or(0) * (progression.end - progression.start);
        if (std::abs(done - expected) >
            1e-9 * std::max(std::abs(done), std::abs(expected)))
          return {};
      }
    return part;
  }


  std::vector<Control::Progression>
  Control::progressions_of_loads(const LoadLevel &reached,
                                 const LoadLevel &end) const
  {
    const std::vector<double> from = load_components(start),
                              now  = load_components(reached),
                              to   = load_components(end);
    std::vector<Progression> progressions;
    for (unsigned int i = 0; i < from.size(); ++i)
      progressions.push_back({from[i], now[i], to[i]});
    return progressions;
  }


  LoadLevel
  Control::level_at(const double fraction) const
  {
    const LoadLevel end = stage.end(start);
    // the values of the file, without the round-off of an interpolation
    if (fraction == 1)
      return end;
    return interpolated_loads(start, end, fraction);
  }


  LoadRates
  Control::load_rate() const
  {
    const LoadLevel end = stage.end(start);
    LoadRates       rate;
    // without motions of the ground, which check_loads_follow() refuses
    rate.pressure         = end.pressure - start.pressure;
    rate.factors          = change_of_factors(start, end);
    rate.angular_velocity = end.angular_velocity - start.angular_velocity;
    return rate;
  }


  void
  check_loads_follow(const Stage &stage, const Control::KnownStart &start)
  {
    // what is not known before the run may change
    const auto stays = [](const auto &begin, const auto &end) {
      return !end || (begin && *begin == *end);
    };
    const std::string what = "the stage '" + stage.name +
                             "' is controlled by a displacement or an arc "
                             "length, but ";
    bool changes = !stays(start.pressure, stage.pressure);
    for (unsigned int i = 0; i < stage.factors.size(); ++i)
      changes =
        changes || !stays(factor_at(start.factors, i), stage.factors[i]);
    if (!changes)
      throw InputError(what + "neither its pressure nor its load factor "
                              "changes.");
    bool moves = false;
    for_each_motion(
      [&](const auto &begin, const auto &end) {
        // after a given force, the travel is not known
        moves = moves || (begin && !stays(begin, end));
      },
      start,
      stage);
    // a load parameter scales loads, to which motions of the ground do not
    // belong
    if (stage.contact && moves)
      throw InputError(what + "its ground moves, too.");
    if (!(stays(start.ground_velocity, stage.ground_velocity) &&
          stays(start.slip_angle, stage.slip_angle)))
      throw InputError(what + "its ground velocity or slip angle changes, "
                              "too.");
  }


  void
  check_nothing_prescribed(const Stage &stage, const ShellMesh &mesh)
  {
    // like a motion of the ground, a prescribed displacement is no force that a
    // load parameter scales
    for (unsigned int i = 0; i < stage.factors.size(); ++i)
      if (stage.factors[i] && mesh.prescribes_displacements(i))
        throw InputError("the stage '" + stage.name +
                         "' is controlled by a displacement or an arc length, "
                         "but supports prescribe displacements, too.");
  }
} // namespace Biface
