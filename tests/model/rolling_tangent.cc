// SPDX-License-Identifier: LGPL-2.1-or-later

// Of a wheel with mass that rolls with friction on an inclined plane or on a
// drum, some nodes slipping, with a coefficient of friction that depends on
// pressure and slip velocity, the tangent is the derivative of the residual,
// also by the angular velocity and by the travel of the ground, and so are the
// derivatives of the moment of the axle; without friction the tangent is
// symmetric. A wheel that stands still in the same frame has the same
// derivatives.

#include <cmath>

#include <biface/model/axle_moment.h>

#include "coarse_torus.h"
#include <cord_ply.h>
#include <tests.h>

using namespace dealii;
using namespace Biface;

namespace
{
  void
  test(const std::string                       &name,
       const RigidFoundation::Parameters::Shape shape,
       const double                             omega)
  {
    auto material       = cord_ply();
    material[0].density = 1e-4;
    const Layup layup(Layup::Parameters(), material);
    const auto  mesh = coarse_torus(layup, StrainSampling::vertices, true);

    ContactInteraction::Parameters parameters;
    parameters.condition.regularization   = 1;
    parameters.friction.coefficient       = "(0.4 + 0.1*p)*(1 + exp(-s/200))/2";
    parameters.friction.critical_velocity = 20;
    parameters.foundation.line.direction  = Tensor<1, 3>({1, 0.2, -0.1});
    parameters.foundation.shape           = shape;
    parameters.foundation.drum.radius     = 300;
    parameters.foundation.drum.axis       = Tensor<1, 3>({-0.2, 1, 0.3});
    const ContactInteraction contact(*mesh, parameters);
    ShellEquations           equations(*mesh, make_force_terms(*mesh, contact));

    State state = at(equations, State(*mesh), some_displacement(*mesh, 0.2, 1));
    Loads loads;
    const double touching   = contact.touching_travel(state);
    const auto   set_travel = [&](Loads &loads, const double travel) {
      const double slip_angle = 0.02;
      loads.foundation =
        on_steered(contact.foundation(touching + travel), slip_angle);
      loads.rolling->ground = GroundMotion::under_wheel(
        *loads.foundation, 200 * omega + 5, slip_angle);
    };
    loads.rolling = Rolling{omega};
    set_travel(loads, 15);
    loads.friction = contact.friction("", "", false);
    contact.settle(state, loads);
    const unsigned int n_active   = contact.count_active(state);
    const unsigned int n_slipping = contact.count_slipping(state, loads);

    const double     step    = 1e-5;
    const LA::Vector dV      = some_displacement(*mesh, 1, 4);
    LA::Vector       product = mesh->owned_vector();
    equations.assemble(state, loads);
    equations.tangent().vmult(product, dV);
    const double scale          = product.l2_norm();
    const auto   moment         = axle_moment(equations, state, loads);
    double       gradient       = moment.gradient * dV;
    const double gradient_scale = moment.gradient.l2_norm() * dV.l2_norm();
    for (const double sign : {-1., 1.})
      {
        LA::Vector V = mesh->owned_vector();
        V            = state.displacement;
        V.add(sign * step, dV);
        const State moved = at(equations, state, V);
        equations.assemble(moved, loads);
        product.add(sign / (2 * step), equations.residual());
        gradient -=
          sign / (2 * step) * axle_moment(equations, moved, loads).value;
      }

    LoadRates rates;
    rates.angular_velocity    = 1;
    LA::Vector   direction    = equations.load_direction(state, loads, rates);
    const double norm         = direction.l2_norm();
    double       per_velocity = moment.per_angular_velocity;
    for (const double sign : {-1., 1.})
      {
        Loads moved = loads;
        moved.rolling->angular_velocity += sign * step;
        equations.assemble(state, moved);
        direction.add(-sign / (2 * step), equations.residual());
        per_velocity -=
          sign / (2 * step) * axle_moment(equations, state, moved).value;
      }

    rates                    = LoadRates();
    rates.travel             = 1;
    LA::Vector   by_travel   = equations.load_direction(state, loads, rates);
    const double travel_norm = by_travel.l2_norm();
    for (const double sign : {-1., 1.})
      {
        Loads moved = loads;
        set_travel(moved, 15 + sign * step);
        equations.assemble(state, moved);
        by_travel.add(-sign / (2 * step), equations.residual());
      }

    Loads smooth = loads;
    smooth.friction.reset();
    equations.assemble(state, smooth);
    const LA::Vector other = some_displacement(*mesh, 1, 9);
    LA::Vector       left = mesh->owned_vector(), right = left;
    equations.tangent().vmult(left, dV);
    equations.tangent().vmult(right, other);
    const double asymmetry       = left * other - right * dV;
    const double asymmetry_scale = left.l2_norm() * other.l2_norm();

    const double deviation    = product.l2_norm() / scale;
    const double by_omega     = direction.l2_norm();
    const double travel_error = by_travel.l2_norm();
    if (Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) != 0)
      return;
    std::cout << name << std::endl;
    check_range("  nodes in contact", n_active, 4, 40);
    check_range("  nodes that slip", n_slipping, omega == 0 ? 0 : 1, 40);
    check_small("  tangent", deviation, 1e-8);
    check_small("  residual by angular velocity", by_omega, 1e-8, norm);
    check_small("  residual by travel", travel_error, 1e-8, travel_norm);
    check_small("  moment by displacements", gradient, 1e-8, gradient_scale);
    check_small("  moment by angular velocity",
                per_velocity,
                1e-7,
                moment.per_angular_velocity);
    check_true("  not symmetric", !equations.is_symmetric(loads));
    check_true("  symmetric without friction", equations.is_symmetric(smooth));
    check_small("  its asymmetry", asymmetry, 1e-12, asymmetry_scale);
  }
} // namespace


int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  using Shape = RigidFoundation::Parameters::Shape;
  test("rolling", Shape::plane, 5);
  test("standing on moving ground", Shape::plane, 0);
  test("rolling on a drum", Shape::drum, 5);
}
