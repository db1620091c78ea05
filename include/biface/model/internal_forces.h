// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_model_internal_forces_h
#define biface_model_internal_forces_h

#include <optional>
#include <vector>

#include <biface/element/modes.h>
#include <biface/model/force_term.h>

namespace Biface
{
  /**
   * The forces with which the cells resist their strains, those of initial
   * resultants included, and what belongs to them: strains, resultants and
   * their energy.
   *
   * The forces are those of the displacements, the tangent that of the
   * resultants of the state: see NewtonIteration::mixed.
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

    bool
    is_symmetric(const Loads &) const override
    {
      return symmetric_stiffness;
    }

    /** What earlier stages have left: with a State and its Loads, a complete
     * restore point. */
    struct History
    {
      /** Of each locally owned cell. */
      std::vector<Modes::Vector> initial_resultants;
      /** What the strains were that gave initial resultants, see
       * take_as_prestress(). */
      std::vector<Modes::Vector> initial_strains;
      /** The state about which the strains are linearized, if they are. */
      std::optional<State> linearization_point;
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

    /** From now on, use the given theory; a linear one linearizes about
     * @p state. */
    void
    set_theory(const StrainTheory theory, const State &state);

    /** The state about which the strains are linearized, if they are. */
    const std::optional<State> &
    linearization_point() const
    {
      return history.linearization_point;
    }

    /** Make the state's resultants initial ones and its displacements zero:
     * the stressed shell becomes the new start, in the undeformed shape, in
     * equilibrium with what stressed it. */
    void
    take_as_prestress(State &state);

    /** Set the resultants to those of the displacements. */
    void
    settle_resultants(State &state) const;

    /** Set the resultants to their linearized prediction,
     * @f$\mathbf D(\mathbf E(\mathbf V)+\mathbf B\,d\mathbf V)@f$.
     * @param increment readable at all nodes of this rank. */
    void
    predict_resultants(State &state, const LA::Vector &increment) const;

    /** Strains of a cell, those that gave the prestress included. */
    Modes::Vector
    total_strains(const State &state, const unsigned int cell) const;

    /** Resultants of a cell, initial ones included. */
    Modes::Vector
    total_resultants(const State &state, const unsigned int cell) const
    {
      return state.resultants[cell] + history.initial_resultants[cell];
    }

    /** Strain energy of the state on all ranks, whose derivative the forces
     * are: @f$\frac12\mathbf H\cdot\mathbf E@f$, and the work of initial
     * resultants on the nonlinear part of the strains; with strains that are
     * linearized, to the second order in the displacements since. Where the law
     * is not symmetric, it is a work and has no such derivative. Unit: force
     * times length. */
    double
    strain_energy(const State &state) const;

  private:
    /** By the nonlinear theory. */
    double
    strain_energy(const unsigned int               cell,
                  const MixedElement::NodalVector &V) const;

    /** The strains of the displacements, by the theory in use. */
    Modes::Vector
    strains(const State &state, const Cell &cell) const;

    const ModeStiffness &
    stiffness_of(const Cell &cell) const
    {
      return stiffness[cell.strip];
    }

    const ShellMesh &mesh;
    /** By ShellMesh::strips. */
    std::vector<ModeStiffness> stiffness;
    bool                       symmetric_stiffness;
    History                    history;
  };
} // namespace Biface

#endif
