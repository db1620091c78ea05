// SPDX-License-Identifier: LGPL-2.1-or-later

// A step in time of a wheel that rolls: what rolling and contact add to the
// tangent is the derivative of what they add to the residual, also with respect
// to the angular velocity at its end, and so are the derivatives of the moment
// of the axle. At a constant angular velocity the work of the forces of inertia
// is the change of the kinetic energy in the frame of the axle and of the
// potential of the centrifugal forces, and the moment of the axle on a wheel
// without ground the rate of its angular momentum.

#include <cmath>
#include <string>

#include <biface/contact/contact_laws.h>
#include <biface/contact/contact_laws_of_stage.h>
#include <biface/contact/rolling.h>
#include <biface/laminate/layup.h>
#include <biface/model/contact/approach.h>
#include <biface/model/contact/contact_interaction.h>
#include <biface/model/contact/contact_pair.h>
#include <biface/model/contact/contact_parameters.h>
#include <biface/model/equations/force_terms.h>
#include <biface/model/forces/nodal_forces.h>
#include <biface/model/state/loads.h>
#include <biface/model/state/placed_body.h>
#include <biface/model/state/rolling_step.h>
#include <biface/model/state/step_in_time.h>
#include <biface/model/time/axle_moment_in_time.h>
#include <biface/model/time/energy_of_motion.h>
#include <biface/model/time/inertia.h>

#include "coarse_torus.h"
#include <cord_ply.h>
#include <tests.h>

using namespace dealii;
using namespace Biface;

namespace
{
  constexpr double duration = 0.01;

  /** A wheel on a ground, or without one, in a step from one shape to
   * another. */
  struct Wheel
  {
    Wheel(const Formulation                  formulation,
          const RigidBody::Parameters::Shape shape,
          const bool                         with_ground)
    {
      auto material       = cord_ply();
      material[0].density = 1e-6;
      const Layup layup(Layup::Parameters(), material);
      mesh = coarse_torus(layup, formulation, true);
      ContactParameters parameters;
      parameters.condition.penalty_stiffness = 1;
      parameters.friction.coefficient = FrictionCoefficient("Friction", "0.4");
      parameters.friction.in_rolling  = FrictionInRolling::bristles;
      parameters.friction.tangential_stiffness = 0.3;
      parameters.body.line.direction           = Tensor<1, 3>({1, 0.2, -0.1});
      parameters.body.shape                    = shape;
      parameters.body.drum.radius              = 300;
      parameters.body.drum.axis                = Tensor<1, 3>({-0.2, 1, 0.3});
      contact = std::make_unique<ContactInteraction>(*mesh, parameters);
      ForceTerms terms = make_force_terms(*mesh, *contact);
      terms.push_back(std::make_unique<Inertia>(*mesh));
      equations = std::make_unique<ShellEquations>(*mesh, std::move(terms));
      ground    = with_ground;
      start = at(*equations, State(*mesh), some_displacement(*mesh, 0.2, 1));
      start.velocity = mesh->ghosted_vector();
      // a temporary would be moved, without the entries of ghosts
      const LA::Vector velocity = some_displacement(*mesh, 30, 5);
      start.velocity            = velocity;
      touching = travel_at_first_contact(contact->ground(), start);
    }

    /** The loads at an angular velocity; none for a shell that stands, without
     * ground. */
    Loads
    loads(const std::optional<double> &omega) const
    {
      Loads result;
      if (!omega)
        return result;
      const double    slip_angle = 0.02;
      const RigidBody body       = ground_at_slip_angle(
        contact->ground().moving_body.after_travel(touching + 15), slip_angle);
      if (ground)
        result.place(0, {body, contact->ground().laws({}, true)});
      result.rolling = std::make_shared<const Rolling>(
        Rolling{*omega, GroundMotion::under_wheel(body, 1000, slip_angle)});
      return result;
    }

    State
    end(const LA::Vector &V, const std::optional<double> &omega_at_start) const
    {
      State result            = at(*equations, start, V);
      auto  step              = std::make_shared<StepInTime>();
      step->start             = start;
      step->loads_at_start    = loads(omega_at_start);
      step->duration          = duration;
      step->moment_of_inertia = 3e-3;
      step->middle.factors    = {0};
      if (ground && omega_at_start)
        result.rolling_step = std::make_shared<const RollingStep>(RollingStep{
          start.displacement, start.contacts, step->loads_at_start, duration});
      result.step = step;
      return result;
    }

    std::unique_ptr<ShellMesh>          mesh;
    std::unique_ptr<ContactInteraction> contact;
    std::unique_ptr<ShellEquations>     equations;
    bool                                ground;
    State                               start;
    double                              touching = 0;
  };


  void
  check_derivatives(const std::string                 &name,
                    const Formulation                  formulation,
                    const RigidBody::Parameters::Shape shape)
  {
    // on a curved ground the tangent is without the derivative of what makes
    // the work of the pressure exact
    const double exact =
      (shape == RigidBody::Parameters::Shape::plane ? 1e-7 : 1e-3);
    Wheel        wheel(formulation, shape, true);
    const double omega_0 = 4, omega = 5, step = 1e-5;
    LA::Vector   V       = some_displacement(*wheel.mesh, 0.3, 2);
    const Loads  rolling = wheel.loads(omega), standing = wheel.loads({});
    wheel.contact->settle(wheel.start, wheel.loads(omega_0));

    // what rolling and contact add: the tangent of the rest is symmetrized
    const LA::Vector dV      = some_displacement(*wheel.mesh, 1, 4);
    LA::Vector       product = wheel.mesh->owned_vector(), other = product;
    wheel.equations->assemble(wheel.end(V, omega_0), rolling);
    wheel.equations->tangent().vmult(product, dV);
    wheel.equations->assemble(wheel.end(V, {}), standing);
    wheel.equations->tangent().vmult(other, dV);
    product -= other;
    const double scale = product.l2_norm();

    std::vector<LoadRates> rates(1);
    rates[0].angular_velocity      = 1;
    const LinearizedResultant here = axle_moment_in_time(
      *wheel.contact, wheel.end(V, omega_0), rolling, rates);
    double     gradient = here.gradient * dV, per_load = here.per_load[0];
    LA::Vector direction =
      wheel.equations->load_direction(wheel.end(V, omega_0), rolling, rates[0]);
    const double direction_scale = direction.l2_norm();
    for (const double sign : {-1., 1.})
      {
        LA::Vector moved(V);
        moved.add(sign * step, dV);
        const State there = wheel.end(moved, omega_0);
        wheel.equations->assemble(there, rolling);
        product.add(sign / (2 * step), wheel.equations->residual());
        gradient -= sign / (2 * step) *
                    axle_moment_in_time(*wheel.contact, there, rolling).value;
        wheel.equations->assemble(wheel.end(moved, {}), standing);
        product.add(-sign / (2 * step), wheel.equations->residual());

        const Loads faster = wheel.loads(omega + sign * step);
        wheel.equations->assemble(wheel.end(V, omega_0), faster);
        direction.add(-sign / (2 * step), wheel.equations->residual());
        per_load -=
          sign / (2 * step) *
          axle_moment_in_time(*wheel.contact, wheel.end(V, omega_0), faster)
            .value;
      }
    const unsigned int n_active = wheel.contact->count_active(wheel.start);
    const double deviation = product.l2_norm(), of_load = direction.l2_norm(),
                 gradient_scale = here.gradient.l2_norm() * dV.l2_norm();
    if (Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) != 0)
      return;
    std::cout << name << std::endl;
    check_range("  nodes in contact at the start", n_active, 4, 40);
    check_small("  tangent", deviation, exact, scale);
    check_small(
      "  residual by angular velocity", of_load, 1e-7, direction_scale);
    check_small("  moment by displacements", gradient, exact, gradient_scale);
    check_small("  moment by angular velocity",
                per_load,
                1e-7,
                std::abs(here.per_load[0]));
    check_true("  not symmetric",
               !wheel.equations->tangent_is_symmetric(rolling));
  }


  void
  check_conservation(const std::string &name, const Formulation formulation)
  {
    Wheel        wheel(formulation, RigidBody::Parameters::Shape::plane, false);
    const double omega = 5;
    const Loads  loads = wheel.loads(omega);
    State        state = wheel.end(some_displacement(*wheel.mesh, 0.3, 2),
                            std::optional<double>(omega));
    const auto   step  = state.step;
    const double moment =
      axle_moment_in_time(*wheel.contact, state, loads).value;
    // of the forces of inertia alone
    double work = 0;
    {
      const auto forces = wheel.equations->nodal_forces(state, loads).of_bodies;
      LA::Vector change = owned_part(state.displacement);
      change -= owned_part(wheel.start.displacement);
      work = forces.at(Inertia::body) * change;
      const LA::Vector of_wheel =
        wheel.equations->nodal_forces(state, loads)[ForceTerm::Source::loads];
      work += of_wheel * change;
    }
    const LA::Vector velocity = step->velocity(state);
    state.velocity            = wheel.mesh->ghosted_vector();
    state.velocity            = velocity;
    const auto energy         = [&](const State &at) {
      return energy_of_motion(*wheel.equations, *wheel.contact, at, loads);
    };
    const EnergyOfMotion before = energy(wheel.start), after = energy(state);
    if (Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) != 0)
      return;
    std::cout << name << std::endl;
    check_small("  work of inertia",
                work + after.kinetic + after.centrifugal - before.kinetic -
                  before.centrifugal,
                1e-11,
                after.kinetic);
    check_small("  moment of the axle",
                moment -
                  (after.angular_momentum[1] - before.angular_momentum[1]) /
                    duration,
                1e-10,
                after.angular_momentum.norm() / duration);
    check_true("  that changes",
               std::abs(moment) >
                 1e-4 * after.angular_momentum.norm() / duration);
  }
} // namespace


int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  using Shape = RigidBody::Parameters::Shape;
  check_derivatives("on a plane", Formulation::standard, Shape::plane);
  check_derivatives("on a drum", Formulation::standard, Shape::drum);
  check_derivatives("paper's element", Formulation::paper, Shape::plane);
  check_conservation("without ground", Formulation::standard);
  check_conservation("paper's element without ground", Formulation::paper);
}
