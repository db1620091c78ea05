// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_model_state_state_h
#define biface_model_state_state_h

#include <deal.II/base/point.h>
#include <deal.II/base/table.h>
#include <deal.II/base/tensor.h>

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <biface/base/linear_algebra.h>
#include <biface/contact/contact_laws.h>
#include <biface/contact/contact_state.h>
#include <biface/contact/rigid_body.h>
#include <biface/contact/rolling.h>
#include <biface/element/modes.h>
#include <biface/laminate/time_step.h>
#include <biface/model/mesh/shell_mesh.h>

namespace Biface
{
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

    /** The angular velocity at which the material flows through the mesh around
     * the axle during the step, so that each point has the past of the one
     * behind it; none where the material stays in its cells. Unit:
     * radians/time. */
    std::optional<double> flow;

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


  /** A rigid body at its present place, and the laws of its contact. */
  struct PlacedBody
  {
    RigidBody   body;
    ContactLaws laws;
    /** The face of the shell that the body touches. */
    Resultants::Face face = Resultants::outer;
    std::string      name = "foundation";
  };


  /** The factor at a position, or the common one, which is the first, if there
   * is none. */
  template <typename Number>
  const Number &
  factor_at(const std::vector<Number> &factors, const unsigned int position)
  {
    return factors[position < factors.size() ? position : 0];
  }


  /** The derivatives of the loads by a parameter. */
  struct LoadRates
  {
    double              pressure = 0;
    std::vector<double> factors  = {0};
    /** The rate of the travel of the foundation. */
    double travel = 0;
    /** The rate of the angular velocity of a rolling wheel, see Rolling. */
    double angular_velocity = 0;

    /** Add a multiple of other rates. */
    void
    add(const double scale, const LoadRates &other)
    {
      pressure += scale * other.pressure;
      if (factors.size() < other.factors.size())
        factors.resize(other.factors.size(), factors[0]);
      for (unsigned int i = 0; i < factors.size(); ++i)
        factors[i] += scale * factor_at(other.factors, i);
      travel += scale * other.travel;
      angular_velocity += scale * other.angular_velocity;
    }

    /** The velocity of the point of a body at @p x. */
    dealii::Tensor<1, 3>
    velocity_of(const RigidBody &body, const dealii::Point<3> &x) const
    {
      return body.velocity(x, travel, [this](const unsigned int factor) {
        return factor_at(factors, factor);
      });
    }

    /** The change of velocity_of(), at a point that does not move, as the body
     * moves by other rates. */
    dealii::Tensor<1, 3>
    change_of_velocity(const RigidBody        &body,
                       const dealii::Point<3> &x,
                       const LoadRates        &moves) const
    {
      const auto rate_of = [](const LoadRates &rates) {
        return [&rates](const unsigned int factor) {
          return factor_at(rates.factors, factor);
        };
      };
      return body.change_of_velocity(
        x, travel, rate_of(*this), moves.travel, rate_of(moves));
    }

    /** The angular velocity of a body. */
    dealii::Tensor<1, 3>
    angular_velocity_of(const RigidBody &body) const
    {
      return body.angular_velocity(travel, [this](const unsigned int factor) {
        return factor_at(factors, factor);
      });
    }
  };


  /** The loads on the shell. */
  struct Loads
  {
    /** The pressure, see PressureLoad. Unit: force/area. */
    double pressure = 0;

    /** The factors of the dead loads and prescribed displacements: first the
     * common one, of all those without a factor of their own, see factor_at().
     */
    std::vector<double> factors = {0};

    /** The factors at which prescribed displacements vanish, see
     * Progress::factors_of_shape. */
    std::vector<double> factors_of_shape = {0};

    /** The pressure and the factors at the start of a stage of linear strain
     * theory, with which the loads that follow the shell turn as it deforms,
     * and the others of no meaning; if not set, those above. The forces of
     * their change are those on the shape at the start. */
    std::optional<LoadRates> linearized_at;

    /** Whether the gas that exerts the pressure is sealed in, so that the
     * pressure follows from the state, see Gas. */
    bool sealed_gas = false;

    /** The viscous damping, see ViscousDamping. Unit: force/volume. */
    double damping = 0;

    /** The part of the stage that passes between the last equilibrium and the
     * one that is sought; 0 for the loads in an equilibrium. */
    double part_of_stage = 0;

    /** The bodies that are there, by ContactPair::number; the first is the
     * ground. */
    std::map<unsigned int, PlacedBody> bodies;

    /** The motion of wheel and ground, if the shell rolls. */
    std::optional<Rolling> rolling;

    /** Put the body of a pair in a place. */
    void
    place(const unsigned int number, const PlacedBody &body)
    {
      bodies.insert_or_assign(number, body);
    }

    /** The body of a pair; null if it is not there. */
    const PlacedBody *
    body(const unsigned int number) const
    {
      const auto found = bodies.find(number);
      return found == bodies.end() ? nullptr : &found->second;
    }

    /** The ground; null if it is not there. */
    const RigidBody *
    ground() const
    {
      return body(0) ? &body(0)->body : nullptr;
    }
  };


  /** The strain-displacement relations of a stage. */
  enum class StrainTheory
  {
    nonlinear,
    /** The relations linearized about the state at the start of the stage. */
    linear
  };


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
} // namespace Biface

#endif
