// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_model_forces_pressure_at_folds_h
#define biface_model_forces_pressure_at_folds_h

#include <array>
#include <vector>

#include <biface/element/follower_pressure.h>
#include <biface/model/forces/force_term.h>
#include <biface/model/forces/pressure_load.h>
#include <biface/model/mesh/shell_mesh.h>

namespace Biface
{
  /** The forces of a follower pressure on the gaps between the faces of parts
   * that meet at folds, and at the corners between three folds or more: with
   * them, the pressure in a closed shell has neither a resultant force nor a
   * resultant moment, and its derivative is symmetric. */
  class PressureAtFolds : public ForceTerm
  {
  public:
    /** The mesh is kept by reference. Throws InputError like
     * PressureLoad::values(). */
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
    /** A gap: a strip between four nodes, or a triangle between the first three
     * vertices, whose fourth one has no part in it. */
    struct Gap
    {
      Cell                  element;
      bool                  is_triangle;
      std::array<double, 4> distribution;
    };

    /** The forces of a unit pressure on a deformed gap. */
    FollowerPressure
    unit_pressure(const CellState &at) const;

    /** Move the forces at the fourth vertex of a triangle to the third one. */
    static MixedElement::NodalVector
    force_on(const Gap &gap, const FollowerPressure &pressure);

    void
    add_gap(const ShellMesh                 &mesh,
            const std::vector<double>       &distribution,
            const std::vector<unsigned int> &vertices);

    const Resultants::Face face;
    std::vector<Gap>       gaps;
  };
} // namespace Biface

#endif
