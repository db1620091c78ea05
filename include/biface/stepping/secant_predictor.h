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
   * Where the next step probably ends: displacements, resultants and a load
   * parameter that follows, such as the travel of the foundation, go on as in
   * the step before, in proportion to the loads. Nodes in contact follow from
   * displacements and travel.
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
     * @param mu_change of the load parameter, where it follows; else 0.
     * @param size how far the loads went, in any measure. */
    void
    learn(const State &before,
          const State &after,
          const double mu_change,
          const double size);

    /** Move a state and its load parameter by a step of the given size, where a
     * step was learnt. */
    void
    predict(State &state, double &mu, const double size) const;

    /** What changed in a step. */
    struct Step
    {
      /** The locally owned entries. */
      LA::Vector                 displacement;
      std::vector<Modes::Vector> resultants;
      double                     mu   = 0;
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

    /** The numbers; vectors are distributed, and stored by themselves. */
    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      bool                known = last.has_value();
      double              mu    = (known ? last->mu : 0.);
      double              size  = (known ? last->size : 0.);
      archive &known &mu &size;
      if (known && !last)
        last = Step();
      if (known)
        {
          last->mu   = mu;
          last->size = size;
        }
    }

  private:
    std::optional<Step> last;
  };
} // namespace Biface

#endif
