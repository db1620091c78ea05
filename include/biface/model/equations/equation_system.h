// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_model_equations_equation_system_h
#define biface_model_equations_equation_system_h

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <biface/base/linear_algebra.h>
#include <biface/model/equations/linearized_resultant.h>
#include <biface/model/forces/nonlocal_stiffness.h>
#include <biface/model/mesh/shell_mesh.h>

namespace Biface
{
  struct LoadRates;
  struct Loads;
  struct State;


  /** The update of the resultants in an iteration, see
   * ShellEquations::update(). */
  enum class NewtonIteration
  {
    /** The resultants are unknowns of the Hu-Washizu functional and are set to
     * their linearized prediction. */
    mixed,
    /** The resultants follow from the displacements. */
    substituted
  };


  /**
   * The equations that Newton's method solves for the state at the end of a
   * step: residual and tangent at any state, and the update of a state by an
   * increment of the displacements. In statics they are ShellEquations; a
   * method for steps in time adds its forces of inertia to these.
   */
  class EquationSystem
  {
  public:
    /** The mesh is kept by reference. */
    explicit EquationSystem(const ShellMesh &mesh) : mesh(mesh)
    {}

    virtual ~EquationSystem() = default;

    /** Compute residual() and tangent() for a state. */
    virtual void
    assemble(const State &state, const Loads &loads) = 0;

    /** Compute residual() alone, in a fraction of the time; tangent() remains
     * that of an earlier state. Prescribed displacements must be those of the
     * supports. */
    virtual void
    assemble_residual(const State &state, const Loads &loads) = 0;

    /** Add the forces of bodies without friction at the active points of a
     * state, and their derivative, to residual() and tangent(): after an
     * assembly without these points, the same as with them. */
    virtual void
    add_contact(const State &state, const Loads &loads) = 0;

    /** The sum of all forces on the nodes, which depends only on the
     * displacements, not on the resultants of the state. */
    virtual const LA::Vector &
    residual() const = 0;

    /** Minus the derivative of residual() for a fixed active set. */
    virtual const LA::SparseMatrix &
    tangent() const = 0;

    /** Whether the tangent is symmetric for these loads whatever the
     * supports. */
    virtual bool
    is_symmetric(const Loads &loads) const = 0;

    /** Whether tangent() of the last assembly, for these loads, is symmetric:
     * loads that follow a closed shell, or one whose edges are held, have a
     * potential. Must be called on all ranks. */
    virtual bool
    tangent_is_symmetric(const Loads &loads) const
    {
      return is_symmetric(loads);
    }

    /** Whether loads that follow the shell are all that makes the tangent
     * unsymmetric for these loads, as at a free edge. */
    virtual bool
    is_symmetric_but_for_loads(const Loads &loads) const = 0;

    /** A part of the tangent that tangent() does not contain, minus the
     * derivative of some forces: @f$-\sum\mathbf f\otimes\mathbf g@f$ with
     * forces @f$\mathbf f@f$ per unit of a quantity with the gradient
     * @f$\mathbf g@f$, see DependentLoads. */
    struct RankOne
    {
      LA::Vector forces, gradient;
    };

    virtual std::vector<RankOne>
    low_rank_part(const State &state, const Loads &loads) const = 0;

    /** The part of minus the derivative of residual() that connects more nodes
     * than tangent() can hold; null for nothing. Must be called on all ranks,
     * and keeps the state by reference. */
    virtual std::unique_ptr<const NonlocalStiffness>
    nonlocal_part(const State & /*state*/) const
    {
      return nullptr;
    }

    /** Set what follows from the displacements of the whole shell in a state:
     * before the first assembly, and after each change of the displacements.
     * Must be called on all ranks. */
    virtual std::string
    prepare(const Loads & /*loads*/, State & /*state*/) const
    {
      return {};
    }

    /** The given loads, completed by those that follow from the displacements
     * of the whole shell. */
    virtual Loads
    with_dependent_loads(const State &state, const Loads &loads) const = 0;

    /** The derivative of residual() for the given rates of the loads and a
     * fixed active set; not for linear strain theory. */
    virtual LA::Vector
    load_direction(const State     &state,
                   const Loads     &loads,
                   const LoadRates &rates) const = 0;

    /** A motion of supports, and the forces on the free unknowns by it, see
     * load_direction(). */
    struct MovedSupports
    {
      LA::Vector displacement, forces;
    };

    /** The motion of the supports for the given rates of the loads, without
     * the part of the tangent that low_rank_part() gives; none if they stay
     * where they are. Must be called on all ranks. */
    virtual std::optional<MovedSupports>
    moved_supports(const State & /*state*/,
                   const Loads & /*loads*/,
                   const LoadRates & /*rates*/) const
    {
      return {};
    }

    /** What a load parameter adds to the system of an iteration, per unit of
     * the parameter. */
    struct ParameterDirection
    {
      /** The forces on the free unknowns. */
      LA::Vector forces;
      /** The motion of the supports, which take the shell along; none if they
       * stay where they are. */
      std::optional<LA::Vector> supports;
    };

    /** The direction of a load parameter with the given rates of the loads.
     * Must be called on all ranks. */
    ParameterDirection
    parameter_direction(const State     &state,
                        const Loads     &loads,
                        const LoadRates &rates) const
    {
      ParameterDirection result{load_direction(state, loads, rates), {}};
      if (auto moved = moved_supports(state, loads, rates))
        {
          result.forces += moved->forces;
          result.supports = std::move(moved->displacement);
        }
      return result;
    }

    /**
     * The power of the supports, by their forces on the shell, in a motion with
     * the given rates of the loads. The gradient refers to all unknowns, those
     * of the supports included. Over a StepInTime, the forces are the mean
     * ones. After a start from prestress, what balances it at supports is a
     * part of their forces.
     *
     * The last argument has the rates of the loads by which the power is
     * differentiated, at given displacements of the supports. Must be called on
     * all ranks.
     */
    virtual LinearizedResultant
    power_of_supports(const State & /*state*/,
                      const Loads & /*loads*/,
                      const LoadRates & /*motion*/,
                      const std::vector<LoadRates> & /*rates*/) const
    {
      Assert(false, dealii::ExcNotImplemented());
      return {};
    }

    /** The norm of residual() relative to the norm of the forces that cancel in
     * it: a pure number. */
    virtual double
    relative_residual() const = 0;

    /** The level of round-off in relative_residual(): products of the
     * displacements with stiff entries of the tangent, such as those across a
     * thin shell, cancel only up to round-off. */
    virtual double
    relative_roundoff(const State &state) const = 0;

    /** Whether there are forces at the last assembly that do not follow from
     * deformations, such as loads. Without them and without deformations, all
     * forces are round-off. */
    virtual bool
    has_given_forces() const
    {
      return true;
    }

    /** The maximum deviation from the prescribed displacements at the last
     * assembly. Unit: length. */
    virtual double
    support_violation() const = 0;

    /** Set the entries of the increment at the supports. */
    virtual void
    distribute(LA::Vector &increment) const = 0;

    /**
     * Add an increment to the displacements of a state, and update the
     * resultants: to
     * @f$\mathbf D(\mathbf E(\mathbf V)+\mathbf B\,d\mathbf V)@f$ in the mixed
     * iteration, to @f$\mathbf D\mathbf E(\mathbf V+d\mathbf V)@f$ in the
     * substituted one.
     */
    virtual void
    update(State                &state,
           const LA::Vector     &increment,
           const NewtonIteration iteration) const = 0;

    /** Set what follows from the displacements, after the last increment. */
    virtual void
    settle(State &state) const = 0;

    const ShellMesh &mesh;
  };
} // namespace Biface

#endif
