// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_stepping_secant_predictor_h
#define biface_stepping_secant_predictor_h

#include <optional>
#include <vector>

#include <biface/base/linear_algebra.h>
#include <biface/element/modes.h>
#include <biface/model/state.h>

namespace Biface
{
  /**
   * Where the next step probably ends: displacements and resultants go on as in
   * the step before, in proportion to the loads. Nodes in contact follow from
   * the displacements.
   */
  class SecantPredictor
  {
  public:
    /** Forget what was learnt, where the loads take another course. */
    void
    reset()
    {
      last.reset();
    }

    /** Learn from a converged step.
     * @param size how far the loads went, in any measure. */
    void
    learn(const State &before, const State &after, const double size);

    /** Move a state by a step of the given size, where a step was learnt.
     * @return whether it was moved. */
    bool
    predict(State &state, const double size) const;

    /** What changed in a step. */
    struct Step
    {
      /** The locally owned entries. */
      LA::Vector                 displacement;
      std::vector<Modes::Vector> resultants;
      double                     size = 0;
    };

    /** What was learnt, if anything. */
    const std::optional<Step> &
    get_last() const
    {
      return last;
    }

    void
    restore(const std::optional<Step> &step)
    {
      last = step;
    }

  private:
    std::optional<Step> last;
  };
} // namespace Biface

#endif
