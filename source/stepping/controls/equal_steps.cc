// SPDX-License-Identifier: LGPL-2.1-or-later

#include <algorithm>
#include <cmath>

#include <biface/stepping/controls/equal_steps.h>

namespace Biface
{
  void
  EqualSteps::begin(const Equilibrium &from)
  {
    Control::begin(from);
    fraction = 0;
  }


  void
  EqualSteps::accept(const Step &step)
  {
    // steps with fewer iterations grow
    constexpr double many_iterations = 8;

    const double first  = 1. / stage.n_steps;
    const double target = next_target();
    fraction            = next();
    // unless steps are adaptive, all multiples of 1/Steps are reached and
    // written, also after a step that was halved
    if (stage.adaptive)
      size.succeeded(
        std::min(2.,
                 std::max(1., step_growth(many_iterations, step.iterations))),
        parameters.maximum_growth * first);
    else if (fraction == target)
      size = StepSize(first);
    else
      size.succeeded(2, first);
  }


  void
  EqualSteps::restore(const Memory &memory)
  {
    Control::restore(memory);
    fraction = memory.done;
  }


  double
  EqualSteps::next() const
  {
    // what is left by round-off must not become a step of its own
    const double target = next_target();
    return size.get() < (target - fraction) * (1 - 1e-9) ? fraction + size.get()
                                                         : target;
  }


  double
  EqualSteps::next_target() const
  {
    // a fraction is a sum of steps: just below a target, it has reached it
    const unsigned int n_targets = (stage.adaptive ? 1 : stage.n_steps);
    const double       k         = std::floor(fraction * n_targets + 1e-10) + 1;
    return std::min<double>(k, n_targets) / n_targets;
  }


  bool
  EqualSteps::go_on_from(const std::optional<double> &part,
                         const LoadLevel             &reached)
  {
    // before the start of the new path or beyond its end, going on would turn
    // back
    const bool is_part = (part && 0 <= *part && *part <= 1);
    if (!is_part)
      start = reached;
    fraction = (is_part ? *part : 0.);
    return is_part;
  }
} // namespace Biface
