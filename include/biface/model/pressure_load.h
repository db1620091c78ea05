// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_model_pressure_load_h
#define biface_model_pressure_load_h

#include <deal.II/base/parameter_handler.h>

#include <array>
#include <string>
#include <vector>

#include <biface/base/linear_algebra.h>
#include <biface/element/follower_pressure.h>
#include <biface/input/formula.h>
#include <biface/model/force_term.h>
#include <biface/model/shell_mesh.h>

namespace Biface
{
  /** What a pressure does as the face moves. */
  enum class PressureKind
  {
    /** It keeps its initial direction, and counts an undeformed area, see
     * AreaMeasure. */
    dead,
    /** True pressure: on the area and along the normal of the deformed face.
     * The tangent is not symmetric. */
    follower
  };


  /** The undeformed area that a dead load on a face is counted on. */
  enum class AreaMeasure
  {
    /** That of the surface midway between the faces, as in
     * @cite GrigolyukKulikovPlotnikova2004. */
    middle,
    /** That of the face itself. */
    face
  };


  /** Read a formula of the position on the reference surface, of `x, y, z,
   * alpha_1, alpha_2`. Throws InputError as Formula does. */
  Formula
  parse_position_formula(const std::string &entry, const std::string &text);


  /** Which face the pressure of the stages acts on, and how. A positive one
   * pushes the face toward the shell. */
  struct PressureLoad
  {
    PressureKind     kind = PressureKind::dead;
    Resultants::Face face = Resultants::inner;
    AreaMeasure      area = AreaMeasure::middle;
    /** Formula of the position, which multiplies the pressure. */
    Formula distribution =
      parse_position_formula("Loads/Pressure distribution", "1");

    void
    add_parameters(dealii::ParameterHandler &prm);

    /** The distribution at all nodes of this rank. Throws InputError on all
     * ranks where it is not finite at any node. */
    std::vector<double>
    values(const ShellMesh &mesh) const;

    /** The nodal forces of a unit of dead pressure. */
    LA::Vector
    assemble_dead(const ShellMesh &mesh) const;
  };


  /** The forces of the pressure, of either kind. */
  class PressureForces : public ForceTerm
  {
  public:
    /** Throws InputError as PressureLoad::values() does. */
    PressureForces(const ShellMesh &mesh, const PressureLoad &pressure);

    bool
    acts_on(const unsigned int, const State &, const Loads &) const override
    {
      return kind == PressureKind::follower;
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
    is_symmetric(const Loads &loads) const override
    {
      return kind == PressureKind::dead || loads.pressure == 0;
    }

  private:
    /** Of a unit of the pressure on the deformed face. */
    FollowerPressure
    unit_pressure(const CellState &at) const;

    const PressureKind     kind;
    const Resultants::Face face;
    /** At the nodes of this rank, see PressureLoad::values(). */
    const std::vector<double> distribution;
    /** Of a unit of dead pressure. */
    LA::Vector at_unit_pressure;
  };


  /** Formulas of the position, see parse_position_formula(), at all nodes of
   * this rank: `[node][i]` is the i-th formula's value. Throws InputError on
   * all ranks where one is not finite at any node. */
  std::vector<std::vector<double>>
  evaluate_at_nodes(const std::vector<Formula> &formulas,
                    const ShellMesh            &mesh);


  /** The area around a vertex of a cell, of which there are four. */
  double
  vertex_area(const Cell        &cell,
              const unsigned int vertex,
              const AreaMeasure  area,
              const unsigned int face);
} // namespace Biface

#endif
