// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_model_forces_internal_forces_h
#define biface_model_forces_internal_forces_h

#include <array>
#include <optional>
#include <vector>

#include <biface/element/modes.h>
#include <biface/model/forces/force_term.h>
#include <biface/model/forces/relaxation_in_transport.h>
#include <biface/model/state/state.h>

namespace Biface
{
  struct HistoryOfPlies;
  class Laminate;
  class NonlinearPlies;
  struct StrainsOfPlies;
  enum class StrainTheory;


  /**
   * The internal forces of the layers, including those of initial resultants,
   * with the corresponding strains, resultants and energy. Where there are
   * several layers, the elements of the whole wall have none.
   *
   * The forces follow from the displacements of the state, the tangent also
   * from its resultants: see NewtonIteration::mixed.
   */
  class InternalForces : public ForceTerm
  {
  public:
    /** The mesh is kept by reference. */
    explicit InternalForces(const ShellMesh &mesh);

    ~InternalForces() override;

    bool
    acts_on(const unsigned int cell,
            const State &,
            const Loads &) const override
    {
      return mesh.cells[cell].is_layer;
    }

    void
    add(const CellState &at, CellForces &forces) const override;

    /** Add the forces over a StepInTime to a cell: with the mean of the shapes
     * and, for laws that have an energy, resultants whose work on the change of
     * the strains is the change of the energy, section "Steps in time" of
     * doc/theory.md. */
    void
    add_over_step(const CellState &start,
                  const CellState &end,
                  CellForces      &forces) const override;

    double
    dissipated_energy(const State &state) const override;

    /** Add the forces of linear strain theory to a cell. Laws that are not
     * linear, such as those of cords that go slack, take the linearized
     * strains.
     * @param at the cell in the state about which the strains are linearized.
     * @param dV the displacements since then. */
    void
    add_linearized(const CellState                 &at,
                   const MixedElement::NodalVector &dV,
                   CellForces                      &forces) const;

    bool
    is_symmetric(const Loads &loads) const override;

    Source
    source() const override
    {
      return Source::shell;
    }

    /** The name of the term; not empty if stresses relax: then the internal
     * variables of NonlinearPlies are remembered at the cells. */
    std::string
    name() const override;

    void
    start_stage(const Loads &loads, State &state) const override;

    std::string
    prepare(const Loads &loads, State &state) const override;

    /** The energies that plies lose in a turn of a wheel that rolls, in an
     * equilibrium, see RelaxationInTransport::losses(). */
    std::vector<std::vector<double>>
    losses(const State &state, const double angular_velocity) const;

    /** The part that the tangent lacks where stresses relax in a wheel that
     * rolls; null for nothing. Must be called on all ranks. */
    std::unique_ptr<const NonlocalStiffness>
    nonlocal_stiffness(const State &state) const;

    void
    commit_step(const State        &before,
                const Loads        &loads,
                const TimeInterval &time,
                State              &after) const override;

    /** Add a multiple of the part of the tangent of a layer that its law alone
     * gives, @f$\mathbf B^T\mathbf D\mathbf B@f$, with the elastic law of
     * another laminate of the same plies.
     * @param state not one of linear theory, see in_shape_of_tangent(). */
    void
    add_law(const State               &state,
            const unsigned int         cell,
            const Laminate            &laminate,
            const double               factor,
            MixedElement::NodalMatrix &K) const;

    /** Add the derivative of the forces of DampingInTime::of_stiffness by the
     * velocities of a layer, for a unit of it: the law at small strains. */
    void
    add_damping(const State               &state,
                const unsigned int         cell,
                MixedElement::NodalMatrix &C) const;

    /** The constant forces on all nodes that are no part of the given loads:
     * those that are in equilibrium with the initial resultants in the
     * undeformed shape, @f$\mathbf B_0^T\mathbf H_0@f$, and
     * Prestress::balancing_forces. Regardless of supports. */
    LA::Vector
    unlisted_forces(const State &state) const;

    /** The part of unlisted_forces() that balances the shell since
     * take_as_prestress(), without the part that belongs to the initial
     * resultants and stresses of the laminate. */
    LA::Vector
    unbalanced_forces(const State &state) const;

    /** Add the constant forces that add() does not contain,
     * Prestress::balancing_forces. The work of initial resultants on the linear
     * part of the strains cancels with the other unlisted_forces(). */
    void
    add_constant_forces(const State &state, LA::Vector &nodal_forces) const;

    /** Set the strain theory; linear theory linearizes about the state. */
    static void
    set_theory(const StrainTheory theory, State &state);

    /** The state, in nonlinear theory, in the shape in which the tangent is
     * taken, with the same resultants and slack cords: the shape about which
     * the strains are linearized, or that of the state itself. */
    State
    in_shape_of_tangent(const State &state) const;

    /** Turn the resultants of the state into initial resultants and set its
     * displacements to zero: the new start is the undeformed shape with these
     * stresses, balanced by loads that are not part of the model. Strains are
     * no longer linearized. */
    void
    take_as_prestress(State &state) const;

    /** Have constant forces take up the given loads on the undeformed shape of
     * a state, so that it is in equilibrium with them. */
    void
    balance(const LA::Vector &loads, State &state) const;

    /** Set the resultants to those of the displacements. */
    void
    settle_resultants(State &state) const;

    /** Set the resultants to their linearized prediction,
     * @f$\mathbf D(\mathbf E(\mathbf V)+\mathbf B\,d\mathbf V)@f$. Except
     * with Formulation::standard, a direction that this compresses has in
     * addition the strains of the hourglass in the increment, without which the
     * next tangent might not resist hourglasses.
     * @param increment readable at all nodes of this rank. */
    void
    predict_resultants(State &state, const LA::Vector &increment) const;

    /** The strains of a layer, including those that caused the prestress. */
    Modes::Vector
    total_strains(const State &state, const unsigned int cell) const;

    /** The total strains at the vertices of a layer, as the plies have them:
     * see NonlinearPlies::strains_at_vertices(). */
    std::array<StrainsOfPlies, 4>
    strains_at_vertices(const State &state, const unsigned int cell) const;

    /** The total strains and resultants at the vertices of a layer, along the
     * axes of the material. */
    std::array<Resultants::Vector, 4>
    total_strains_at_vertices(const State       &state,
                              const unsigned int cell) const;
    std::array<Resultants::Vector, 4>
    total_resultants_at_vertices(const State       &state,
                                 const unsigned int cell) const;

    /** The resultants of a layer, including initial ones. */
    Modes::Vector
    total_resultants(const State &state, const unsigned int cell) const
    {
      return state.resultants[cell] + initial_resultants(state)[cell];
    }

    /** The forces of the initial resultants of a layer on its nodes in the
     * undeformed shape, which constant forces balance: not among internal
     * forces. */
    MixedElement::NodalVector
    initial_forces(const State &state, const unsigned int cell) const
    {
      return undeformed_forces(cell, initial_resultants(state)[cell]);
    }

    /** The fraction of the cords in a cell that are slack, by thickness, at the
     * Gauss point next to each vertex. It refers to cords that can go slack. */
    std::array<double, Modes::n_gauss_points>
    slack_fractions(const State &state, const unsigned int cell) const;

    /** The fraction of the cords that are slack on all ranks, by volume. It
     * refers to cords that can go slack; 0 if there are none. */
    double
    slack_fraction(const State &state) const;

    /** The strain energy of the state on all ranks, whose derivative is the
     * internal force: @f$\frac12\mathbf H\cdot\mathbf E@f$ plus the work of
     * initial resultants on the nonlinear part of the strains. In linear strain
     * theory it is of second order in the displacements since the
     * linearization. With an unsymmetric law it is a work without such a
     * derivative, and where stresses relax it is nan. Unit: force times
     * length. */
    double
    strain_energy(const State &state) const;

  private:
    /** The initial resultants of the laminate, one for each cell. */
    std::vector<Modes::Vector>
    resultants_of_laminate() const;

    /** The forces of resultants of a layer on its nodes in the undeformed
     * shape. */
    MixedElement::NodalVector
    undeformed_forces(const unsigned int   cell,
                      const Modes::Vector &resultants) const;

    /** The initial resultants by cell: those of the laminate until there is
     * another prestress. */
    const std::vector<Modes::Vector> &
    initial_resultants(const State &state) const
    {
      return state.prestress ? state.prestress->resultants : of_laminate;
    }

    /** The strains that caused the prestress of a cell. */
    static Modes::Vector
    initial_strain(const State &state, const unsigned int cell)
    {
      return state.prestress ? state.prestress->strains[cell] : Modes::Vector();
    }

    /** The nodal forces of resultants in the undeformed shape. */
    LA::Vector
    forces_of(const std::vector<Modes::Vector> &resultants) const;

    /** The strain energy of a cell in nonlinear theory. */
    double
    strain_energy(const State                     &state,
                  const unsigned int               cell,
                  const MixedElement::NodalVector &V) const;

    /** The strains of a cell since its stress-free shape. */
    Modes::Vector
    strains_of(const MixedElement &element, const unsigned int cell) const
    {
      Modes::Vector E = element.strain();
      if (!of_imperfection.empty())
        E -= of_imperfection[cell];
      return E;
    }

    /** The strains of a cell since its stress-free shape, in the current strain
     * theory. */
    Modes::Vector
    strains(const State &state, const unsigned int cell) const;

    const ModeStiffness &
    stiffness_of(const Cell &cell) const
    {
      return stiffness_of_cells.empty() ? stiffness[cell.strip]
                                        : stiffness_of_cells[cell.position];
    }

    /** Add the laws of a laminate: that of ModeStiffness, and of the plies that
     * are not linear. */
    void
    add_laws(const Laminate              &laminate,
             const CellTangents          *tangents,
             std::vector<ModeStiffness>  &linear,
             std::vector<NonlinearPlies> &others) const;

    const NonlinearPlies &
    nonlinear_plies(const Cell &cell) const;

    /** The internal variables of a cell in a state, with its step. */
    HistoryOfPlies
    history(const State &state, const unsigned int cell) const;

    /** Whether any ply of the shell is not linear. */
    bool
    is_nonlinear() const;

    /** The resultants of the strains @p E of a cell. Laws that are not linear
     * depend on all strains, including those that caused the prestress. */
    Modes::Vector
    resultants_of(const State         &state,
                  const unsigned int   cell,
                  const Modes::Vector &E) const;

    /** The energy of the strains @p E of a cell per area. */
    double
    energy_of(const State         &state,
              const unsigned int   cell,
              const Modes::Vector &E) const;

    /** The resultants over a StepInTime without its damping, from one set of
     * strains to another.
     * @param of_plies see initial_stiffness().
     * @param change the strains @p E_1 without @p E_0. */
    Modes::Vector
    resultants_over_step(const CellState                    &end,
                         const std::optional<Modes::Matrix> &of_plies,
                         const Modes::Vector                &E_0,
                         const Modes::Vector                &E_1,
                         const Modes::Vector                &change) const;

    /** The stiffness at small strains of the plies of a cell that are not
     * linear; null if all are. */
    std::optional<Modes::Matrix>
    initial_stiffness(const Cell &cell) const;

    /** The law of a cell at small strains.
     * @param of_plies see initial_stiffness(). */
    Modes::Vector
    initial_law(const Cell                         &cell,
                const std::optional<Modes::Matrix> &of_plies,
                const Modes::Vector                &E) const;

    /** Add the tangent of a cell.
     * @param E the strains at which the law is linearized. */
    void
    add_tangent(const MixedElement  &element,
                const CellState     &at,
                const Modes::Vector &E,
                CellForces          &forces) const;

    /** The product of the tangent of a cell, with the law of ModeStiffness
     * alone, and @p dV, see MixedElement::tangent_product(). */
    MixedElement::NodalVector
    linear_tangent_product(const CellState                 &at,
                           const MixedElement::NodalVector &dV) const;

    const ShellMesh &mesh;
    /** The laws of the layers and of their plies that are not linear, by
     * ShellMesh::strips. */
    std::vector<ModeStiffness>  stiffness;
    std::vector<NonlinearPlies> nonlinear;
    /** The laws by ShellMesh::cells where the tangents of cells are not the
     * axes of the material; empty otherwise. */
    std::vector<ModeStiffness>  stiffness_of_cells;
    std::vector<NonlinearPlies> nonlinear_of_cells;
    RelaxationInTransport       transport;
    bool                        symmetric_stiffness;
    /** The initial resultants of the laminate, by cell. */
    std::vector<Modes::Vector> of_laminate;
    /** The strains from the surface to the stress-free shape, by cell; empty if
     * the surface is the stress-free shape. */
    std::vector<Modes::Vector> of_imperfection;
  };
} // namespace Biface

#endif
