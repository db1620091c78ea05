// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_model_state_state_h
#define biface_model_state_state_h

#include <deal.II/base/table.h>

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <biface/base/linear_algebra.h>
#include <biface/contact/contact_state.h>
#include <biface/element/modes.h>
#include <biface/laminate/time_step.h>

namespace Biface
{
  class ShellMesh;
  struct RollingStep;
  struct StepInTime;


  /** The results of earlier stages that belong to the undeformed shape since
   * InternalForces::take_as_prestress(). */
  struct Prestress
  {
    /** The resultants of each locally owned cell, those of the laminate
     * included. */
    std::vector<Modes::Vector> resultants;
    /** The strains of each locally owned cell that have caused the
     * resultants. */
    std::vector<Modes::Vector> strains;
    /** Constant forces on the owned nodes, see InternalForces::balance(); none
     * if empty. */
    LA::Vector balancing_forces;
  };


  /** What a ForceTerm remembers of earlier steps: its internal variables. */
  struct TermState
  {
    /** Numbers that are the same on all ranks. */
    std::vector<double> numbers;
    /** The numbers of each node of this rank, and of each locally owned cell, a
     * row each; empty if the term does not need them. */
    dealii::Table<2, double> at_nodes, at_cells;
  };


  /**
   * Everything that changes while the shell is loaded. A copy is a complete
   * restore point.
   */
  struct State
  {
    /** An empty state, to be assigned to. */
    State() = default;

    /** The state of the unloaded shell.
     * @param n_contacts the number of pairs in contact, see
     * ContactInteraction.
     * @param contacts_per_cell see ContactPoints::per_cell(). */
    explicit State(const ShellMesh   &mesh,
                   const unsigned int n_contacts        = 1,
                   const unsigned int contacts_per_cell = 0);

    /** The nodal unknowns, see MixedElement::Part, readable at all nodes of
     * this rank. */
    LA::Vector displacement;

    /** The velocities of the unknowns, readable at all nodes of this rank, if
     * the state moves; empty otherwise. Unit: length/time. */
    LA::Vector velocity;

    /** The step in time at whose end this state is sought; null in equilibrium
     * and at the end of a step. */
    std::shared_ptr<const StepInTime> step;

    /** The resultants @f$\mathbf H@f$ of each locally owned cell, an unknown
     * of the mixed iteration. Initial resultants are not included. */
    std::vector<Modes::Vector> resultants;

    /** The strains of each locally owned cell at which laws that are not linear
     * are linearized, another unknown of the mixed iteration. Empty if
     * these are the strains of the displacements, as in all converged
     * states. */
    std::vector<Modes::Vector> predicted_strains;

    /** The time that passes between the last equilibrium and this state, and
     * the temperature; no time in converged states. */
    TimeStep time_step;

    /** The angular velocity of the transport of the material through the mesh
     * around the axle (ALE) during the step, so that each point has the past of
     * the one behind it; none where the material stays in its cells. Unit:
     * radians/time. */
    std::optional<double> transport_velocity;

    /** The step in which bristles have moved on to this state; null where
     * rolling is steady. */
    std::shared_ptr<const RollingStep> rolling_step;

    /** What happens between the shell and each body, by ContactPair::number;
     * the first body is the ground. */
    std::vector<ContactState> contacts;

    /** What the force terms remember, by ForceTerm::name(). */
    std::map<std::string, TermState> terms;

    /** The prestress from earlier stages, which copies share; null if only the
     * laminate has one. */
    std::shared_ptr<const Prestress> prestress;

    /** The state about which the strains are linearized; null in nonlinear
     * theory. */
    std::shared_ptr<const State> linearization_point;

    /** The contact state of the ground. */
    const ContactState &
    ground() const
    {
      return contacts.front();
    }
  };
} // namespace Biface

#endif
