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
    const double target = next_target();
    return size.get() < (target - fraction) * (1 - 1e-9) ? fraction + size.get()
                                                         : target;
  }


  double
  EqualSteps::next_target() const
  {
    const unsigned int n_targets = (stage.adaptive ? 1 : stage.n_steps);
    const double       k         = std::floor(fraction * n_targets + 1e-10) + 1;
    return std::min<double>(k, n_targets) / n_targets;
  }


  bool
  EqualSteps::go_on_from(const std::optional<double> &part,
                         const LoadLevel             &reached)
  {
    const bool is_part = (part && 0 <= *part && *part <= 1);
    if (!is_part)
      start = reached;
    fraction = (is_part ? *part : 0.);
    return is_part;
  }
} // namespace Biface
