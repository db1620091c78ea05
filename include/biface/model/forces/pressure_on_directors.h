// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_model_forces_pressure_on_directors_h
#define biface_model_forces_pressure_on_directors_h

#include <vector>

#include <biface/model/forces/force_term.h>
#include <biface/model/mesh/pressed_directors.h>

namespace Biface
{
  struct PressureLoad;


  /** The forces of a follower pressure that keep directors from tilting in
   * turn, see PressedDirectors. They have a potential, and no resultants. */
  class PressureOnDirectors : public ForceTerm
  {
  public:
    /** The mesh is kept by reference. Throws InputError like
     * PressureLoad::values().
     * @param pressure of PressureKind::follower. */
    PressureOnDirectors(const ShellMesh &mesh, const PressureLoad &pressure);

    bool
    acts_on(const unsigned int cell,
            const State &,
            const Loads &) const override
    {
      return directors.act_on(cell);
    }

    void
    add(const CellState &at, CellForces &forces) const override;

    void
    add_over_step(const CellState &start,
                  const CellState &end,
                  CellForces      &forces) const override;

    void
    add_load_derivative(const CellState           &at,
                        const LoadRates           &rates,
                        MixedElement::NodalVector &force) const override;

  private:
    /** The mean of the pressure on a cell per unit of that of the loads. */
    double
    share(const Cell &cell) const;

    const PressedDirectors directors;
    /** The distribution of the pressure at the nodes of this rank, see
     * PressureLoad::values(). */
    const std::vector<double> distribution;
  };
} // namespace Biface

#endif
