// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_model_forces_internal_forces_h
#define biface_model_forces_internal_forces_h

#include <array>
#include <optional>
#include <vector>

#include <biface/element/modes.h>
#include <biface/element/slack_cords.h>
#include <biface/model/forces/force_term.h>

namespace Biface
{
  /**
   * The internal forces of the cells, including those of initial resultants,
   * with the corresponding strains, resultants and energy.
   *
   * The forces follow from the displacements of the state, the tangent also
   * from its resultants: see NewtonIteration::mixed.
   */
  class InternalForces : public ForceTerm
  {
  public:
    /** The mesh is kept by reference. */
    explicit InternalForces(const ShellMesh &mesh);

    bool
    acts_on(const unsigned int, const State &, const Loads &) const override
    {
      return true;
    }

    void
    add(const CellState &at, CellForces &forces) const override;

    /** Add the forces of linear strain theory to a cell. Cords go slack by the
     * linearized strains.
     * @param at the cell in the state about which the strains are linearized.
     * @param dV the displacements since then. */
    void
    add_linearized(const CellState                 &at,
                   const MixedElement::NodalVector &dV,
                   CellForces                      &forces) const;

    bool
    is_symmetric(const Loads &) const override
    {
      return symmetric_stiffness;
    }

    Source
    source() const override
    {
      return Source::shell;
    }

    /** The constant forces on all nodes that are no part of the given loads:
     * those that are in equilibrium with the initial resultants in the
     * undeformed shape, @f$\mathbf B_0^T\mathbf H_0@f$, and
     * History::balancing_forces. Regardless of supports. */
    LA::Vector
    unlisted_forces() const;

    /** The part of unlisted_forces() that balances the shell since
     * take_as_prestress(), without what belongs to the initial resultants and
     * stresses of the laminate. */
    LA::Vector
    unbalanced_forces() const;

    /** Add the constant forces that add() does not contain: those of
     * History::balancing_forces. The work of initial resultants on the linear
     * part of the strains cancels with the other unlisted_forces(). */
    void
    add_constant_forces(LA::Vector &nodal_forces) const;

    /** The results of earlier stages: with a State and its Loads, a complete
     * restore point. */
    struct History
    {
      /** One per locally owned cell. */
      std::vector<Modes::Vector> initial_resultants;
      /** The strains that caused the initial resultants, see
       * take_as_prestress(). */
      std::vector<Modes::Vector> initial_strains;
      /** The state about which the strains are linearized, if any. */
      std::optional<State> linearization_point;
      /** Constant forces on the owned nodes, see balance(); none if empty. */
      LA::Vector balancing_forces;
    };

    const History &
    get_history() const
    {
      return history;
    }

    void
    restore(const History &history)
    {
      this->history = history;
    }

    /** Set the strain theory; linear theory linearizes about @p state. */
    void
    set_theory(const StrainTheory theory, const State &state);

    /** The state about which the strains are linearized, if any. */
    const std::optional<State> &
    linearization_point() const
    {
      return history.linearization_point;
    }

    /** The state in the shape in which the tangent is taken, with the same
     * resultants and slack cords: that about which the strains are linearized,
     * or the state itself. */
    State
    in_shape_of_tangent(const State &state) const;

    /** Turn the resultants of the state into initial resultants and set its
     * displacements to zero: the new start is the undeformed shape with these
     * stresses, in equilibrium with loads that are not given. Strains are no
     * longer linearized. */
    void
    take_as_prestress(State &state);

    /** Have constant forces take up the given loads on the undeformed shape, so
     * that it is in equilibrium with them. */
    void
    balance(const LA::Vector &loads);

    /** Set the resultants to those of the displacements. */
    void
    settle_resultants(State &state) const;

    /** Set the resultants to their linearized prediction,
     * @f$\mathbf D(\mathbf E(\mathbf V)+\mathbf B\,d\mathbf V)@f$. With
     * StrainSampling::vertices, a direction that this compresses has in
     * addition the strains of the hourglass in the increment, without which the
     * next tangent might not resist hourglasses.
     * @param increment readable at all nodes of this rank. */
    void
    predict_resultants(State &state, const LA::Vector &increment) const;

    /** Strains of a cell, including those that caused the prestress. */
    Modes::Vector
    total_strains(const State &state, const unsigned int cell) const;

    /** Resultants of a cell, including initial ones. */
    Modes::Vector
    total_resultants(const State &state, const unsigned int cell) const
    {
      return state.resultants[cell] + history.initial_resultants[cell];
    }

    /** The fraction of the cords in a cell that are slack, by thickness, at the
     * Gauss point next to each vertex. Refers to cords that can go slack. */
    std::array<double, Modes::n_gauss_points>
    slack_fractions(const State &state, const unsigned int cell) const;

    /** The fraction of the cords that are slack on all ranks, by volume. Refers
     * to cords that can go slack; 0 if there are none. */
    double
    slack_fraction(const State &state) const;

    /** Strain energy of the state on all ranks, whose derivative is the
     * internal force: @f$\frac12\mathbf H\cdot\mathbf E@f$ plus the work of
     * initial resultants on the nonlinear part of the strains. In linear strain
     * theory it is of second order in the displacements since the
     * linearization. With an unsymmetric law it is a work without such a
     * derivative. Unit: force times length. */
    double
    strain_energy(const State &state) const;

  private:
    /** The initial resultants of the laminate, of a cell each. */
    std::vector<Modes::Vector>
    resultants_of_laminate() const;

    /** The nodal forces of resultants in the undeformed shape. */
    LA::Vector
    forces_of(const std::vector<Modes::Vector> &resultants) const;

    /** In nonlinear theory. */
    double
    strain_energy(const unsigned int               cell,
                  const MixedElement::NodalVector &V) const;

    /** The strains of the displacements in the current theory. */
    Modes::Vector
    strains(const State &state, const Cell &cell) const;

    const ModeStiffness &
    stiffness_of(const Cell &cell) const
    {
      return stiffness[cell.strip];
    }

    const SlackCords &
    cords_of(const Cell &cell) const
    {
      return cords[cell.strip];
    }

    /** The resultants of strains of a cell. Cords go slack by all strains,
     * including those that caused the prestress. */
    Modes::Vector
    resultants_of(const unsigned int cell, const Modes::Vector &E) const;

    /** The energy of these resultants, per area. */
    double
    energy_of(const unsigned int cell, const Modes::Vector &E) const;

    /** Add the tangent of a cell.
     * @param E the strains at which the law is linearized. */
    void
    add_tangent(const MixedElement  &element,
                const CellState     &at,
                const Modes::Vector &E,
                CellForces          &forces) const;

    /** The product of the tangent of a cell without slack cords with @p dV, see
     * MixedElement::tangent_product(). */
    MixedElement::NodalVector
    taut_tangent_product(const CellState                 &at,
                         const MixedElement::NodalVector &dV) const;

    const ShellMesh &mesh;
    /** By ShellMesh::strips. */
    std::vector<ModeStiffness> stiffness;
    std::vector<SlackCords>    cords;
    bool                       symmetric_stiffness;
    History                    history;
  };
} // namespace Biface

#endif
