// SPDX-License-Identifier: LGPL-2.1-or-later

#include <algorithm>
#include <cmath>
#include <utility>

#include <biface/base/errors.h>
#include <biface/stepping/controls/arc_length_control.h>
#include <biface/stepping/controls/control.h>
#include <biface/stepping/controls/displacement_control.h>
#include <biface/stepping/controls/load_control.h>
#include <biface/stepping/controls/resultant_control.h>

namespace Biface
{
  using namespace dealii;

  namespace
  {
    template <class Kind>
    std::unique_ptr<Control>
    make(const Stage &stage, const Control::Parameters &parameters)
    {
      return std::make_unique<Kind>(stage, parameters);
    }


    /** All controls, by their names in parameter files. */
    const std::vector<std::pair<std::string, decltype(&make<LoadControl>)>>
      controls{
        {"load", &make<LoadControl>},
        {"displacement", &make<DisplacementControl>},
        {"arc length", &make<ArcLengthControl>},
        {"foundation force", &make<ForceControl>},
        {"axle moment", &make<AxleMomentControl>},
        {"foundation force and axle moment", &make<ForceAndAxleMomentControl>}};
  } // namespace


  std::vector<std::string>
  control_names()
  {
    std::vector<std::string> names;
    for (const auto &control : controls)
      names.push_back(control.first);
    return names;
  }


  std::unique_ptr<Control>
  make_control(const Stage &stage, const Control::Parameters &parameters)
  {
    for (const auto &control : controls)
      if (control.first == stage.control)
        return control.second(stage, parameters);
    Assert(false, ExcInternalError());
    return {};
  }


  void
  Control::Parameters::add_parameters(ParameterHandler &prm)
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
                      "'Adaptive steps', relative to the first step. No unit.",
                      Patterns::Double(1));
  }


  Control::Control(const Stage &stage, const Parameters &parameters)
    : stage(stage), parameters(parameters)
  {}


  Control::KnownStart
  Control::known_end(const KnownStart &start) const
  {
    return {
      stage.pressure ? stage.pressure : start.pressure,
      stage.factor ? stage.factor : start.factor,
      stage.travel ? stage.travel : start.travel,
      stage.slide ? stage.slide : start.slide,
      stage.turn ? stage.turn : start.turn,
      stage.slip_ratio ? std::nullopt
                       : (stage.angular_velocity ? stage.angular_velocity
                                                 : start.angular_velocity),
      stage.ground_velocity ? stage.ground_velocity : start.ground_velocity,
      stage.slip_angle ? stage.slip_angle : start.slip_angle,
      stage.wheel_turn ? stage.wheel_turn : start.wheel_turn,
      false};
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
    const bool same_way =
      stage.pressure == now.pressure && stage.factor == now.factor &&
      stage.travel == now.travel && stage.slide == now.slide &&
      stage.turn == now.turn && stage.force == now.force &&
      stage.angular_velocity == now.angular_velocity &&
      stage.ground_velocity == now.ground_velocity &&
      stage.slip_angle == now.slip_angle &&
      stage.wheel_turn == now.wheel_turn &&
      stage.axle_moment == now.axle_moment &&
      stage.control_value == now.control_value;
    if (same_way && stage.n_steps == now.n_steps &&
        stage.adaptive == now.adaptive)
      return false;

    if (!same_way)
      change_way(now, reached);
    stage = now;
    change_size();
    return !same_way;
  }


  std::optional<double>
  Control::common_part(const std::vector<Way> &ways)
  {
    std::optional<double> part;
    for (const Way &way : ways)
      if (!part && way.end != way.start)
        part = (way.now - way.start) / (way.end - way.start);
    for (const Way &way : ways)
      {
        const double done     = way.now - way.start;
        const double expected = part.value_or(0) * (way.end - way.start);
        if (std::abs(done - expected) >
            1e-9 * std::max(std::abs(done), std::abs(expected)))
          return {};
      }
    return part;
  }


  std::vector<Control::Way>
  Control::ways_of_loads(const LoadLevel &reached, const LoadLevel &end) const
  {
    std::vector<Way> ways{
      {start.pressure, reached.pressure, end.pressure},
      {start.factor, reached.factor, end.factor},
      {start.turn, reached.turn, end.turn},
      {start.ground_velocity, reached.ground_velocity, end.ground_velocity},
      {start.slip_angle, reached.slip_angle, end.slip_angle},
      {start.wheel_turn, reached.wheel_turn, end.wheel_turn}};
    for (unsigned int i = 0; i < 3; ++i)
      ways.push_back({start.slide[i], reached.slide[i], end.slide[i]});
    ways.push_back(
      {start.angular_velocity, reached.angular_velocity, end.angular_velocity});
    ways.push_back({start.travel, reached.travel, end.travel});
    return ways;
  }


  LoadLevel
  Control::level_at(const double fraction) const
  {
    const LoadLevel end = stage.end(start);
    if (fraction == 1)
      return end;
    return {start.pressure + fraction * (end.pressure - start.pressure),
            start.factor + fraction * (end.factor - start.factor),
            start.travel + fraction * (end.travel - start.travel),
            start.slide + fraction * (end.slide - start.slide),
            start.turn + fraction * (end.turn - start.turn),
            start.angular_velocity +
              fraction * (end.angular_velocity - start.angular_velocity),
            start.ground_velocity +
              fraction * (end.ground_velocity - start.ground_velocity),
            start.slip_angle + fraction * (end.slip_angle - start.slip_angle),
            start.wheel_turn + fraction * (end.wheel_turn - start.wheel_turn)};
  }


  LoadRates
  Control::load_rate() const
  {
    const LoadLevel end = stage.end(start);
    LoadRates       rate;
    rate.pressure = end.pressure - start.pressure;
    rate.factor   = end.factor - start.factor;
    return rate;
  }


  void
  check_loads_follow(const Stage &stage, const Control::KnownStart &start)
  {
    const auto stays = [](const auto &begin, const auto &end) {
      return !end || (begin && *begin == *end);
    };
    const std::string what = "the stage '" + stage.name +
                             "' is controlled by a displacement or an arc "
                             "length, but ";
    if (stays(start.pressure, stage.pressure) &&
        stays(start.factor, stage.factor))
      throw InputError(what + "neither its pressure nor its load factor "
                              "changes.");
    if (stage.contact &&
        ((start.travel && !stays(start.travel, stage.travel)) ||
         !stays(start.slide, stage.slide) || !stays(start.turn, stage.turn) ||
         !stays(start.wheel_turn, stage.wheel_turn)))
      throw InputError(what + "its foundation moves, too.");
  }


  void
  check_nothing_prescribed(const Stage &stage, const ShellMesh &mesh)
  {
    if (!mesh.prescribed.empty())
      throw InputError("the stage '" + stage.name +
                       "' is controlled by a displacement or an arc length, "
                       "but supports prescribe displacements, too.");
  }
} // namespace Biface
