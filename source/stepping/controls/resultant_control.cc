// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/lac/exceptions.h>
#include <deal.II/lac/lapack_full_matrix.h>
#include <deal.II/lac/vector.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include <biface/base/errors.h>
#include <biface/input/parameter_tools.h>
#include <biface/model/contact/approach.h>
#include <biface/model/contact/contact_interaction.h>
#include <biface/model/contact/contact_pair.h>
#include <biface/model/contact/contact_summary.h>
#include <biface/model/quantities/rolling_summary.h>
#include <biface/model/state/loads.h>
#include <biface/model/state/placed_body.h>
#include <biface/stepping/controls/resultant_control.h>

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

      ContactResultant
      evaluate(const ContactInteraction     &contact,
               const State                  &state,
               const Loads                  &loads,
               const std::vector<LoadRates> &rates) const override
      {
        // a body on the ground carries a part of the force: its power by a unit
        // of the travel
        ContactResultant result =
          ground_force(contact.ground(), state, loads, rates);
        for_each_on_ground(contact, loads, [&](const ContactPair &pair) {
          result += power_of_body(pair, state, loads, rate(), rates);
        });
        return result;
      }

      double
      scale(const double prescribed,
            const ContactResultant & /*now*/,
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
        // the first guess of the angular velocity is proportional to that of
        // the ground: from 0, the wheel would not roll
        const double velocity =
          stage.ground_velocity.value_or(start.ground_velocity.value_or(0));
        if (velocity == 0)
          throw InputError(section + "/Ground velocity",
                           stage.ground_velocity ? "0" : "unchanged",
                           with + "the wheel must move over the ground");
        check_finite(section + "/Axle moment", stage.axle_moment);
      }

      double
      end(const Stage &stage) const override
      {
        return stage.axle_moment;
      }

      ContactResultant
      evaluate(const ContactInteraction     &contact,
               const State                  &state,
               const Loads                  &loads,
               const std::vector<LoadRates> &rates) const override
      {
        return axle_moment(contact.ground(), state, loads, rates);
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
      scale(const double prescribed,
            const ContactResultant & /*now*/,
            const ControlEquations::Iteration &iteration) const override
      {
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
        // at the same slip, or without any
        if (from.level.ground_velocity != 0)
          return from.level.angular_velocity * next.ground_velocity /
                 from.level.ground_velocity;
        // bristles that slide all the way would not tell how to go on
        const ContactPair &ground = from.contact.ground();
        const Loads        loads  = from.loads(next);
        if (ground.body(loads)->laws.bristles())
          if (const auto velocity =
                angular_velocity_without_slip(ground, from.state, loads))
            return *velocity;
        // as a rigid wheel of the same height
        return next.ground_velocity /
               std::abs(loads.ground()->clearance(Point<3>()));
      }
    };


    class ControlledMotion : public ControlledResultant
    {
    public:
      ControlledMotion(const MotionByForce &of_stage,
                       const unsigned int   n_factors)
        : of_stage(of_stage)
        , factor(of_stage.motion.factor)
        , amplitude(of_stage.motion.amplitude())
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

      ContactResultant
      evaluate(const ContactInteraction     &contact,
               const State                  &state,
               const Loads                  &loads,
               const std::vector<LoadRates> &rates) const override
      {
        ContactResultant result =
          power_of_body(pair(contact), state, loads, rate(), rates);
        // the power by a unit of the factor becomes a force along the
        // translation, or a moment about the axis of a motion that only turns
        result.value /= amplitude;
        result.magnitude /= amplitude;
        result.gradient /= amplitude;
        for (double &per_load : result.per_load)
          per_load /= amplitude;

        // the spring takes its part of the force
        const double spring = of_stage.motion.spring * amplitude;
        const double taken  = spring * factor_at(loads.factors, factor);
        result.value += taken;
        result.magnitude += std::abs(taken);
        for (unsigned int i = 0; i < rates.size(); ++i)
          result.per_load[i] += spring * factor_at(rates[i].factors, factor);
        return result;
      }

      double
      scale(const double            prescribed,
            const ContactResultant &now,
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
        // a spring determines the place without contact, and a body without
        // force may stay where it is
        const ContactPair &body = pair(iteration.contact);
        if (of_stage.motion.spring > 0 || prescribed == 0 ||
            count_active(body, iteration.state) > 0)
          return {};
        // into the shell by a small part of its thickness
        LoadRates direction = rate();
        // by a unit of the motion, in the direction of the force
        direction.factors[factor] =
          std::copysign(1., prescribed * amplitude) / std::abs(amplitude);
        const double way =
          distance_to_contact(body,
                              iteration.state,
                              iteration.loads,
                              direction,
                              0.01 * iteration.contact.mesh.thickness());
        return way * direction.factors[factor];
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

      const MotionByForce of_stage;
      const unsigned int  factor;
      const double        amplitude;
      const unsigned int  n_factors;
    };


    std::vector<LoadRates>
    rates_of(const ResultantControl::Resultants &resultants)
    {
      std::vector<LoadRates> rates;
      for (const auto &resultant : resultants)
        rates.push_back(resultant->rate());
      return rates;
    }


    /** Solve a small linear system; the solution is not finite if there is
     * none. */
    std::vector<double>
    solve(LAPACKFullMatrix<double> &matrix, Vector<double> &rhs)
    {
      try
        {
          matrix.compute_lu_factorization();
        }
      catch (const LACExceptions::ExcSingular &)
        {
          return std::vector<double>(rhs.size(),
                                     std::numeric_limits<double>::quiet_NaN());
        }
      matrix.solve(rhs);
      return std::vector<double>(rhs.begin(), rhs.end());
    }


    class ResultantEquations : public ControlEquations
    {
    public:
      ResultantEquations(const ResultantControl::Resultants &resultants,
                         const std::vector<double>          &values)
        : ControlEquations(rates_of(resultants))
        , resultants(resultants)
        , values(values)
      {}

      LoadParameters
      parameter_changes(const Iteration               &iteration,
                        const LA::Vector              &dV_R,
                        const std::vector<LA::Vector> &dV_q) const override
      {
        // out of contact a resultant and its derivatives vanish, and the system
        // is singular: first this load alone moves
        const unsigned int n = resultants.size();
        for (unsigned int i = 0; i < n; ++i)
          if (const auto change =
                resultants[i]->change_into_contact(values[i], iteration))
            {
              LoadParameters changes(n);
              changes[i] = *change;
              return changes;
            }

        LoadParameters changes =
          parameter_changes_about(iteration, iteration, dV_R, dV_q);
        // all changes are shortened alike, to keep the direction of the linear
        // solution
        double part = 1;
        for (unsigned int i = 0; i < n; ++i)
          if (std::isfinite(changes[i]))
            part = std::min(
              part, resultants[i]->largest_change() / std::abs(changes[i]));
        for (double &change : changes)
          change *= part;
        return changes;
      }

      LoadParameters
      parameter_changes_about(
        const Iteration               &about,
        const Iteration               &iteration,
        const LA::Vector              &dV_R,
        const std::vector<LA::Vector> &dV_q) const override
      {
        // the system of section 7, with a row for each resultant and a column
        // for each unknown load
        const unsigned int       n = resultants.size();
        LAPACKFullMatrix<double> matrix(n);
        Vector<double>           missing(n);
        for (unsigned int i = 0; i < n; ++i)
          {
            const ContactResultant linear = resultants[i]->evaluate(
              about.contact, about.state, about.loads, rates);
            // derivatives are those of 'about', what is missing that of the
            // iterate
            const double now =
              (&about == &iteration
                 ? linear.value
                 : resultants[i]
                     ->evaluate(
                       iteration.contact, iteration.state, iteration.loads, {})
                     .value);
            missing[i] = values[i] - now - linear.gradient * dV_R;
            for (unsigned int j = 0; j < n; ++j)
              matrix(i, j) = linear.gradient * dV_q[j] + linear.per_load[j];
            // a body without force that touches nothing stays where it is
            if (values[i] == 0 && linear.magnitude == 0)
              matrix(i, i) = 1;
          }
        return solve(matrix, missing);
      }

      std::string
      remedies() const override
      {
        std::string text;
        for (const auto &resultant : resultants)
          text += (text.empty() ? "" : "; ") + resultant->remedies();
        return text;
      }

      double
      violation(const Iteration &iteration) const override
      {
        double largest = 0;
        for (unsigned int i = 0; i < resultants.size(); ++i)
          {
            const ContactResultant now = resultants[i]->evaluate(
              iteration.contact, iteration.state, iteration.loads, {});
            // also where the scale is 0, as of nothing that touches
            if (now.value == values[i])
              continue;
            const double relative =
              std::abs(now.value - values[i]) /
              resultants[i]->scale(values[i], now, iteration);
            // not a number is none
            largest = (relative <= largest ? largest : relative);
          }
        return largest;
      }

    private:
      const ResultantControl::Resultants resultants;
      const std::vector<double>          values;
    };
  } // namespace


  ResultantControl::ResultantControl(const Stage      &stage,
                                     const Parameters &parameters,
                                     const Resultants &resultants)
    : EqualSteps(stage, parameters)
    , resultants(resultants)
    , start_values(resultants.size())
  {}


  void
  ResultantControl::check(const std::string &section,
                          const KnownStart  &start) const
  {
    for (const auto &resultant : resultants)
      resultant->check(stage, section, start);
  }


  Control::KnownStart
  ResultantControl::known_end(const KnownStart &start) const
  {
    KnownStart end = EqualSteps::known_end(start);
    // found in the run, so that later stages cannot be checked against it
    for (const auto &resultant : resultants)
      resultant->known_load(end).reset();
    return end;
  }


  void
  ResultantControl::begin(const Equilibrium &from)
  {
    EqualSteps::begin(from);
    // without pressure no moment depends on the angular velocity
    const bool needs_contact =
      resultants.size() > 1 &&
      std::any_of(resultants.begin(), resultants.end(), [](const auto &item) {
        return item->needs_contact();
      });
    if (needs_contact && count_active(from.contact.ground(), from.state) == 0)
      throw InputError("the stage '" + stage.name +
                       "' has 'Control = " + stage.control_name() +
                       "' and must start in contact, such as after a stage "
                       "with 'Control = foundation force'.");
    // the path starts from what ground and bodies exert here, so that the first
    // step is no larger than the others
    const Loads loads = from.loads(from.level);
    for (unsigned int i = 0; i < resultants.size(); ++i)
      start_values[i] =
        resultants[i]->evaluate(from.contact, from.state, loads, {}).value;
  }


  Control::Trial
  ResultantControl::propose(const Equilibrium &from) const
  {
    const double    part = next();
    const LoadLevel end  = level_at(part);
    Trial           trial;
    // all other loads follow the fraction of the stage
    trial.level = [this, end](const LoadParameters &mu) {
      LoadLevel level = end;
      for (unsigned int i = 0; i < resultants.size(); ++i)
        resultants[i]->load(level) = mu[i];
      return level;
    };
    trial.mu.clear();
    for (const auto &resultant : resultants)
      trial.mu.push_back(resultant->guess(from, end));
    trial.equations =
      std::make_shared<const ResultantEquations>(resultants, values_at(part));
    trial.size = part - fraction;
    return trial;
  }


  std::vector<double>
  ResultantControl::values_at(const double fraction) const
  {
    std::vector<double> values(start_values);
    for (unsigned int i = 0; i < values.size(); ++i)
      values[i] += fraction * (resultants[i]->end(stage) - start_values[i]);
    return values;
  }


  Control::Memory
  ResultantControl::get_memory() const
  {
    Memory memory = EqualSteps::get_memory();
    for (unsigned int i = 0; i < resultants.size(); ++i)
      memory.numbers["start " + resultants[i]->name()] = start_values[i];
    return memory;
  }


  void
  ResultantControl::restore(const Memory &memory)
  {
    EqualSteps::restore(memory);
    for (unsigned int i = 0; i < resultants.size(); ++i)
      start_values[i] = memory.numbers.at("start " + resultants[i]->name());
  }


  void
  ResultantControl::change_path(const Stage &now, const LoadLevel &reached)
  {
    const std::vector<double> values = values_at(fraction);
    // the unknown loads follow no path
    LoadLevel from = reached, to = now.end(start);
    for (const auto &resultant : resultants)
      resultant->load(from) = resultant->load(to) = resultant->load(start);
    std::vector<Progression> progressions = progressions_of_loads(from, to);
    for (unsigned int i = 0; i < resultants.size(); ++i)
      progressions.push_back(
        {start_values[i], values[i], resultants[i]->end(now)});
    // loads and resultants that are on no common part of the new path are its
    // start
    if (!go_on_from(common_part(progressions), reached))
      start_values = values;
  }


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
    return std::make_shared<ControlledMotion>(motion, n_factors);
  }
} // namespace Biface
