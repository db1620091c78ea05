// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_model_shell_equations_h
#define biface_model_shell_equations_h

#include <deal.II/lac/affine_constraints.h>

#include <memory>
#include <vector>

#include <biface/base/linear_algebra.h>
#include <biface/model/contact_interaction.h>
#include <biface/model/dead_loads.h>
#include <biface/model/force_term.h>
#include <biface/model/internal_forces.h>
#include <biface/model/pressure_load.h>
#include <biface/model/shell_mesh.h>
#include <biface/model/state.h>
#include <biface/model/tangent_matrix.h>

namespace Biface
{
  using ForceTerms = std::vector<std::unique_ptr<const ForceTerm>>;


  /** The forces on the shell beside its internal ones; a new kind of force is
   * one more line here. The mesh and the contact are kept by reference. Throws
   * InputError where the loads are not usable. */
  ForceTerms
  make_force_terms(const ShellMesh          &mesh,
                   const ContactInteraction &contact,
                   const DeadLoads          &dead_loads = DeadLoads(),
                   const PressureLoad       &pressure   = PressureLoad());


  /**
   * The discrete equations of equilibrium of the shell: the sum of its forces,
   * each kind of them a ForceTerm, with its tangent, and what an iteration does
   * with an increment.
   */
  class ShellEquations
  {
  public:
    /** The mesh is kept by reference.
     * @param terms forces beside the internal ones. */
    explicit ShellEquations(const ShellMesh &mesh, ForceTerms terms = {});

    InternalForces &
    internal_forces()
    {
      return internal;
    }

    const InternalForces &
    internal_forces() const
    {
      return internal;
    }

    /** Compute residual() and tangent() at a state. */
    void
    assemble(const State &state, const Loads &loads);

    /** The sum of all forces on the nodes, by the displacements alone (the
     * resultants of the state do not enter). */
    const LA::Vector &
    residual() const
    {
      return rhs;
    }

    /** Minus the derivative of residual(), with the active set kept. */
    const LA::SparseMatrix &
    tangent() const
    {
      return matrix.get();
    }

    /** Whether the tangent is symmetric at such loads. */
    bool
    is_symmetric(const Loads &loads) const;

    /** The derivative of residual() when the loads change at the given rates,
     * with the active set kept; not for a linear strain theory. */
    LA::Vector
    load_direction(const State     &state,
                   const Loads     &loads,
                   const LoadRates &rates) const;

    /** The norm of residual(), as a fraction of the forces that cancel in it:
     * a pure number. */
    double
    relative_residual() const;

    /** What round-off alone may leave of relative_residual(): the tangent's
     * stiff entries, such as those across a thin shell, times the
     * displacements cancel in the forces to the last digit only. */
    double
    relative_roundoff(const State &state) const;

    /** How far the prescribed displacements, at the last assembly, were from
     * what the loads ask for. Unit: length. */
    double
    support_violation() const
    {
      return largest_violation;
    }

    /** Give the increment its values at the supports. */
    void
    distribute(LA::Vector &increment) const
    {
      constraints.distribute(increment);
    }

    /**
     * Add an increment to the displacements of a state, and move the
     * resultants: to @f$\mathbf D(\mathbf E(\mathbf V)+\mathbf B\,d\mathbf
     * V)@f$ in the mixed iteration, to @f$\mathbf D\mathbf E(\mathbf
     * V+d\mathbf V)@f$ in the substituted one.
     */
    void
    update(State                &state,
           const LA::Vector     &increment,
           const NewtonIteration iteration) const;

    const ShellMesh &mesh;

  private:
    /** Compute the forces of all terms on a cell. */
    void
    sum_forces(const unsigned int     cell,
               const State           &state,
               const Loads           &loads,
               ForceTerm::CellForces &forces) const;

    /** Set the inhomogeneities of the constraints to what the prescribed
     * displacements lack. */
    void
    update_constraints(const State &state, const Loads &loads);

    InternalForces   internal;
    const ForceTerms other_terms;
    /** All of them, those that a linear theory linearizes first. */
    std::vector<const ForceTerm *> terms;
    unsigned int                   n_linearized = 0;

    /** The supports, for increments. */
    dealii::AffineConstraints<double> constraints;
    double                            largest_violation = 0;

    TangentMatrix matrix;
    LA::Vector    rhs;
    double        force_scale = 0;
  };
} // namespace Biface

#endif
