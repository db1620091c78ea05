// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_model_forces_pressure_at_folds_h
#define biface_model_forces_pressure_at_folds_h

#include <array>
#include <vector>

#include <biface/element/follower_pressure.h>
#include <biface/model/forces/force_term.h>
#include <biface/model/forces/gaps_at_folds.h>
#include <biface/model/forces/pressure_load.h>
#include <biface/model/mesh/shell_mesh.h>

namespace Biface
{
  /** The forces of a follower pressure on the gaps at folds, see GapAtFold:
   * with them, the pressure in a closed shell has neither a resultant force nor
   * a resultant moment, and its derivative is symmetric. */
  class PressureAtFolds : public ForceTerm
  {
  public:
    /** Throws InputError like PressureLoad::values(). */
    PressureAtFolds(const ShellMesh &mesh, const PressureLoad &pressure);

    std::vector<const Cell *>
    elements() const override;

    void
    add(const CellState &at, CellForces &forces) const override;

    void
    add_load_derivative(const CellState           &at,
                        const LoadRates           &rates,
                        MixedElement::NodalVector &force) const override;

    bool
    is_symmetric(const Loads &loads) const override;

  private:
    /** The forces of a unit pressure on a deformed gap. */
    FollowerPressure
    unit_pressure(const CellState &at) const;

    const Resultants::Face       face;
    const std::vector<GapAtFold> gaps;
    /** The distribution of the pressure at the vertices of the gaps. */
    std::vector<std::array<double, 4>> distribution;
  };
} // namespace Biface

#endif
