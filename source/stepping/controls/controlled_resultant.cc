// SPDX-License-Identifier: LGPL-2.1-or-later

#include <algorithm>
#include <cmath>
#include <limits>

#include <biface/base/errors.h>
#include <biface/input/parameter_tools.h>
#include <biface/model/contact/approach.h>
#include <biface/model/contact/contact_interaction.h>
#include <biface/model/contact/contact_pair.h>
#include <biface/model/contact/contact_summary.h>
#include <biface/model/equations/equation_system.h>
#include <biface/model/mesh/support_motion.h>
#include <biface/model/quantities/contact_resultants.h>
#include <biface/model/quantities/rolling_summary.h>
#include <biface/model/state/loads.h>
#include <biface/model/state/placed_body.h>
#include <biface/model/state/step_in_time.h>
#include <biface/model/time/axle_moment_in_time.h>
#include <biface/stepping/controls/controlled_resultant.h>

namespace Biface
{
  using namespace dealii;

  namespace
  {
    void
    check_ground(const Stage &stage, const std::string &section)
    {
      if (!stage.contact)
        throw InputError(section + "/Control",
                         stage.control_name(),
                         "it needs 'Contact = true'");
    }


    class ControlledForce : public ControlledResultant
    {
    public:
      std::string
      name() const override
      {
        return "force";
      }

      void
      check(const Stage       &stage,
            const std::string &section,
            const Control::KnownStart & /*start*/) const override
      {
        check_ground(stage, section);
        // it is the unknown: a given one would be left out without a word
        if (stage.travel.value_or(0) != 0)
          throw InputError(section + "/Travel",
                           number_to_string(*stage.travel),
                           "with 'Control = " + stage.control_name() +
                             "' it must not be set: the travel is computed");
        check_positive(section + "/Force", stage.force);
      }

      double
      end(const Stage &stage) const override
      {
        return stage.force;
      }

      LinearizedResultant
      evaluate(const LoadedShell            &at,
               const std::vector<LoadRates> &rates) const override
      {
        // a body on the ground carries a part of the force: its power by a unit
        // of the travel
        LinearizedResultant result =
          ground_force(at.contact.ground(), at.state, at.loads, rates);
        for_each_on_ground(at.contact, at.loads, [&](const ContactPair &pair) {
          result += power_of_body(pair, at.state, at.loads, rate(), rates);
        });
        return result;
      }

      double
      scale(const double prescribed,
            const LinearizedResultant & /*now*/,
            const ControlEquations::Iteration & /*iteration*/) const override
      {
        return std::abs(prescribed);
      }

      double &
      load(LoadLevel &level) const override
      {
        return level.travel;
      }

      std::optional<double> &
      known_load(Control::KnownStart &start) const override
      {
        return start.travel;
      }

      LoadRates
      rate() const override
      {
        LoadRates rates;
        rates.travel = 1;
        return rates;
      }

      double
      guess(const Control::Equilibrium &from,
            const LoadLevel & /*next*/) const override
      {
        // out of contact the force does not depend on the travel, and no
        // linearization tells how far to go
        double      travel = from.level.travel;
        const Loads loads  = from.loads(from.level);
        if (!touches(from.contact, from.state, loads))
          travel += beyond_touch(from.contact, from.state, loads);
        return travel;
      }

      std::string
      remedies() const override
      {
        return "a stage of prescribed 'Travel' before, in which the shell "
               "comes to rest on the ground";
      }

      std::optional<double>
      change_into_contact(
        const double /*prescribed*/,
        const ControlEquations::Iteration &iteration) const override
      {
        if (touches(iteration.contact, iteration.state, iteration.loads))
          return {};
        return beyond_touch(
          iteration.contact, iteration.state, iteration.loads);
      }

    private:
      /** Call a function for the bodies that are on the ground. */
      template <typename Function>
      static void
      for_each_on_ground(const ContactInteraction &contact,
                         const Loads              &loads,
                         const Function           &function)
      {
        for (const ContactPair *pair : contact.present(loads))
          if (pair->moving_body.is_on_ground())
            function(*pair);
      }

      /** Whether the ground, or a body on it, is in contact. */
      static bool
      touches(const ContactInteraction &contact,
              const State              &state,
              const Loads              &loads)
      {
        bool any = count_active(contact.ground(), state) > 0;
        for_each_on_ground(contact, loads, [&](const ContactPair &pair) {
          any = count_active(pair, state) > 0 || any;
        });
        return any;
      }

      /** The travel until the ground touches, and a little further to get
       * into contact. */
      static double
      beyond_touch(const ContactInteraction &contact,
                   const State              &state,
                   const Loads              &loads)
      {
        return remaining_travel(contact.ground(), state, loads) +
               0.01 * contact.mesh.thickness();
      }
    };


    class ControlledAxleMoment : public ControlledResultant
    {
    public:
      std::string
      name() const override
      {
        return "moment";
      }

      void
      check(const Stage               &stage,
            const std::string         &section,
            const Control::KnownStart &start) const override
      {
        check_ground(stage, section);
        const std::string with =
          "with 'Control = " + stage.control_name() + "' ";
        if (stage.angular_velocity)
          throw InputError(section + "/Angular velocity",
                           number_to_string(*stage.angular_velocity),
                           with + "it must not be set: it is computed");
        check_finite(section + "/Axle moment", stage.axle_moment);
        if (stage.inertia)
          return;
        // the first guess of the angular velocity is proportional to that of
        // the ground: from 0, the wheel would not roll
        const double velocity =
          stage.ground_velocity.value_or(start.ground_velocity.value_or(0));
        if (velocity == 0)
          throw InputError(section + "/Ground velocity",
                           stage.ground_velocity ? "0" : "unchanged",
                           with + "the wheel must move over the ground");
      }

      double
      end(const Stage &stage) const override
      {
        return stage.axle_moment;
      }

      LinearizedResultant
      evaluate(const LoadedShell            &at,
               const std::vector<LoadRates> &rates) const override
      {
        return at.state.step
                 ? axle_moment_in_time(at.contact, at.state, at.loads, rates)
                 : axle_moment(at.contact, at.state, at.loads, rates);
      }

      std::string
      remedies() const override
      {
        return "a stage before in which the wheel is pressed on the ground, "
               "and 'Friction' with it";
      }

      bool
      needs_contact() const override
      {
        return true;
      }

      double
      scale(const double                       prescribed,
            const LinearizedResultant         &now,
            const ControlEquations::Iteration &iteration) const override
      {
        if (iteration.state.step)
          return std::abs(prescribed) + now.magnitude;
        // free rolling prescribes zero: relative to what the force on the
        // ground would exert at the radius
        const double force = ground_force(iteration.contact.ground(),
                                          iteration.state,
                                          iteration.loads)
                               .value;
        return std::abs(prescribed) +
               std::abs(force *
                        iteration.loads.ground()->clearance(Point<3>()));
      }

      double &
      load(LoadLevel &level) const override
      {
        return level.angular_velocity;
      }

      std::optional<double> &
      known_load(Control::KnownStart &start) const override
      {
        return start.angular_velocity;
      }

      LoadRates
      rate() const override
      {
        LoadRates rates;
        rates.angular_velocity = 1;
        return rates;
      }

      double
      guess(const Control::Equilibrium &from,
            const LoadLevel            &next) const override
      {
        // bristles that slide all the way would not tell how to go on
        const ContactPair    &ground = from.contact.ground();
        const Loads           loads  = from.loads(next);
        std::optional<double> without_slip;
        if (ground.body(loads)->laws.bristles())
          without_slip =
            angular_velocity_without_slip(ground, from.state, loads);
        // at the same slip, unless it is no slip of a rolling wheel, such as
        // after a moment that has come in no time
        constexpr double largest_slip = 2;
        if (from.level.ground_velocity != 0)
          {
            const double same_slip = from.level.angular_velocity *
                                     next.ground_velocity /
                                     from.level.ground_velocity;
            if (!without_slip || std::abs(same_slip - *without_slip) <=
                                   largest_slip * std::abs(*without_slip))
              return same_slip;
          }
        if (without_slip)
          return *without_slip;
        // as a rigid wheel of the same height
        return next.ground_velocity /
               std::abs(loads.ground()->clearance(Point<3>()));
      }
    };


    /** The force that moves what has a factor of its own: a body, or supports.
     */
    class ControlledMotion : public ControlledResultant
    {
    public:
      ControlledMotion(const MotionByForce &of_stage,
                       const unsigned int   n_factors)
        : of_stage(of_stage)
        , factor(of_stage.motion.factor)
        , n_factors(n_factors)
      {}

      std::string
      name() const override
      {
        return "force on " + of_stage.name();
      }

      double
      end(const Stage &stage) const override
      {
        for (const MotionByForce &item : stage.motions_by_force)
          if (item.name() == of_stage.name())
            return item.force;
        Assert(false, ExcInternalError());
        return 0;
      }

      LinearizedResultant
      evaluate(const LoadedShell            &at,
               const std::vector<LoadRates> &rates) const override
      {
        const double amplitude     = this->amplitude(at.equations.mesh),
                     whole         = multiple(at.equations.mesh);
        LinearizedResultant result = power(at, rates);
        // the power by a unit of the factor becomes a force along the
        // translation, or a moment about the axis of a motion that only turns
        result.value *= whole / amplitude;
        result.magnitude *= whole / std::abs(amplitude);
        result.gradient *= whole / amplitude;
        for (double &per_load : result.per_load)
          per_load *= whole / amplitude;

        // spring, mass and damper take their parts of the force
        MovingMass::Resistance taken;
        if (at.state.step)
          taken = at.state.step->mass_with(factor).resistance(at.loads);
        else
          {
            taken.derivative = of_stage.motion.suspension.spring / whole;
            taken.value      = taken.derivative * amplitude *
                          factor_at(at.loads.factors, factor);
            taken.magnitude = std::abs(taken.value);
          }
        result.value += whole * taken.value;
        result.magnitude += whole * taken.magnitude;
        for (unsigned int i = 0; i < rates.size(); ++i)
          result.per_load[i] += whole * taken.derivative * amplitude *
                                factor_at(rates[i].factors, factor);
        return result;
      }

      double
      scale(const double               prescribed,
            const LinearizedResultant &now,
            const ControlEquations::Iteration & /*iteration*/) const override
      {
        // for a body that gives way the prescribed force is 0, and round-off is
        // in proportion to the forces that cancel
        return std::abs(prescribed) + now.magnitude;
      }

      double &
      load(LoadLevel &level) const override
      {
        return level.factors[factor];
      }

      std::optional<double> &
      known_load(Control::KnownStart &start) const override
      {
        return start.factors[factor];
      }

      LoadRates
      rate() const override
      {
        LoadRates rates;
        rates.factors.assign(n_factors, 0);
        rates.factors[factor] = 1;
        return rates;
      }

      double
      guess(const Control::Equilibrium &from,
            const LoadLevel & /*next*/) const override
      {
        return factor_at(from.level.factors, factor);
      }

    protected:
      /** The displacement, or the angle, to which the force refers, at the
       * factor 1. */
      virtual double
      amplitude(const ShellMesh &mesh) const = 0;

      /** How often the part that is modeled occurs in the structure to which
       * the force refers. */
      virtual double
      multiple(const ShellMesh & /*mesh*/) const
      {
        return 1;
      }

      /** The power by a unit of the rate of the factor. */
      virtual LinearizedResultant
      power(const LoadedShell            &at,
            const std::vector<LoadRates> &rates) const = 0;

      const MotionByForce of_stage;
      const unsigned int  factor;

    private:
      const unsigned int n_factors;
    };


    class ControlledBody : public ControlledMotion
    {
    public:
      using ControlledMotion::ControlledMotion;

      std::string
      remedies() const override
      {
        return "a stage of prescribed motion before, in which the body " +
               quoted(of_stage.name()) +
               " comes to rest at the shell, a direction in which it meets the "
               "shell, or a spring";
      }

      double
      largest_change() const override
      {
        constexpr double largest_turn = 0.1;

        // in radians: beyond it, a turn is far from its linearization
        const double turn = std::abs(of_stage.motion.turn);
        return turn > 0 ? largest_turn / turn
                        : std::numeric_limits<double>::infinity();
      }

      std::optional<double>
      change_into_contact(
        const double                       prescribed,
        const ControlEquations::Iteration &iteration) const override
      {
        // a spring determines the place without contact, a mass flies, and a
        // body without force may stay where it is
        if (iteration.state.step || of_stage.motion.suspension.spring > 0 ||
            prescribed == 0)
          return {};
        const ContactPair &body = pair(iteration.contact);
        if (count_active(body, iteration.state) > 0)
          return {};
        // into the shell by a small part of its thickness
        const double amplitude = of_stage.motion.amplitude();
        LoadRates    direction = rate();
        // by a unit of the motion, in the direction of the force
        direction.factors[factor] =
          std::copysign(1., prescribed * amplitude) / std::abs(amplitude);
        const RigidBody &placed = body.body(iteration.loads)->body;
        const double     way    = distance_to_contact(
          body,
          iteration.state,
          iteration.loads,
          [&](const Point<3> &x) { return direction.velocity_of(placed, x); },
          0.01 * iteration.contact.mesh.thickness());
        return way * direction.factors[factor];
      }

    protected:
      double
      amplitude(const ShellMesh & /*mesh*/) const override
      {
        return of_stage.motion.amplitude();
      }

      LinearizedResultant
      power(const LoadedShell            &at,
            const std::vector<LoadRates> &rates) const override
      {
        return power_of_body(
          pair(at.contact), at.state, at.loads, rate(), rates);
      }

    private:
      const ContactPair &
      pair(const ContactInteraction &contact) const
      {
        for (const auto &pair : contact.pairs)
          if (pair->name == of_stage.body && pair.get() != &contact.ground())
            return *pair;
        Assert(false, ExcInternalError());
        return contact.ground();
      }
    };


    class ControlledSupports : public ControlledMotion
    {
    public:
      using ControlledMotion::ControlledMotion;

      void
      check_mesh(const std::string &section,
                 const ShellMesh   &mesh) const override
      {
        if (!common_motion(mesh.supported.motions, factor))
          throw InputError(
            section + "/Forces on bodies",
            of_stage.name(),
            has_motion(mesh)
              ? "all supports of this name must move by the same displacement, "
                "and be the same part of the whole structure"
              : "a support must have this name: with a displacement that is not "
                "zero, and without a name of its own in 'Forces on bodies' or "
                "'Load factors'");
      }

      std::string
      remedies() const override
      {
        return "other supports, or bodies, that hold the shell where " +
               quoted(of_stage.name()) +
               " gives way, one name for all supports that move together, or a "
               "spring";
      }

      bool
      is_held_elsewhere() const override
      {
        return true;
      }

      std::optional<double>
      change_into_contact(
        const double                       prescribed,
        const ControlEquations::Iteration &iteration) const override
      {
        const SupportMotion along = motion(iteration.equations.mesh);
        if (iteration.state.step || of_stage.motion.suspension.spring > 0 ||
            prescribed == 0 || along.kind != SupportMotion::Kind::translation ||
            iteration.contact.count_active(iteration.state) > 0)
          return {};
        // the shell follows its supports as a rigid body: by a small part of
        // its thickness into what it meets first
        const double sign = std::copysign(1., prescribed);
        double       way  = std::numeric_limits<double>::infinity();
        for (const ContactPair *pair :
             iteration.contact.present(iteration.loads))
          way = std::min(
            way,
            distance_to_contact(
              *pair,
              iteration.state,
              iteration.loads,
              [&](const Point<3> &) { return -sign * along.direction; },
              0.01 * iteration.contact.mesh.thickness()));
        return way * sign / along.amount;
      }

    protected:
      double
      amplitude(const ShellMesh &mesh) const override
      {
        return motion(mesh).amount;
      }

      LinearizedResultant
      power(const LoadedShell            &at,
            const std::vector<LoadRates> &rates) const override
      {
        return at.equations.power_of_supports(
          at.state, at.loads, rate(), rates);
      }

      double
      multiple(const ShellMesh &mesh) const override
      {
        return motion(mesh).multiple;
      }

    private:
      bool
      has_motion(const ShellMesh &mesh) const
      {
        const auto &motions = mesh.supported.motions;
        return std::any_of(
          motions.begin(), motions.end(), [this](const SupportMotion &item) {
            return item.factor == factor;
          });
      }

      SupportMotion
      motion(const ShellMesh &mesh) const
      {
        const auto result = common_motion(mesh.supported.motions, factor);
        AssertThrow(result, ExcInternalError());
        return *result;
      }
    };
  } // namespace


  std::shared_ptr<const ControlledResultant>
  controlled_force()
  {
    return std::make_shared<ControlledForce>();
  }


  std::shared_ptr<const ControlledResultant>
  controlled_axle_moment()
  {
    return std::make_shared<ControlledAxleMoment>();
  }


  std::shared_ptr<const ControlledResultant>
  controlled_motion(const MotionByForce &motion, const unsigned int n_factors)
  {
    if (motion.moves_supports())
      return std::make_shared<ControlledSupports>(motion, n_factors);
    return std::make_shared<ControlledBody>(motion, n_factors);
  }
} // namespace Biface
