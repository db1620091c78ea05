// SPDX-License-Identifier: LGPL-2.1-or-later

// The tangent of a rolling wheel is the derivative of the residual, also with
// respect to the angular velocity and to the travel of the ground; the
// derivatives of the moment of the axle and of the force on the ground are
// exact, too. The wheel has mass and rolls on an inclined plane or on a drum,
// some nodes slip, and the coefficient of friction depends on pressure and slip
// velocity. Without friction the tangent is symmetric. A wheel that stands
// still in the same frame has the same derivatives.

#include <array>
#include <cmath>

#include <biface/contact/contact_laws_of_stage.h>
#include <biface/contact/rolling.h>
#include <biface/laminate/layup.h>
#include <biface/model/contact/approach.h>
#include <biface/model/contact/contact_interaction.h>
#include <biface/model/contact/contact_pair.h>
#include <biface/model/contact/contact_parameters.h>
#include <biface/model/equations/force_terms.h>
#include <biface/model/quantities/contact_resultants.h>
#include <biface/model/state/loads.h>
#include <biface/model/state/placed_body.h>

#include "coarse_torus.h"
#include <cord_ply.h>
#include <tests.h>

using namespace dealii;
using namespace Biface;

namespace
{
  void
  test(const std::string                 &name,
       const RigidBody::Parameters::Shape shape,
       const double                       omega,
       const Formulation                  formulation = Formulation::paper,
       const FrictionInRolling friction = FrictionInRolling::slip_velocity)
  {
    auto material       = cord_ply();
    material[0].density = 1e-4;
    const Layup layup(Layup::Parameters(), material);
    const auto  mesh = coarse_torus(layup, formulation, true);

    ContactParameters parameters;
    parameters.condition.penalty_stiffness = 1;
    parameters.friction.coefficient =
      FrictionCoefficient("Friction",
                          friction == FrictionInRolling::bristles
                            ? "0.4 + 0.1*p"
                            : "(0.4 + 0.1*p)*(1 + exp(-s/200))/2");
    parameters.friction.in_rolling           = friction;
    parameters.friction.tangential_stiffness = 0.3;
    parameters.friction.critical_velocity    = 20;
    parameters.body.line.direction           = Tensor<1, 3>({1, 0.2, -0.1});
    parameters.body.shape                    = shape;
    parameters.body.drum.radius              = 300;
    parameters.body.drum.axis                = Tensor<1, 3>({-0.2, 1, 0.3});
    const ContactInteraction contact(*mesh, parameters);
    ShellEquations           equations(*mesh, make_force_terms(*mesh, contact));

    State state = at(equations, State(*mesh), some_displacement(*mesh, 0.2, 1));
    Loads loads;
    const auto   law        = contact.ground().laws({}, true);
    const double touching   = travel_at_first_contact(contact.ground(), state);
    const auto   set_travel = [&](Loads &loads, const double travel) {
      const double slip_angle = 0.02;
      loads.place(
        0,
        {ground_at_slip_angle(
           contact.ground().moving_body.after_travel(touching + travel),
           slip_angle),
         law});
      loads.rolling = std::make_shared<const Rolling>(
        Rolling{omega,
                GroundMotion::under_wheel(
                  *loads.ground(), 200 * omega + 5, slip_angle)});
    };
    set_travel(loads, 15);
    contact.settle(state, loads);
    const unsigned int n_active   = contact.count_active(state);
    const unsigned int n_slipping = contact.count_slipping(state, loads);

    // by the displacements
    const double     step    = 1e-5;
    const LA::Vector dV      = some_displacement(*mesh, 1, 4);
    LA::Vector       product = mesh->owned_vector();
    equations.assemble(state, loads);
    equations.tangent().vmult(product, dV);
    const double           scale = product.l2_norm();
    std::vector<LoadRates> rates(2);
    rates[0].angular_velocity = 1;
    rates[1].travel           = 1;
    const auto resultants     = [&](const State &state, const Loads &loads) {
      return std::array<LinearizedResultant, 2>{
        {axle_moment(contact, state, loads, rates),
         ground_force(contact.ground(), state, loads, rates)}};
    };
    const auto            here = resultants(state, loads);
    std::array<double, 2> gradients{};
    for (unsigned int i = 0; i < 2; ++i)
      gradients[i] = here[i].gradient * dV;
    for (const double sign : {-1., 1.})
      {
        LA::Vector V = mesh->owned_vector();
        V            = state.displacement;
        V.add(sign * step, dV);
        const State moved = at(equations, state, V);
        equations.assemble(moved, loads);
        product.add(sign / (2 * step), equations.residual());
        const auto there = resultants(moved, loads);
        for (unsigned int i = 0; i < 2; ++i)
          gradients[i] -= sign / (2 * step) * there[i].value;
      }

    // by the loads
    std::array<double, 2>                by_load{}, load_scales{};
    std::array<std::array<double, 2>, 2> per_load{};
    for (unsigned int l = 0; l < 2; ++l)
      {
        LA::Vector direction = equations.load_direction(state, loads, rates[l]);
        load_scales[l]       = direction.l2_norm();
        for (unsigned int i = 0; i < 2; ++i)
          per_load[i][l] = here[i].per_load[l];
        for (const double sign : {-1., 1.})
          {
            Loads moved = loads;
            if (l == 0)
              moved.rolling = std::make_shared<const Rolling>(
                Rolling{omega + sign * step, loads.rolling->ground});
            else
              set_travel(moved, 15 + sign * step);
            equations.assemble(state, moved);
            direction.add(-sign / (2 * step), equations.residual());
            const auto there = resultants(state, moved);
            for (unsigned int i = 0; i < 2; ++i)
              per_load[i][l] -= sign / (2 * step) * there[i].value;
          }
        by_load[l] = direction.l2_norm();
      }

    Loads smooth = loads;
    smooth.place(0, {*loads.ground(), ContactLaws(law.condition())});
    equations.assemble(state, smooth);
    const LA::Vector other = some_displacement(*mesh, 1, 9);
    LA::Vector       left = mesh->owned_vector(), right = left;
    equations.tangent().vmult(left, dV);
    equations.tangent().vmult(right, other);
    const double asymmetry       = left * other - right * dV;
    const double asymmetry_scale = left.l2_norm() * other.l2_norm();

    const double          deviation = product.l2_norm() / scale;
    std::array<double, 2> gradient_scales{};
    for (unsigned int i = 0; i < 2; ++i)
      gradient_scales[i] = here[i].gradient.l2_norm() * dV.l2_norm();
    if (Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) != 0)
      return;
    std::cout << name << std::endl;
    check_range("  nodes in contact", n_active, 4, 40);
    check_range("  nodes that slip", n_slipping, omega == 0 ? 0 : 1, 40);
    check_small("  tangent", deviation, 1e-8);
    const std::array<std::string, 2> names{{"moment", "force"}},
      load_names{{"angular velocity", "travel"}};
    for (unsigned int l = 0; l < 2; ++l)
      check_small(
        "  residual by " + load_names[l], by_load[l], 1e-8, load_scales[l]);
    for (unsigned int i = 0; i < 2; ++i)
      {
        check_small("  " + names[i] + " by displacements",
                    gradients[i],
                    1e-8,
                    gradient_scales[i]);
        for (unsigned int l = 0; l < 2; ++l)
          check_small("  " + names[i] + " by " + load_names[l],
                      per_load[i][l],
                      1e-7,
                      i == 0 ? 250 * load_scales[l] : load_scales[l]);
      }
    check_true("  not symmetric", !equations.is_symmetric(loads));
    check_true("  symmetric without friction", equations.is_symmetric(smooth));
    check_small("  its asymmetry", asymmetry, 1e-12, asymmetry_scale);
  }
} // namespace


int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  using Shape = RigidBody::Parameters::Shape;
  test("rolling", Shape::plane, 5);
  test("standing on moving ground", Shape::plane, 0);
  test("rolling on a drum", Shape::drum, 5);
  test("rolling, standard formulation", Shape::plane, 5, Formulation::standard);
  for (const auto shape : {Shape::plane, Shape::drum})
    for (const double omega : {5., -5.})
      test((omega < 0 ? "backward on bristles, body " : "on bristles, body ") +
             std::to_string(static_cast<int>(shape)),
           shape,
           omega,
           Formulation::paper,
           FrictionInRolling::bristles);
}
