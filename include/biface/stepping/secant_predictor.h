// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_stepping_secant_predictor_h
#define biface_stepping_secant_predictor_h

#include <optional>
#include <vector>

#include <biface/base/linear_algebra.h>
#include <biface/element/modes.h>
#include <biface/solver/control_equation.h>

namespace Biface
{
  /**
   * Predicts a step by extrapolating displacements, resultants and unknown
   * load parameters, such as the travel of the ground, from the last step
   * in proportion to the loads. The active set follows from displacements and
   * travel.
   */
  class SecantPredictor
  {
  public:
    /** Forget the last step, if the loads change their direction. */
    void
    reset()
    {
      last.reset();
    }

    /** Record a converged step.
     * @param mu_change the changes of the load parameters, 0 unless they are
     * unknown.
     * @param size the change of the loads, in any measure. */
    void
    learn(const State          &before,
          const State          &after,
          const LoadParameters &mu_change,
          const double          size);

    /** Extrapolate a state and its load parameters by a step of the given size,
     * if a step was recorded. */
    void
    predict(State &state, LoadParameters &mu, const double size) const;

    /** The changes in a step. */
    struct Step
    {
      /** The change of the displacements (locally owned entries). */
      LA::Vector                 displacement;
      std::vector<Modes::Vector> resultants;
      LoadParameters             mu;
      double                     size = 0;
    };

    /** The recorded step, if any. */
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

    /** Archive the numbers; vectors are distributed and stored separately. */
    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      bool                known = last.has_value();
      LoadParameters      mu    = (known ? last->mu : LoadParameters());
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
