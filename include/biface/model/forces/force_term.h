// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_model_forces_force_term_h
#define biface_model_forces_force_term_h

#include <deal.II/base/types.h>
#include <deal.II/lac/full_matrix.h>

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <biface/base/linear_algebra.h>
#include <biface/element/mixed_element.h>
#include <biface/model/mesh/shell_mesh.h>

namespace Biface
{
  struct DependentLoads;
  struct LoadRates;
  struct Loads;
  struct State;


  /** An interval of time between two equilibria. Each stage takes the time
   * 1. */
  struct TimeInterval
  {
    double start = 0, end = 0;
  };


  /**
   * A kind of force on the shell: one term of the sum that vanishes in
   * equilibrium, see ShellEquations. Cell by cell, a term adds its forces,
   * their exact derivative by the displacements and, if it depends on the
   * loads, that by the loads. Forces that do not depend on the displacements
   * are added once for the whole shell.
   *
   * A term has no state of its own. What it remembers of earlier steps is part
   * of the State, see TermState: the term sets it at the start of a stage and
   * at the end of a step, and everything else copies and stores it without
   * knowing the term.
   */
  class ForceTerm
  {
  public:
    virtual ~ForceTerm() = default;

    /** A cell with everything its forces may depend on. */
    struct CellState
    {
      /** The position of the cell in ShellMesh::cells, or in elements() if it
       * is one of them. */
      unsigned int index;
      const Cell  &cell;
      /** The nodal displacements of the cell in the state, see
       * MixedElement::dof(). */
      const MixedElement::NodalVector &V;
      const State                     &state;
      const Loads                     &loads;
    };

    /** The forces on the nodes of a cell. */
    struct CellForces
    {
      /** Internal forces and contact forces. */
      MixedElement::NodalVector force;

      /** Loads, which do not cancel between the cells at a node. */
      MixedElement::NodalVector load;

      /** Minus the derivative of @p force and @p load with respect to the nodal
       * displacements. */
      MixedElement::NodalMatrix tangent;

      /** The sum of the squares of everything added to @p force: the forces
       * that cancel in equilibrium. */
      double square;

      /** Whether @p tangent is needed. */
      bool with_tangent = true;

      /** Set everything that is needed to zero. */
      void
      clear();
    };

    /** Whether the term contributes to a cell. A term that acts on few cells
     * costs nothing on the others. */
    virtual bool
    acts_on(const unsigned int /*cell*/,
            const State & /*state*/,
            const Loads & /*loads*/) const
    {
      return false;
    }

    /** Elements on cells of this rank that the mesh does not have, whose faces
     * are displaced in another way by the unknowns of the nodes, see
     * Cell::contributions. The term acts on all of them, beside the cells that
     * it names by acts_on(), and no other term does. */
    virtual std::vector<const Cell *>
    elements() const
    {
      return {};
    }

    /** Add the contribution of the term to a cell on which it acts. */
    virtual void
    add(const CellState & /*at*/, CellForces & /*forces*/) const
    {}

    /** Add the contribution of the term to a cell on which it acts over a
     * StepInTime, with the derivatives by the displacements at its end. The
     * work of the forces in the step should be the change of their energy;
     * unless overridden, they are the mean by Simpson's rule along a straight
     * way, for which that is so if the energy is cubic in the displacements.
     * @param end with the loads over the step. */
    virtual void
    add_over_step(const CellState &start,
                  const CellState &end,
                  CellForces      &forces) const;

    /** Add the derivative of the forces on a cell for the given rates of the
     * loads. */
    virtual void
    add_load_derivative(const CellState & /*at*/,
                        const LoadRates & /*rates*/,
                        MixedElement::NodalVector & /*force*/) const
    {}

    /** The dependence of the forces of a term on a node on the displacements of
     * another node, with which it need not share a cell. */
    struct Coupling
    {
      /** The numbers of both nodes, see Node. */
      std::pair<dealii::types::global_cell_index,
                dealii::types::global_cell_index>
        nodes;
      /** The free unknowns of the first and of the second node. */
      std::vector<dealii::types::global_dof_index> rows, columns;
      /** Minus the derivative of the forces; empty if it is zero at
       * present. */
      dealii::FullMatrix<double> stiffness;
    };

    /** Add forces on the nodes of this rank that do not follow from single
     * cells, regardless of supports. Called on all ranks. */
    virtual void
    add_coupled_forces(const State & /*state*/,
                       const Loads & /*loads*/,
                       LA::Vector & /*nodal_forces*/) const
    {}

    /** Add the derivatives of the forces of add_coupled_forces() by the
     * displacements. Called on all ranks. */
    virtual void
    add_couplings(const State & /*state*/,
                  const Loads & /*loads*/,
                  std::vector<Coupling> & /*couplings*/) const
    {}

    /** Add what add_load_derivative() adds, over a StepInTime, see
     * add_over_step(). */
    virtual void
    add_load_derivative_over_step(const CellState           &start,
                                  const CellState           &end,
                                  const LoadRates           &rates,
                                  MixedElement::NodalVector &force) const;

    /** Add the derivative of the forces of add_coupled_forces() for the given
     * rates of the loads. Called on all ranks. */
    virtual void
    add_load_derivative_of_couplings(const State & /*state*/,
                                     const Loads & /*loads*/,
                                     const LoadRates & /*rates*/,
                                     LA::Vector & /*nodal_forces*/) const
    {}

    /** Add the forces that do not depend on the displacements, regardless of
     * supports; they are proportional to the given loads. */
    virtual void
    add_dead_forces(const LoadRates & /*loads*/,
                    LA::Vector & /*nodal_forces*/) const
    {}

    /** Whether the tangent of the term is symmetric for these loads. */
    virtual bool
    is_symmetric(const Loads & /*loads*/) const
    {
      return true;
    }

    /** The name under which a State contains what the term remembers. */
    virtual std::string
    name() const
    {
      return {};
    }

    /** Set what the term remembers at the start of a stage with the given
     * loads. */
    virtual void
    start_stage(const Loads & /*loads*/, State & /*state*/) const
    {}

    /** Set what follows from the displacements of the whole shell and is not
     * part of the loads. Called on all ranks after each change of the
     * displacements in an iteration; returns the same there: why that is not
     * possible, or an empty string. */
    virtual std::string
    prepare(const Loads & /*loads*/, State & /*state*/) const
    {
      return {};
    }

    /** Set what the term remembers at the end of a step, given the equilibria
     * before and after the step, the loads after it and its interval of time.
     * The state after it still contains what the term remembered before. */
    virtual void
    commit_step(const State & /*before*/,
                const Loads & /*loads*/,
                const TimeInterval & /*time*/,
                State & /*after*/) const
    {}

    /** Set the loads that follow from the displacements of the whole shell. */
    virtual void
    set_dependent_loads(const State & /*state*/, Loads & /*loads*/) const
    {}

    /** Add the loads that follow from the displacements of the whole shell,
     * with their derivatives in a state with these loads: a part of the tangent
     * of low rank, see LowRankStiffness. */
    virtual void
    add_dependent_loads(const State & /*state*/,
                        const Loads & /*loads*/,
                        std::vector<DependentLoads> & /*dependent*/) const
    {}

    /** The energy on this rank of forces that are a part of the shell, beside
     * that of its cells, see InternalForces::strain_energy(). Unit: force times
     * length. */
    virtual double
    stored_energy(const State & /*state*/) const
    {
      return 0;
    }

    /** The energy on this rank that the damping of the material, and the
     * numerical one, dissipate in the StepInTime of a state. Unit: force times
     * length. */
    virtual double
    dissipated_energy(const State & /*state*/) const
    {
      return 0;
    }

    /** The kinds of bodies that exert the forces. */
    enum class Source
    {
      shell,
      loads,
      ground,
      damping
    };

    virtual Source
    source() const
    {
      return Source::loads;
    }

    /** The name of the body that exerts the forces, if it is not the
     * ground; empty otherwise. */
    virtual std::string
    other_body() const
    {
      return {};
    }

    /** Whether linear strain theory also linearizes these forces. */
    virtual bool
    is_linearized() const
    {
      return true;
    }
  };


  inline void
  ForceTerm::CellForces::clear()
  {
    force = 0;
    load  = 0;
    if (with_tangent)
      for (auto &row : tangent)
        row.fill(0);
    square = 0;
  }


  /** The kinds of forces on a shell, those of one kind in each term. */
  using ForceTerms = std::vector<std::unique_ptr<const ForceTerm>>;
} // namespace Biface

#endif
