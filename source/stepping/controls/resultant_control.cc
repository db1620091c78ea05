// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/lac/exceptions.h>
#include <deal.II/lac/lapack_full_matrix.h>
#include <deal.II/lac/vector.h>

#include <cmath>
#include <limits>

#include <biface/base/errors.h>
#include <biface/input/parameter_tools.h>
#include <biface/model/quantities/rolling_summary.h>
#include <biface/stepping/controls/resultant_control.h>

namespace Biface
{
  using namespace dealii;

  namespace
  {
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

      FoundationResultant
      evaluate(const ContactPair            &ground,
               const State                  &state,
               const Loads                  &loads,
               const std::vector<LoadRates> &rates) const override
      {
        return foundation_force(ground, state, loads, rates);
      }

      double
      scale(const double prescribed,
            const ControlEquations::Iteration & /*iteration*/) const override
      {
        return std::abs(prescribed);
      }

      double LoadLevel::       *
      load() const override
      {
        return &LoadLevel::travel;
      }

      std::optional<double> Control::KnownStart::                      *
      known_load() const override
      {
        return &Control::KnownStart::travel;
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
        double travel = from.level.travel;
        if (from.contact.count_active(from.state) == 0)
          travel +=
            beyond_touch(from.contact, from.state, from.loads(from.level));
        return travel;
      }

      std::optional<double>
      change_to_appear(
        const ControlEquations::Iteration &iteration) const override
      {
        if (iteration.contact.count_active(iteration.state) > 0)
          return {};
        return beyond_touch(
          iteration.contact, iteration.state, iteration.loads);
      }

    private:
      /** The travel until the foundation touches, and a little further to get
       * into contact. */
      static double
      beyond_touch(const ContactInteraction &contact,
                   const State              &state,
                   const Loads              &loads)
      {
        return contact.ground().remaining_travel(state, loads) +
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
        const std::string with =
          "with 'Control = " + stage.control_name() + "' ";
        if (stage.angular_velocity)
          throw InputError(section + "/Angular velocity",
                           number_to_string(*stage.angular_velocity),
                           with + "it must not be set: it is computed");
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

      FoundationResultant
      evaluate(const ContactPair            &ground,
               const State                  &state,
               const Loads                  &loads,
               const std::vector<LoadRates> &rates) const override
      {
        return axle_moment(ground, state, loads, rates);
      }

      double
      scale(const double                       prescribed,
            const ControlEquations::Iteration &iteration) const override
      {
        // free rolling prescribes zero: relative to what the force on the
        // ground would exert at the radius
        const double force = foundation_force(iteration.contact.ground(),
                                              iteration.state,
                                              iteration.loads)
                               .value;
        return std::abs(prescribed) +
               std::abs(force *
                        iteration.loads.ground()->clearance(Point<3>()));
      }

      double LoadLevel::       *
      load() const override
      {
        return &LoadLevel::angular_velocity;
      }

      std::optional<double> Control::KnownStart::                      *
      known_load() const override
      {
        return &Control::KnownStart::angular_velocity;
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
        if (ground.has_bristles(loads))
          if (const auto velocity =
                angular_velocity_without_slip(ground, from.state, loads))
            return *velocity;
        // as a rigid wheel of the same height
        return next.ground_velocity /
               std::abs(loads.ground()->clearance(Point<3>()));
      }
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
        const unsigned int n = resultants.size();
        for (unsigned int i = 0; i < n; ++i)
          if (const auto change = resultants[i]->change_to_appear(iteration))
            {
              LoadParameters changes(n);
              changes[i] = *change;
              return changes;
            }

        LAPACKFullMatrix<double> matrix(n);
        Vector<double>           missing(n);
        for (unsigned int i = 0; i < n; ++i)
          {
            const FoundationResultant now =
              resultants[i]->evaluate(iteration.contact.ground(),
                                      iteration.state,
                                      iteration.loads,
                                      rates);
            missing[i] = values[i] - now.value - now.gradient * dV_R;
            for (unsigned int j = 0; j < n; ++j)
              matrix(i, j) = now.gradient * dV_q[j] + now.per_load[j];
          }
        return solve(matrix, missing);
      }

      double
      violation(const Iteration &iteration) const override
      {
        double largest = 0;
        for (unsigned int i = 0; i < resultants.size(); ++i)
          {
            const double now = resultants[i]
                                 ->evaluate(iteration.contact.ground(),
                                            iteration.state,
                                            iteration.loads,
                                            {})
                                 .value;
            const double relative = std::abs(now - values[i]) /
                                    resultants[i]->scale(values[i], iteration);
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
    if (!stage.contact)
      throw InputError(section + "/Control",
                       stage.control_name(),
                       "it needs 'Contact = true'");
    for (const auto &resultant : resultants)
      resultant->check(stage, section, start);
  }


  Control::KnownStart
  ResultantControl::known_end(const KnownStart &start) const
  {
    KnownStart end = EqualSteps::known_end(start);
    for (const auto &resultant : resultants)
      (end.*resultant->known_load()).reset();
    return end;
  }


  void
  ResultantControl::begin(const Equilibrium &from)
  {
    EqualSteps::begin(from);
    // without pressure no moment depends on the angular velocity
    if (resultants.size() > 1 && from.contact.count_active(from.state) == 0)
      throw InputError("the stage '" + stage.name +
                       "' has 'Control = " + stage.control_name() +
                       "' and must start in contact, such as after a stage "
                       "with 'Control = foundation force'.");
    const Loads loads = from.loads(from.level);
    for (unsigned int i = 0; i < resultants.size(); ++i)
      start_values[i] =
        resultants[i]
          ->evaluate(from.contact.ground(), from.state, loads, {})
          .value;
  }


  Control::Trial
  ResultantControl::propose(const Equilibrium &from) const
  {
    const double    part = next();
    const LoadLevel end  = level_at(part);
    Trial           trial;
    trial.level = [this, end](const LoadParameters &mu) {
      LoadLevel level = end;
      for (unsigned int i = 0; i < resultants.size(); ++i)
        level.*resultants[i]->load() = mu[i];
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
      from.*resultant->load() = to.*resultant->load() =
                                  start.*resultant->load();
    std::vector<Progression> progressions = progressions_of_loads(from, to);
    for (unsigned int i = 0; i < resultants.size(); ++i)
      progressions.push_back(
        {start_values[i], values[i], resultants[i]->end(now)});
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
} // namespace Biface
