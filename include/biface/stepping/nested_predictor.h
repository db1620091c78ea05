// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_stepping_nested_predictor_h
#define biface_stepping_nested_predictor_h

#include <map>
#include <optional>
#include <vector>

#include <biface/model/mesh/shell_mesh.h>
#include <biface/model/state/grid_state.h>
#include <biface/stepping/instant.h>

namespace Biface
{
  struct Stage;


  /**
   * Predicts a step from the same analysis on a coarser mesh: displacements and
   * resultants change as they did there, and the active set is that of the
   * coarser mesh (nested iteration).
   *
   * On a fine mesh this not only saves iterations. An active set that starts
   * far too large shrinks by a few nodes per iteration. Meanwhile the contact
   * forces at its edge grow with decreasing cell size until they crush the
   * thickness of the shell. Close to the solution this does not happen.
   */
  class NestedPredictor
  {
  public:
    /** A predictor without a coarser mesh, which predicts nothing. */
    NestedPredictor() = default;

    /** A predictor at the start of a run, before any stage. */
    NestedPredictor(const ChartGrid          &coarse,
                    const unsigned int        n_layers,
                    const std::vector<Stage> &stages);

    /** Record a converged step of the coarser mesh, in ascending order. */
    void
    learn(const Instant &instant, GridState &&state);

    /**
     * Predict a step of the finer mesh.
     *
     * @return whether the coarser mesh has reached @p to; otherwise nothing is
     * changed.
     */
    bool
    predict(const ShellMesh &mesh,
            const Instant   &from,
            const Instant   &to,
            State           &state) const;

  private:
    /** A state interpolated between two recorded ones. */
    struct Mean
    {
      const GridState *before, *after;
      /** The weight of the state @p after, from 0 to 1. */
      double weight;
    };

    /** The state of the coarser mesh at an instant. */
    Mean
    at(const Instant &instant) const;

    /** The unloaded state of the coarser mesh; not set without one. */
    std::optional<GridState> undeformed;
    /** The stages from whose ends others start, see continued_stages(). */
    std::vector<std::optional<unsigned int>> continued;
    std::map<Instant, GridState>             states;
  };
} // namespace Biface

#endif
