// SPDX-License-Identifier: LGPL-2.1-or-later

#include <biface/model/state/state.h>
#include <biface/stepping/secant_predictor.h>

namespace Biface
{
  using namespace dealii;

  void
  SecantPredictor::learn(const State          &before,
                         const State          &after,
                         const LoadParameters &mu_change,
                         const double          size)
  {
    Step step;
    step.displacement = owned_part(after.displacement);
    step.displacement -= owned_part(before.displacement);
    for (unsigned int c = 0; c < after.resultants.size(); ++c)
      step.resultants.push_back(after.resultants[c] - before.resultants[c]);
    step.mu   = mu_change;
    step.size = size;
    last      = step;
  }


  void
  SecantPredictor::predict(State          &state,
                           LoadParameters &mu,
                           const double    size) const
  {
    if (!last)
      return;
    const double ratio = size / last->size;
    add(mu, ratio, last->mu);

    LA::Vector displacement = owned_part(state.displacement);
    displacement.add(ratio, last->displacement);
    state.displacement = displacement;
    // unknowns of the mixed iteration as well, whose first tangent has them
    for (unsigned int c = 0; c < state.resultants.size(); ++c)
      state.resultants[c] += ratio * last->resultants[c];
  }
} // namespace Biface
