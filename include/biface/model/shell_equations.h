// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_model_shell_equations_h
#define biface_model_shell_equations_h

#include <map>
#include <optional>
#include <vector>

#include <biface/base/linear_algebra.h>
#include <biface/contact/contact_conditions.h>
#include <biface/element/modes.h>
#include <biface/model/cell_matrix_adder.h>
#include <biface/model/dead_loads.h>
#include <biface/model/edge_moments.h>
#include <biface/model/pressure_load.h>
#include <biface/model/shell_mesh.h>
#include <biface/model/state.h>

namespace Biface
{
  /**
   * The discrete equations of equilibrium of the shell, loaded by pressure and
   * pressed on a foundation: residual, tangent, and what an iteration does with
   * an increment.
   */
  class ShellEquations
  {
  public:
    /** The mesh and the contact conditions are kept by reference.
     * Throws InputError where the loads are not usable. */
    ShellEquations(const ShellMesh         &mesh,
                   const ContactConditions &contact,
                   const DeadLoads         &dead_loads = DeadLoads(),
                   const PressureLoad      &pressure   = PressureLoad());

    /** The unloaded shell. */
    State
    initial_state() const;

    /** From now on, use the given theory; a linear one linearizes about
     * @p state. */
    void
    set_theory(const StrainTheory theory, const State &state);

    /** Make the state's resultants initial ones and its displacements zero:
     * the stressed shell becomes the new start, in the undeformed shape, in
     * equilibrium with what stressed it. */
    void
    take_as_prestress(State &state);

    /** What earlier stages have left in the equations: with a State and its
     * Loads, a complete restore point. */
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

    History
    get_history() const
    {
      return {initial_resultants, initial_strains, linearization_point};
    }

    void
    restore(const History &history);

    /** Compute residual() and tangent() at a state. */
    void
    assemble(const State &state, const Loads &loads);

    /** External and contact forces less internal ones, by the displacements
     * alone (the resultants of the state do not enter). */
    const LA::Vector &
    residual() const
    {
      return rhs;
    }

    /** The derivative of residual() when the loads grow by @p rate, at the
     * state of the last assembly. */
    LA::Vector
    load_direction(const Loads &rate) const;

    /** The derivative of residual() when the foundation moves toward the
     * shell. */
    LA::Vector
    travel_direction(const State &state, const Loads &loads) const;

    /** The compressive force on the foundation, see ContactSummary, with its
     * derivatives while no node enters or leaves the contact. */
    struct ContactForce
    {
      double value;
      /** With respect to the displacements. */
      LA::Vector gradient;
      /** With respect to the travel of the foundation. */
      double per_travel;
    };

    ContactForce
    contact_force(const State &state, const Loads &loads) const;

    /** How far the foundation travels until it touches a free node of the
     * outer face, see RigidFoundation::travel_to(). */
    double
    travel_to_touch(const State &state, const Loads &loads) const;

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

    const LA::SparseMatrix &
    tangent() const
    {
      return matrix;
    }

    /** The norm of residual(), as a fraction of the forces that cancel in it:
     * a pure number. */
    double
    relative_residual() const;

    /** What round-off alone may leave of relative_residual(): the tangent's
     * stiff entries, such as those across a thin shell, times the
     * displacements cancel in the forces to the last digit only. */
    double
    relative_roundoff(const State &state) const;

    /** Whether the tangent is symmetric. */
    bool
    is_symmetric() const;

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

    /** Set the resultants to those of the displacements. */
    void
    settle_resultants(State &state) const;

    /** Decide anew which nodes are in contact.
     * @param held nodes that remain in contact, whatever the state; empty for
     * none.
     * @return the number of changes, on all ranks. */
    unsigned int
    update_active_set(State                              &state,
                      const Loads                        &loads,
                      const ContactConditions::ActiveSet &held = {}) const;

    /** Nodes in contact, on all ranks. */
    unsigned int
    count_active(const State &state) const;

    /** Distance between a node's deformed outer face and the foundation. */
    double
    clearance(const State &state, const Loads &loads, const Node &node) const;

    /** Contact pressure at a node, given by its position in
     * ShellMesh::nodes; counted on the surface midway between the faces.
     */
    double
    pressure(const State       &state,
             const Loads       &loads,
             const unsigned int node) const;

    ContactSummary
    summarize_contact(const State &state, const Loads &loads) const;

    /** The foundation that has moved by @p travel from where it is at rest. */
    MovedFoundation
    foundation(const double travel) const;

    /** The travel of the foundation that just touches the deformed outer face.
     * Throws InputError where it passes by the shell, or the shell does not fit
     * into it. */
    double
    touching_travel(const State &state) const;

    /** Strains of a cell, those that gave the prestress included. */
    Modes::Vector
    total_strains(const State &state, const unsigned int cell) const;

    /** Resultants of a cell, initial ones included. */
    Modes::Vector
    total_resultants(const State &state, const unsigned int cell) const
    {
      return state.resultants[cell] + initial_resultants[cell];
    }

    /** Strain energy of the state; where the law is not symmetric, the work
     * @f$\frac12\mathbf H\cdot\mathbf E@f$. */
    double
    strain_energy(const State &state) const;

    const ShellMesh &mesh;

  private:
    /** Forces of all kinds on the nodes of a cell, and minus their derivative.
     */
    struct CellEquations
    {
      MixedElement::NodalVector residual;
      MixedElement::NodalMatrix tangent;
      /** Of a unit of follower pressure, and of moments that follow, at the
       * load factor 1; not part of the residual. */
      MixedElement::NodalVector unit_pressure, moments;
      /** Sum of the squares of the forces that cancel in the residual. */
      double force_square;
    };

    void
    cell_equations(const State       &state,
                   const Loads       &loads,
                   const unsigned int cell,
                   CellEquations     &equations) const;

    /** Add follower loads at the displacements @p V: their forces, and minus
     * their derivative. */
    void
    add_follower_loads(const Loads                     &loads,
                       const unsigned int               cell,
                       const MixedElement::NodalVector &V,
                       CellEquations                   &equations) const;

    /** What an active node presses on the foundation with. */
    struct ContactTraction
    {
      /** That on the shell, @f$\lambda\mathbf n@f$. Unit: force/area. */
      dealii::Tensor<1, 3> value;
      /** Minus its derivative with respect to the position of the node,
       * @f$\varepsilon\,\mathbf n\mathbf n^T-\lambda\nabla\mathbf n@f$. */
      dealii::SymmetricTensor<2, 3> stiffness;
    };

    ContactTraction
    contact_traction(const State &state,
                     const Loads &loads,
                     const Node  &node) const;

    /**
     * Add the contact forces on a cell, and minus their derivative.
     *
     * The force on the node r is @f$\sum_s M_{rs}\lambda_s\mathbf n_s@f$ with
     * the normal at the node s, where the multiplier is: the traction
     * @f$\lambda\mathbf n@f$ is what is interpolated. So the forces add up to
     * those that contact_force() reports, whichever the multiplier mass is.
     * With the lumped mass they have the potential
     * @f$\sum_s M_{ss}\,\varepsilon c_s^2/2@f$ of the active nodes, and so a
     * symmetric tangent; a normal at the node r would have neither.
     */
    void
    add_contact(const State   &state,
                const Loads   &loads,
                const Cell    &cell,
                CellEquations &equations) const;

    /** The strains of the displacements, by the theory in use. */
    Modes::Vector
    strains(const State &state, const Cell &cell) const;

    const ModeStiffness &
    stiffness_of(const Cell &cell) const
    {
      return stiffness[cell.strip];
    }

    /** By ShellMesh::strips. */
    std::vector<ModeStiffness> stiffness;
    bool                       symmetric_stiffness;
    const PressureKind         pressure_kind;
    const Resultants::Face     pressure_face;
    /** At the nodes of this rank, see PressureLoad::values(). */
    const std::vector<double> pressure_distribution;
    /** Moments that follow, by the cells they act on. */
    std::map<unsigned int, std::vector<VertexMoment>> moments;
    const ContactConditions                          &contact;

    /** Initial resultants of each locally owned cell. */
    std::vector<Modes::Vector> initial_resultants;

    /** What the strains were that gave initial resultants, see
     * take_as_prestress(). */
    std::vector<Modes::Vector> initial_strains;

    /** The state about which the strains are linearized, if they are. */
    std::optional<State> linearization_point;

    /** Set the inhomogeneities of the constraints to what the prescribed
     * displacements lack. */
    void
    update_constraints(const State &state, const Loads &loads);

    /** The supports, for increments. */
    dealii::AffineConstraints<double> constraints;
    double                            largest_violation = 0;

    /** Nodal forces of the dead loads, of all loads that grow with the load
     * factor, and of a unit pressure. */
    const LA::Vector dead_load;
    LA::Vector       unit_load;
    LA::Vector       unit_pressure;

    LA::SparseMatrix matrix;
    LA::Vector       rhs;
    double           force_scale = 0;
    CellMatrixAdder  adder;
  };
} // namespace Biface

#endif
