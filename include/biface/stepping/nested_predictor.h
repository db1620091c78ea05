// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_stepping_nested_predictor_h
#define biface_stepping_nested_predictor_h

#include <map>
#include <vector>

#include <biface/model/grid_state.h>
#include <biface/model/shell_mesh.h>
#include <biface/model/state.h>
#include <biface/stepping/stage.h>

namespace Biface
{
  /**
   * Where the next step probably ends, from the same analysis on a coarser
   * mesh: displacements and resultants change as they did there, and its
   * contact zone is taken over (nested iteration).
   *
   * On a fine mesh this is more than fewer iterations. An active set that
   * starts far too large shrinks by a few nodes an iteration, and meanwhile the
   * foundation holds its edge by forces that grow on ever narrower cells, until
   * they crush the shell's thickness; close to the solution there are none.
   */
  class NestedPredictor
  {
  public:
    /** At the start, before any stage. */
    NestedPredictor(const ChartGrid &coarse, const std::vector<Stage> &stages);

    /** Learn a converged step of the coarser mesh; in rising order. */
    void
    learn(const Instant &instant, GridState &&state);

    /**
     * Move a state of the finer mesh by a step.
     *
     * @return whether the coarser mesh has come as far as @p to; else nothing
     * is changed.
     */
    bool
    predict(const ShellMesh &mesh,
            const Instant   &from,
            const Instant   &to,
            State           &state) const;

  private:
    /** A state between two of those learnt. */
    struct Mean
    {
      const GridState *before, *after;
      /** Of the latter. */
      double weight;
    };

    /** @return null pointers where the coarser mesh has not come so far. */
    Mean
    at(const Instant &instant) const;

    const GridState              undeformed;
    const std::vector<Stage>     stages;
    std::map<Instant, GridState> states;
  };
} // namespace Biface

#endif
