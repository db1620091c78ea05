// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_model_forces_pressure_load_h
#define biface_model_forces_pressure_load_h

#include <array>
#include <string>
#include <vector>

#include <biface/base/linear_algebra.h>
#include <biface/element/follower_pressure.h>
#include <biface/input/formula.h>
#include <biface/model/forces/force_term.h>
#include <biface/model/mesh/shell_mesh.h>
#include <biface/model/state/load_rates.h>
#include <biface/surface/chart_grid.h>

namespace Biface
{
  class EntryDeclarations;


  /** The dependence of a pressure on the motion of the face. */
  enum class PressureKind
  {
    /** The pressure keeps its initial direction and acts on an undeformed area,
     * see vertex_area(). */
    dead,
    /** The pressure acts on the deformed face, along its normal. If it is
     * uniform and no edge is free to sweep an area, it has a potential, see
     * FollowerPressure, and the tangent is symmetric. */
    follower
  };


  /** The face on which the pressure of the stages acts, and how. Positive
   * pressure pushes the face toward the shell. */
  struct PressureLoad
  {
    PressureKind     kind = PressureKind::follower;
    Resultants::Face face = Resultants::inner;
    /** The edges of alpha_1 that a rigid plate closes, on which the pressure
     * acts, too. */
    std::vector<Edge> end_plates;
    /** The formula of the position that multiplies the pressure. */
    Formula distribution =
      parse_position_formula("Loads/Pressure distribution", "1");

    void
    add_parameters(EntryDeclarations &prm);

    /** Whether the distribution is that of a gas. */
    bool
    is_uniform() const
    {
      return distribution.get_text() == PressureLoad().distribution.get_text();
    }

    /** The distribution at all nodes of this rank. Throws InputError on all
     * ranks if it is not finite at some node. */
    std::vector<double>
    values(const ShellMesh &mesh) const;

    /** The nodal forces of a dead unit pressure. */
    LA::Vector
    assemble_dead(const ShellMesh &mesh) const;
  };


  /** The forces of dead or follower pressure. */
  class PressureForces : public ForceTerm
  {
  public:
    /** The mesh is kept by reference. Throws InputError like
     * PressureLoad::values(). */
    PressureForces(const ShellMesh &mesh, const PressureLoad &pressure);

    bool
    acts_on(const unsigned int cell,
            const State &,
            const Loads &) const override
    {
      return kind == PressureKind::follower && mesh.cells[cell].is_wall;
    }

    void
    add(const CellState &at, CellForces &forces) const override;

    void
    add_load_derivative(const CellState           &at,
                        const LoadRates           &rates,
                        MixedElement::NodalVector &force) const override;

    void
    add_dead_forces(const LoadRates &loads,
                    LA::Vector      &nodal_forces) const override;

    bool
    is_symmetric(const Loads &loads) const override;

  private:
    /** The forces of a unit pressure on the deformed face of a cell. */
    FollowerPressure
    unit_pressure(const CellState &at) const;

    const ShellMesh       &mesh;
    const PressureKind     kind;
    const Resultants::Face face;
    /** The distribution of the pressure at the nodes of this rank, see
     * PressureLoad::values(). */
    const std::vector<double> distribution;
    /** The nodal forces of a dead unit pressure. */
    LA::Vector at_unit_pressure;
  };


  /** The part of the area of a cell that belongs to one of its vertices, to
   * which a dead load on a face refers: that of the face, or of the middle
   * surface with Formulation::paper. */
  double
  vertex_area(const Cell        &cell,
              const unsigned int vertex,
              const unsigned int face);
} // namespace Biface

#endif
