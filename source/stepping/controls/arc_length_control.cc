// SPDX-License-Identifier: LGPL-2.1-or-later

#include <algorithm>
#include <cmath>

#include <biface/model/mesh/shell_mesh.h>
#include <biface/model/state/state.h>
#include <biface/stepping/controls/arc_length_control.h>

namespace Biface
{
  namespace
  {
    /** The size of the change of the loads is prescribed, the direction
     * follows from the tangent, see ArcLengthControl. */
    class FirstStepEquation : public ControlEquation
    {
    public:
      FirstStepEquation(const LoadRates  &rate,
                        const double      size,
                        const LA::Vector &previous)
        : ControlEquation(rate), size(size), previous(previous)
      {}

      double
      parameter_change(const Iteration &iteration,
                       const LA::Vector & /*dV_R*/,
                       const LA::Vector &dV_q) const override
      {
        // only the first iteration changes the loads; the others find the
        // equilibrium with them
        if (iteration.total.norm_sqr() > 0)
          return 0;
        // a stable start goes toward the loads; an unstable one, or one whose
        // pivots are not counted, as the last step did; from rest the parity of
        // the pivots decides, section 7
        const auto &n_negative = iteration.n_negative_pivots;
        bool        forward    = true;
        if (n_negative != 0u && previous.size() > 0 && previous.norm_sqr() > 0)
          forward = (previous * dV_q > 0);
        else if (n_negative)
          forward = (*n_negative % 2 == 0);
        return forward ? size : -size;
      }

      bool
      reads_pivots(const Iteration &iteration) const override
      {
        return iteration.total.norm_sqr() == 0;
      }

      double
      violation(const Iteration & /*iteration*/) const override
      {
        return 0;
      }

    private:
      const double     size;
      const LA::Vector previous;
    };


    /**
     * The norm of the change of the displacements is prescribed,
     * @f$|\Delta \mathbf V| = s@f$ @cite Crisfield1981. In the first iteration
     * the load changes so that the displacements continue in the direction of
     * the last step, which passes limit points. Later, the equation is
     * linearized.
     */
    class ArcLengthEquation : public ControlEquation
    {
    public:
      /**
       * @param length s.
       * @param previous the change of the displacements in the last step.
       */
      ArcLengthEquation(const LoadRates  &rate,
                        const double      length,
                        const LA::Vector &previous)
        : ControlEquation(rate), length(length), previous(previous)
      {}

      double
      parameter_change(const Iteration  &iteration,
                       const LA::Vector &dV_R,
                       const LA::Vector &dV_q) const override
      {
        const LA::Vector &total = iteration.total;
        const double      size  = total.norm_sqr();
        if (size == 0)
          return (previous * dV_q < 0 ? -length : length) / dV_q.l2_norm();
        // |total + dV_R + dmu dV_q| = s, linearized about the total change
        return ((length * length - size) / 2 - total * dV_R) / (total * dV_q);
      }

      double
      violation(const Iteration &iteration) const override
      {
        return std::abs(iteration.total.l2_norm() / length - 1);
      }

    private:
      const double     length;
      const LA::Vector previous;
    };
  } // namespace


  void
  ArcLengthControl::check(const std::string & /*section*/,
                          const KnownStart &start) const
  {
    check_loads_follow(stage, start);
  }


  void
  ArcLengthControl::check(const std::string & /*section*/,
                          const ShellMesh &mesh) const
  {
    check_nothing_prescribed(stage, mesh);
  }


  void
  ArcLengthControl::begin(const Equilibrium &from)
  {
    // here also what was not known before the run
    check_loads_follow(stage, KnownStart::at(from.level));
    Control::begin(from);
    load_fraction = 0;
    n_steps       = 0;
    first_length  = 0;
  }


  Control::Trial
  ArcLengthControl::propose(const Equilibrium &from) const
  {
    Trial trial;
    trial.level = [this](const LoadParameters &mu) { return level_at(mu[0]); };
    trial.mu    = {load_fraction};
    // no length is known yet: the first step prescribes the loads and finds it
    if (n_steps == 0)
      trial.equations = std::make_shared<const FirstStepEquation>(
        load_rate(), size.get(), from.last_change);
    else
      trial.equations = std::make_shared<const ArcLengthEquation>(
        load_rate(), size.get(), from.last_change);
    return trial;
  }


  std::optional<Control::Trial>
  ArcLengthControl::replace(const Trial &trial, const LoadParameters &mu) const
  {
    if (!trial.equations || mu[0] <= 1)
      return {};
    Trial to_the_end     = trial;
    to_the_end.mu        = {1};
    to_the_end.equations = nullptr;
    return to_the_end;
  }


  void
  ArcLengthControl::accept(const Step &step)
  {
    // desired iterations per step
    constexpr double wanted_iterations = 5;

    load_fraction = step.mu[0];
    ++n_steps;
    // displacements on another branch are of another size
    if (n_steps == 1 || step.to_branch)
      {
        LA::Vector change = owned_part(step.after.displacement);
        change -= owned_part(step.before.displacement);
        const double length = change.l2_norm();
        size                = StepSize(length);
        // what was taken of the prescribed first step, which may have been cut
        const double part =
          (step.to_branch ? 1. : std::abs(step.mu[0]) * stage.n_steps);
        first_length = length / part;
      }
    else
      size.succeeded(
        std::min(
          2., std::max(0.5, step_growth(wanted_iterations, step.iterations))),
        parameters.maximum_growth * first_length);
  }


  std::string
  ArcLengthControl::stop_reason() const
  {
    // a path that turns back before the loads would be followed without end
    if (n_steps == 0 || n_steps < parameters.max_arc_steps)
      return {};
    return "the loads of the stage '" + stage.name +
           "' were not reached within " + std::to_string(n_steps) + " steps";
  }


  Control::Memory
  ArcLengthControl::get_memory() const
  {
    Memory memory                  = Control::get_memory();
    memory.numbers["steps"]        = n_steps;
    memory.numbers["first length"] = first_length;
    return memory;
  }


  void
  ArcLengthControl::restore(const Memory &memory)
  {
    Control::restore(memory);
    load_fraction = memory.done;
    n_steps       = static_cast<unsigned int>(memory.numbers.at("steps"));
    first_length  = memory.numbers.at("first length");
  }


  void
  ArcLengthControl::change_path(const Stage &now, const LoadLevel &reached)
  {
    const std::optional<double> part =
      common_part(progressions_of_loads(reached, now.end(start)));
    if (!part)
      start = reached;
    load_fraction = part.value_or(0);
  }


  void
  ArcLengthControl::change_size()
  {
    // keep a length that was found
    if (first_length == 0)
      Control::change_size();
  }
} // namespace Biface
