// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_model_contact_contact_forces_h
#define biface_model_contact_contact_forces_h

#include <biface/model/contact/contact_pair.h>
#include <biface/model/forces/force_term.h>

namespace Biface
{
  /**
   * The forces of the body of a pair at the active points.
   *
   * The force on node r is
   * @f$\sum_s M_{rs}\,(\lambda_s\mathbf n_s+\mathbf t_s)@f$ with the normal at
   * the point s, like the multipliers: at nodes, the traction is interpolated.
   * The forces therefore add up to the force of the body for both multiplier
   * masses. Without friction, with the lumped mortar matrix, they have the
   * potential
   * @f$\sum_s M_{ss}\,\varepsilon c_s^2/2@f$ of the active nodes, and thus a
   * symmetric tangent. Neither would be true with the normal at node r. With
   * friction, the tangent is not symmetric.
   */
  class ContactForces : public ForceTerm
  {
  public:
    /** The forces of a pair, which is kept by reference. */
    explicit ContactForces(const ContactPair &contact) : contact(contact)
    {}

    bool
    acts_on(const unsigned int cell,
            const State       &state,
            const Loads       &loads) const override;

    void
    add(const CellState &at, CellForces &forces) const override;

    /** Add the forces over a StepInTime, of the active points and of those that
     * have left or come: see traction_over_step(). */
    void
    add_over_step(const CellState &start,
                  const CellState &end,
                  CellForces      &forces) const override;

    /** Add the derivative of the forces at the active points or, over a
     * StepInTime, of those of add_over_step(). */
    void
    add_load_derivative(const CellState           &at,
                        const LoadRates           &rates,
                        MixedElement::NodalVector &force) const override;

    void
    add_load_derivative_over_step(
      const CellState & /*start*/,
      const CellState           &end,
      const LoadRates           &rates,
      MixedElement::NodalVector &force) const override
    {
      add_load_derivative(end, rates, force);
    }

    void
    add_coupled_forces(const State &state,
                       const Loads &loads,
                       LA::Vector  &nodal_forces) const override;

    void
    add_couplings(const State           &state,
                  const Loads           &loads,
                  std::vector<Coupling> &couplings) const override;

    void
    add_load_derivative_of_couplings(const State     &state,
                                     const Loads     &loads,
                                     const LoadRates &rates,
                                     LA::Vector &nodal_forces) const override;

    /** Set what the nodes remember at the start of a stage, see
     * TangentialLaw::start_stage(). */
    void
    start_stage(const Loads &loads, State &state) const override;

    /** Set what the nodes remember at the end of a step, see
     * TangentialLaw::commit_step(). */
    void
    commit_step(const State & /*before*/,
                const Loads &loads,
                const TimeInterval & /*time*/,
                State &after) const override
    {
      contact.commit_step(after, loads);
    }

    bool
    is_symmetric(const Loads &loads) const override
    {
      return !contact.body(loads) ||
             (contact.mortar_matrix == MortarMatrix::lumped &&
              !contact.has_friction(loads));
    }

    Source
    source() const override
    {
      return Source::ground;
    }

    std::string
    other_body() const override
    {
      return contact.number == 0 ? "" : contact.name;
    }

    /** Whether linear strain theory linearizes the forces: no, contact remains
     * unilateral. */
    bool
    is_linearized() const override
    {
      return false;
    }

  private:
    /** Add the forces of a traction at a point of a cell, with their
     * derivative.
     * @param i the position of the point in ContactPoints::on_cell(). */
    void
    add_traction(const Cell               &cell,
                 const unsigned int        i,
                 const LinearizedTraction &traction,
                 CellForces               &forces) const;

    /** Add the derivative of the force at a vertex of a rolling shell by the
     * displacement of its neighbor along the streamline in the same cell. The
     * cells on either side of a node add what depends on the neighbor on this
     * side, for the whole area of the node: the sparsity pattern does not grow.
     * Only for the lumped mortar matrix. */
    void
    add_neighbor(const Cell                &cell,
                 const unsigned int         vertex,
                 const LinearizedTraction  &traction,
                 MixedElement::NodalMatrix &K) const;

    const ContactPair &contact;
  };
} // namespace Biface

#endif
