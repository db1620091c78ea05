// SPDX-License-Identifier: LGPL-2.1-or-later

#include <cmath>

#include <biface/base/errors.h>
#include <biface/input/parameter_tools.h>
#include <biface/model/axle_moment.h>
#include <biface/stepping/controls/axle_moment_control.h>

namespace Biface
{
  using namespace dealii;

  namespace
  {
    /** The moment of the axle is prescribed; the load parameter is the angular
     * velocity. */
    class AxleMomentEquation : public ControlEquation
    {
    public:
      explicit AxleMomentEquation(const double moment)
        : ControlEquation(unit_velocity()), moment(moment)
      {}

      double
      parameter_change(const Iteration  &iteration,
                       const LA::Vector &dV_R,
                       const LA::Vector &dV_q) const override
      {
        const AxleMoment now =
          axle_moment(iteration.equations, iteration.state, iteration.loads);
        return (moment - now.value - now.gradient * dV_R) /
               (now.gradient * dV_q + now.per_angular_velocity);
      }

      double
      violation(const Iteration &iteration) const override
      {
        const AxleMoment now =
          axle_moment(iteration.equations, iteration.state, iteration.loads);
        // free rolling prescribes zero: relative to what the force on the
        // ground would exert at the radius
        const double force =
          iteration.contact.force(iteration.state, iteration.loads).value;
        const double radius = iteration.loads.foundation->clearance(Point<3>());
        return std::abs(now.value - moment) /
               (std::abs(moment) + std::abs(force * radius));
      }

    private:
      static LoadRates
      unit_velocity()
      {
        LoadRates rates;
        rates.angular_velocity = 1;
        return rates;
      }

      const double moment;
    };
  } // namespace


  void
  AxleMomentControl::check(const std::string &section,
                           const KnownStart  &start) const
  {
    if (!stage.contact)
      throw InputError(
        section + "/Control", "axle moment", "it needs 'Contact = true'");
    if (stage.angular_velocity)
      throw InputError(section + "/Angular velocity",
                       number_to_string(*stage.angular_velocity),
                       "with 'Control = axle moment' it must not be set: it is "
                       "computed");
    const double velocity =
      stage.ground_velocity.value_or(start.ground_velocity.value_or(0));
    if (velocity == 0)
      throw InputError(section + "/Ground velocity",
                       stage.ground_velocity ? "0" : "unchanged",
                       "with 'Control = axle moment' the wheel must move over "
                       "the ground");
    check_finite(section + "/Axle moment", stage.axle_moment);
  }


  Control::KnownStart
  AxleMomentControl::known_end(const KnownStart &start) const
  {
    KnownStart end = EqualSteps::known_end(start);
    end.angular_velocity.reset();
    return end;
  }


  void
  AxleMomentControl::begin(const Equilibrium &from)
  {
    EqualSteps::begin(from);
    start_moment =
      axle_moment(from.equations, from.state, from.loads(from.level)).value;
  }


  Control::Trial
  AxleMomentControl::propose(const Equilibrium &from) const
  {
    const double part = next();
    Trial        trial;
    trial.level = [this, part](const double angular_velocity) {
      LoadLevel level        = level_at(part);
      level.angular_velocity = angular_velocity;
      return level;
    };
    // at the same slip, or as a rigid wheel of the same height
    const double velocity = level_at(part).ground_velocity;
    trial.mu =
      (from.level.ground_velocity != 0
         ? from.level.angular_velocity * velocity / from.level.ground_velocity
         : velocity /
             std::abs(
               from.loads(from.level).foundation->clearance(Point<3>())));
    trial.equation =
      std::make_shared<const AxleMomentEquation>(moment_at(part));
    trial.size = part - fraction;
    return trial;
  }


  double
  AxleMomentControl::moment_at(const double fraction) const
  {
    return start_moment + fraction * (stage.axle_moment - start_moment);
  }


  Control::Memory
  AxleMomentControl::get_memory() const
  {
    Memory memory                  = EqualSteps::get_memory();
    memory.numbers["start moment"] = start_moment;
    return memory;
  }


  void
  AxleMomentControl::restore(const Memory &memory)
  {
    EqualSteps::restore(memory);
    start_moment = memory.numbers.at("start moment");
  }


  void
  AxleMomentControl::change_way(const Stage &now, const LoadLevel &reached)
  {
    const double     moment = moment_at(fraction);
    std::vector<Way> ways   = ways_of_loads(reached, now.end(start));
    // the angular velocity is unknown
    ways.end()[-2] = {start_moment, moment, now.axle_moment};
    if (!go_on_from(common_part(ways), reached))
      start_moment = moment;
  }
} // namespace Biface
