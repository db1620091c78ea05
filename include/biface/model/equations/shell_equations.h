// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_model_equations_shell_equations_h
#define biface_model_equations_shell_equations_h

#include <deal.II/lac/affine_constraints.h>

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include <biface/base/linear_algebra.h>
#include <biface/model/equations/equation_system.h>
#include <biface/model/equations/tangent_matrix.h>
#include <biface/model/forces/force_term.h>
#include <biface/model/forces/internal_forces.h>
#include <biface/model/mesh/shell_mesh.h>

namespace Biface
{
  class NodalForces;


  /**
   * The discrete equilibrium equations of the shell: the sum of its forces,
   * each kind a ForceTerm.
   */
  class ShellEquations : public EquationSystem
  {
  public:
    /** The mesh is kept by reference.
     * @param terms the forces except the internal forces. */
    explicit ShellEquations(const ShellMesh &mesh, ForceTerms terms = {});

    const InternalForces &
    internal_forces() const
    {
      return internal;
    }

    /** The strain energy of the shell on all ranks, with that of its joints,
     * see InternalForces::strain_energy(). Unit: force times length. */
    double
    strain_energy(const State &state) const;

    /** The energy that damping of the material dissipates in the StepInTime of
     * a state, on all ranks, see ForceTerm::dissipated_energy(). Unit: force
     * times length. */
    double
    dissipated_energy(const State &state) const;

    void
    assemble(const State &state, const Loads &loads) override;

    void
    assemble_residual(const State &state, const Loads &loads) override;

    void
    add_contact(const State &state, const Loads &loads) override;

    const LA::Vector &
    residual() const override
    {
      return rhs;
    }

    const LA::SparseMatrix &
    tangent() const override
    {
      Assert(matrix, dealii::ExcNotInitialized());
      return matrix->get();
    }

    bool
    is_symmetric(const Loads &loads) const override;

    /** Whether contact makes the tangent unsymmetric for these loads. */
    bool
    has_unsymmetric_contact(const Loads &loads) const;

    bool
    is_symmetric_but_for_loads(const Loads &loads) const override;

    /** Whether a tangent for these loads is symmetric. Loads that follow the
     * shell may have a potential on a shell whose edges are held, which the
     * matrix shows up to round-off; contact is judged by its kind. */
    bool
    is_symmetric(const Loads &loads, const LA::SparseMatrix &tangent) const;

    bool
    tangent_is_symmetric(const Loads &loads) const override
    {
      return is_symmetric(loads, tangent());
    }

    /** The derivative of the forces on all nodes by a parameter, for given
     * rates of the loads, regardless of supports: what load_direction() moves
     * to the free unknowns. */
    LA::Vector
    nodal_load_rates(const State     &state,
                     const Loads     &loads,
                     const LoadRates &rates) const;

    /** Let the terms set what they remember, see ForceTerm::start_stage().
     * @param loads those at the start of the stage. */
    void
    start_stage(const Loads &loads, State &state) const;

    /** Let the terms set what they remember at the end of a step, see
     * ForceTerm::commit_step(). */
    void
    commit_step(const State        &before,
                const Loads        &loads,
                const TimeInterval &time,
                State              &after) const;

    Loads
    with_dependent_loads(const State &state, const Loads &loads) const override;

    std::vector<RankOne>
    low_rank_part(const State &state, const Loads &loads) const override;

    std::unique_ptr<const NonlocalStiffness>
    nonlocal_part(const State &state) const override
    {
      return internal.nonlocal_stiffness(state);
    }

    /** Set what follows from the displacements of the whole shell, see
     * ForceTerm::prepare(). */
    std::string
    prepare(const Loads &loads, State &state) const override;

    /** The tangent of assemble(), with the unknowns that supports hold, too,
     * and with constraints that need not be those of the supports. Must be
     * called on all ranks.
     * @param constraints kept by reference. */
    std::unique_ptr<TangentMatrix>
    tangent_with(const dealii::AffineConstraints<double> &constraints,
                 const State                             &state,
                 const Loads                             &loads) const;

    /** The residual() of any state, without an assembly. The displacements at
     * the supports are those of the state. */
    LA::Vector
    out_of_balance_forces(const State &state, const Loads &loads) const;

    /** Set the displacements of the supports in a state, at which other
     * displacements are kept. */
    void
    move_supports(State &state, const Loads &loads) const;

    LA::Vector
    load_direction(const State     &state,
                   const Loads     &loads,
                   const LoadRates &rates) const override;

    std::optional<MovedSupports>
    moved_supports(const State     &state,
                   const Loads     &loads,
                   const LoadRates &rates) const override;

    LinearizedResultant
    power_of_supports(const State                  &state,
                      const Loads                  &loads,
                      const LoadRates              &motion,
                      const std::vector<LoadRates> &rates) const override;

    /** The norms of nodal forces that are out of balance in a shape with given
     * resultants and loads. Unit: force. */
    struct Unbalance
    {
      double forces;
      double loads;
      /** The norm of the forces on all nodes, supported ones included. */
      double with_supports;
    };

    /** Turn the resultants of the state into initial resultants of the
     * undeformed shape, to which its displacements return, see
     * InternalForces::take_as_prestress(). The loads keep acting; from
     * now on constant forces take up what is out of balance.
     * @param loads without ground. */
    Unbalance
    start_from_prestress(State &state, const Loads &loads) const;

    /** The forces on the nodes by their sources, regardless of supports. */
    NodalForces
    nodal_forces(const State &state, const Loads &loads) const;

    const std::vector<const ForceTerm *> &
    get_terms() const
    {
      return terms;
    }

    double
    relative_residual() const override;

    double
    relative_roundoff(const State &state) const override;

    bool
    has_given_forces() const override
    {
      return given_forces > 0;
    }

    double
    support_violation() const override
    {
      return largest_violation;
    }

    void
    distribute(LA::Vector &increment) const override
    {
      constraints.distribute(increment);
    }

    void
    update(State                &state,
           const LA::Vector     &increment,
           const NewtonIteration iteration) const override;

    /** Set the resultants to those of the displacements, see
     * InternalForces::settle_resultants(). */
    void
    settle(State &state) const override
    {
      internal.settle_resultants(state);
    }

  private:
    /** An element of ShellMesh::cells or of ForceTerm::elements(). */
    struct Element
    {
      const Cell *cell;
      /** The position of the element, see ForceTerm::CellState. */
      unsigned int index;
      /** The only term that acts on the element; null for a cell of the mesh.
       */
      const ForceTerm *owner = nullptr;
    };

    /** The elements of terms, see ForceTerm::elements(). */
    std::vector<const Cell *>
    of_terms() const;

    bool
    acts_on(const ForceTerm &term,
            const Element   &element,
            const State     &state,
            const Loads     &loads) const
    {
      return element.owner ? element.owner == &term
                           : term.acts_on(element.index, state, loads);
    }

    /** Add the forces of the terms in a range, which linear theory linearizes
     * either all or not at all, on an element. */
    void
    add_forces(const unsigned int     begin,
               const unsigned int     end,
               const Element         &element,
               const State           &state,
               const Loads           &loads,
               ForceTerm::CellForces &forces) const;

    /** Add the forces over the StepInTime of a state, see add_forces(). */
    void
    add_forces_over_step(const unsigned int     begin,
                         const unsigned int     end,
                         const Element         &element,
                         const State           &state,
                         const Loads           &loads,
                         ForceTerm::CellForces &forces) const;

    /** The sum of all forces on the free unknowns, and the norms of those that
     * cancel in it and of the given ones. */
    struct Balance
    {
      LA::Vector sum;
      double     scale, given;
    };

    Balance
    balance(const State &state, const Loads &loads) const;

    /** The forces that do not follow from single cells, see
     * ForceTerm::add_coupled_forces().
     * @param square to which their squares on this rank are added. */
    LA::Vector
    coupled_forces(const State &state,
                   const Loads &loads,
                   double      &square) const;

    /** Compute the forces of all terms on an element. */
    void
    sum_forces(const Element         &element,
               const State           &state,
               const Loads           &loads,
               ForceTerm::CellForces &forces) const;

    /** Call a function for each element on which a vector is not zero, with its
     * values there and the forces of all terms. */
    void
    for_each_moved(
      const LA::Vector                                               &moved,
      const State                                                    &state,
      const Loads                                                    &loads,
      const std::function<void(const Element                   &element,
                               const MixedElement::NodalVector &moved,
                               const ForceTerm::CellForces &forces)> &function)
      const;

    /** Add the derivative of the forces of all terms on an element for the
     * given rates of the loads. */
    void
    add_load_derivative(const Element             &element,
                        const State               &state,
                        const Loads               &loads,
                        const LoadRates           &rates,
                        MixedElement::NodalVector &force) const;

    /** Set the inhomogeneities of the constraints to the missing part of the
     * prescribed displacements. */
    void
    update_constraints(const State &state, const Loads &loads);

    InternalForces   internal;
    const ForceTerms other_terms;
    /** All terms, starting with those that linear theory linearizes. */
    std::vector<const ForceTerm *> terms;
    unsigned int                   n_linearized = 0;
    /** The cells of the mesh in their order, then the elements of terms. */
    std::vector<Element> elements;

    /** The supports, as constraints on increments. */
    dealii::AffineConstraints<double> constraints;
    double                            largest_violation = 0;

    /** The tangent, created by the first assembly. */
    std::unique_ptr<TangentMatrix> matrix;
    /** All couplings that terms of this rank have had so far. */
    std::vector<ForceTerm::Coupling> known_couplings;
    LA::Vector                       rhs;
    double                           force_scale = 0;
    /** The norm of the forces that has_given_forces() asks for. */
    double given_forces = 0;
  };
} // namespace Biface

#endif
