// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/patterns.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <utility>

#include <biface/base/errors.h>
#include <biface/contact/friction_coefficient.h>
#include <biface/input/entry_declarations.h>
#include <biface/input/parameter_tools.h>
#include <biface/problem/rig_protocol.h>
#include <biface/stepping/stage.h>

namespace Biface
{
  using namespace dealii;

  namespace
  {
    // 'Number of stages' has the same limit
    constexpr unsigned int max_points = 1000;


    std::vector<double>
    parse_list(const std::string &entry, const std::string &text)
    {
      return parse_values(entry,
                          text,
                          "it must be a list of numbers 'a, b, c' or "
                          "'begin:end:number'",
                          max_points);
    }


    unsigned int
    parse_start(const std::string &entry, const std::string &text)
    {
      if (text == "last")
        return 0;
      const std::string allowed = "it must be 'last' or the number of a stage";
      const double      number  = parse_number(entry, text, allowed);
      if (!(number >= 1 && number <= max_points &&
            number == std::floor(number)))
        throw InputError(entry, text, allowed);
      return static_cast<unsigned int>(number);
    }
  } // namespace


  void
  RigProtocol::add_parameters(EntryDeclarations &prm)
  {
    // a file without 'Loads' asks for no test, so that the other entries may
    // have values all the same
    const auto add = [&prm](const std::string   &name,
                            const std::string   &default_text,
                            std::vector<double> &values,
                            const std::string   &documentation,
                            const Unit          &unit) {
      add_parsed(
        prm, name, default_text, values, parse_list, documentation, unit);
    };
    add_parsed(prm,
               "Start from",
               "last",
               start_from,
               parse_start,
               "The stage from whose end the test starts: 'last', or its "
               "number. There the tire is inflated and does not roll.");
    add("Loads",
        "",
        loads,
        "Forces between tire and ground, along the normal of the ground, at "
        "which the tire is tested; empty for no test. A list 'a, b, c', in "
        "which 'begin:end:number' stands for so many equidistant values.",
        Unit("force"));
    add("Pressures",
        "",
        pressures,
        "Inflation pressures, likewise; empty for that at the start.",
        Unit("stress"));
    add("Inclination angles",
        "0",
        inclination_angles,
        "Inclination angles of the wheel, likewise; see 'Stage N/Inclination "
        "angle'.",
        Unit::degrees());
    add("Slip angles",
        "",
        slip_angles,
        "Slip angles, likewise, positive if the wheel moves to the left of its "
        "plane; see 'Stage N/Slip angle'. The wheel rolls freely, without a "
        "moment of the axle. Straight rolling is always one of the points.",
        Unit::degrees());
    add("Slip ratios",
        "",
        slip_ratios,
        "Longitudinal slip ratios, likewise, negative for braking: relative to "
        "free rolling with the same load, inclination and slip angle.",
        Unit::none());
    add_choice(
      prm,
      "Slip",
      slip,
      {"pure", "combined"},
      "'pure': slip angles at zero slip ratio, and slip ratios at zero "
      "slip angle; 'combined': every slip angle with every slip "
      "ratio.");
    prm.add_parameter("Ground velocity",
                      ground_velocity,
                      "Speed of the wheel over the ground, positive forward.",
                      Patterns::Double(),
                      Unit("length/time"));
    prm.add_parameter(
      "Steps",
      n_steps,
      "Number of steps from a point to the next one. Steps that "
      "fail are halved.",
      Patterns::Integer(1, 1000));
    add_choice(
      prm,
      "Axes",
      axes,
      rig_axes_names(),
      "The signs in tire_test.csv: 'ISO' (ISO 8855: x forward, y to "
      "the left, z up), 'SAE' (J670e: y to the right, z down), or "
      "'adapted ISO' (as ISO, but slip angle and inclination angle have "
      "the sign of the lateral force that they cause). The entries above are in the "
      "axes of ISO.");
  }


  void
  RigProtocol::check(const std::vector<Stage> &stages) const
  {
    if (!is_requested())
      return;
    if (start_from > stages.size())
      throw InputError("Tire test/Start from",
                       std::to_string(start_from),
                       "it must be 'last' or the number of a stage, 1 to " +
                         std::to_string(stages.size()));
    for (const double load : loads)
      check_positive("Tire test/Loads", load);
    for (const double pressure : pressures)
      check_positive("Tire test/Pressures", pressure);
    for (const double angle : slip_angles)
      if (!(std::abs(angle) < 90))
        throw InputError("Tire test/Slip angles",
                         number_to_string(angle),
                         "it must lie between -90 and 90");
    // a locked wheel has -1; below, it would turn backward
    for (const double ratio : slip_ratios)
      check_at_least("Tire test/Slip ratios", ratio, -1);
    if (inclination_angles.empty())
      throw InputError("Tire test/Inclination angles",
                       "",
                       "it must contain at least one angle, such as 0");
    check_positive("Tire test/Ground velocity", ground_velocity);
    for (const auto &[entry, values] :
         {std::make_pair("Loads", &loads),
          std::make_pair("Pressures", &pressures),
          std::make_pair("Inclination angles", &inclination_angles),
          std::make_pair("Slip angles", &slip_angles),
          std::make_pair("Slip ratios", &slip_ratios)})
      // rows of the table are told apart by these values
      for (auto value = values->begin(); value != values->end(); ++value)
        if (std::count(values->begin(), value, *value) > 0)
          throw InputError(std::string("Tire test/") + entry,
                           number_to_string(*value),
                           "a value must not appear twice");

    // the test adds stages to this one, which must be a start for rolling
    const Stage      &base    = stages[number_of_start(stages) - 1];
    const std::string section = "Tire test/Start from";
    const std::string number =
      start_from == 0 ? "last" : std::to_string(start_from);
    if (!base.bodies.empty())
      throw InputError(section, number, "it must be a stage without 'Bodies'");
    if (base.theory == StrainTheory::linear)
      throw InputError(
        section, number, "it must be a stage with 'Strain theory = nonlinear'");
    // as real numbers, since the product may exceed an integer
    const double n_slips =
      slip == Slip::combined
        ? (slip_angles.size() + 1.) * (slip_ratios.size() + 1.)
        : slip_angles.size() + slip_ratios.size() + 1.;
    const double n = std::max<double>(1, pressures.size()) *
                     inclination_angles.size() * loads.size() * n_slips;
    if (n > max_points)
      throw InputError("the section 'Tire test' asks for " +
                       number_to_string(n) + " points, but at most " +
                       std::to_string(max_points) + " are allowed.");
  }


  namespace
  {
    /** Adds the stages of a tire test to others. */
    class RigStages
    {
    public:
      RigStages(const RigProtocol &test, std::vector<Stage> &stages)
        : test(test), stages(stages), base(test.number_of_start(stages))
      {}

      void
      add_all()
      {
        // a tree of points: a load starts from the one below it, the first load
        // of an inclination angle or a pressure from that of the one before
        load_standing_tire();
        std::vector<double> pressures(test.pressures);
        if (pressures.empty())
          pressures.push_back(0);
        unsigned int of_pressure = stages.size();
        for (const double pressure : pressures)
          {
            if (!test.pressures.empty())
              now.pressure = pressure;
            unsigned int of_inclination = of_pressure;
            for (unsigned int i = 0; i < inclinations.size(); ++i)
              {
                now.inclination_angle = inclinations[i];
                unsigned int of_load  = of_inclination;
                for (unsigned int l = 0; l < loads.size(); ++l)
                  {
                    now.force = loads[l];
                    of_load   = add_load(of_load);
                    if (l == 0)
                      of_inclination = of_load;
                  }
                if (i == 0)
                  of_pressure = of_inclination;
              }
          }
      }

    private:
      const RigProtocol  &test;
      std::vector<Stage> &stages;
      const unsigned int  base;
      /** What is common to the points at hand. */
      Stage        now;
      unsigned int n_points = 0;

      /** From small to large loads and inclinations. */
      const std::vector<double> loads = sorted(test.loads),
                                inclinations =
                                  sorted_by_size(test.inclination_angles);

      static std::vector<double>
      sorted(std::vector<double> values)
      {
        std::sort(values.begin(), values.end());
        return values;
      }

      static std::vector<double>
      sorted_by_size(std::vector<double> values)
      {
        std::stable_sort(
          values.begin(), values.end(), [](const double a, const double b) {
            return std::abs(a) < std::abs(b);
          });
        return values;
      }

      /** The values of one sign, from zero on. */
      static std::vector<double>
      on_side(const std::vector<double> &values, const double sign)
      {
        std::vector<double> result;
        for (const double value : sorted_by_size(values))
          if (value * sign > 0)
            result.push_back(value);
        return result;
      }

      /** The wheel is pressed on the ground before it rolls. */
      void
      load_standing_tire()
      {
        now                   = Stage();
        now.name              = "tire test: load";
        now.sealed            = stages[base - 1].sealed;
        now.contact           = true;
        now.control           = ControlKind::ground_force;
        now.force             = loads.front();
        now.inclination_angle = inclinations.front();
        if (!test.pressures.empty())
          now.pressure = test.pressures.front();
        // that of the tire at the start
        now.laws.penalty_stiffness = stages[base - 1].laws.penalty_stiffness;
        now.laws.tangential_stiffness =
          stages[base - 1].laws.tangential_stiffness;
        // friction of a standing wheel would leave tractions that rolling does
        // not know
        now.laws.friction = std::make_shared<const FrictionCoefficient>();
        now.n_steps       = std::max(6u, test.n_steps);
        now.start_from    = base;
        stages.push_back(now);
        now.laws.friction.reset();
        now.ground_velocity = test.ground_velocity;
        now.n_steps         = test.n_steps;
      }

      /** Add a point that starts from the end of a stage.
       * @return the number of its stage. */
      unsigned int
      add(const unsigned int from, const Stage &point)
      {
        stages.push_back(point);
        stages.back().start_from = from;
        ++n_points;
        // without the first point no other one has a start
        stages.back().may_fail = n_points > 1;
        stages.back().name     = "tire test: point " + std::to_string(n_points);
        return stages.size();
      }

      /** Add the points at a load.
       * @return the number of the stage of straight, free rolling. */
      unsigned int
      add_load(const unsigned int from)
      {
        Stage point             = now;
        point.slip_angle        = 0;
        point.control           = ControlKind::ground_force_and_axle_moment;
        const unsigned int free = add(from, point);
        // slip ratios count from free rolling at the same load and slip angle
        add_slip_ratios(free, 0);
        for (const double side : {1., -1.})
          {
            // from straight rolling to either side, each angle from the one
            // before
            unsigned int previous = free;
            for (const double angle : on_side(test.slip_angles, side))
              {
                point.slip_angle = angle;
                previous         = add(previous, point);
                if (test.slip == RigProtocol::Slip::combined)
                  add_slip_ratios(previous, angle);
              }
          }
        return free;
      }

      void
      add_slip_ratios(const unsigned int from, const double slip_angle)
      {
        Stage point      = now;
        point.slip_angle = slip_angle;
        for (const double side : {1., -1.})
          {
            unsigned int previous = from;
            for (const double ratio : on_side(test.slip_ratios, side))
              {
                point.slip_ratio = ratio;
                previous         = add(previous, point);
              }
          }
      }
    };
  } // namespace


  unsigned int
  RigProtocol::number_of_start(const std::vector<Stage> &stages) const
  {
    return start_from == 0 ? stages.size() : start_from;
  }


  unsigned int
  RigProtocol::append_to(std::vector<Stage> &stages) const
  {
    if (!is_requested())
      return stages.size();
    // one stage more for the standing tire
    const unsigned int first_point = stages.size() + 1;
    RigStages(*this, stages).add_all();
    return first_point;
  }


  std::vector<RigTarget>
  rig_targets(const std::vector<Stage> &stages, const unsigned int first_point)
  {
    const double           nan = std::numeric_limits<double>::quiet_NaN();
    std::vector<RigTarget> targets;
    for (unsigned int i = first_point; i < stages.size(); ++i)
      targets.push_back({stages[i].force,
                         stages[i].pressure.value_or(nan),
                         stages[i].ground_velocity.value_or(nan),
                         stages[i].inclination_angle.value_or(nan),
                         stages[i].slip_angle.value_or(nan),
                         stages[i].slip_ratio.value_or(0)});
    return targets;
  }
} // namespace Biface
