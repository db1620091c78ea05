// SPDX-License-Identifier: LGPL-2.1-or-later

// With nodes that stick, slip and are glued, on each shape of ground, slid
// and turned, for both mortar matrices and points in cells, the tangent is
// the derivative of the residual, also by the travel, and the force on the
// ground has the derivatives that it reports.

#include <cmath>

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
  using Shape = RigidBody::Parameters::Shape;


  void
  test(const std::string &name,
       const Shape        shape,
       const MortarMatrix mass,
       const unsigned int points = 0)
  {
    const Layup layup(Layup::Parameters(), cord_ply());
    const auto  mesh = coarse_torus(layup);

    ContactParameters parameters;
    parameters.condition.mortar_matrix     = mass;
    parameters.condition.penalty_stiffness = 1;
    parameters.condition.points_per_side   = points;
    parameters.friction.coefficient =
      FrictionCoefficient("Friction", "0.4 + 0.1*p");
    parameters.friction.tangential_stiffness = 0.7;
    parameters.body.shape                    = shape;
    parameters.body.line.direction           = Tensor<1, 3>({1, 0.2, -0.1});
    parameters.body.drum.radius              = 80;
    parameters.body.drum.axis                = Tensor<1, 3>({0.3, 1, 0.1});
    parameters.body.sphere.radius            = 120;
    const ContactInteraction contact(*mesh, parameters);
    ShellEquations           equations(*mesh, make_force_terms(*mesh, contact));

    State state =
      at(equations, contact.unloaded_state(), some_displacement(*mesh, 0.2, 1));
    const double   touching = travel_at_first_contact(contact.ground(), state);
    const Point<3> pivot =
      first_contact_point(contact.ground(), state, touching);
    const auto law = contact.ground().laws();
    Loads      loads;
    loads.place(
      0, {contact.ground().moving_body.after_travel(touching + 14), law});
    const Tensor<1, 3> across =
      cross_product_3d(loads.ground()->direction(), Tensor<1, 3>({1, 2, 3}));
    loads.place(0, {loads.ground()->displaced(across, 0.1, pivot), law});
    contact.settle(state, loads);
    contact.ground().commit_step(state, loads);

    // the ground moves on, and some nodes are said to do something else
    loads.place(0,
                {contact.ground()
                   .moving_body.after_travel(touching + 15)
                   .displaced(1.3 * across, 0.12, pivot),
                 law});
    contact.settle(state, loads);
    const unsigned int n_active = contact.count_active(state);
    for (unsigned int n = 0; n < contact.ground().points.size(); ++n)
      if (state.contacts[0].statuses[n] != ContactStatus::none)
        switch ((points > 0 ? n : mesh->nodes[n].number) % 3)
          {
            case 0:
              state.contacts[0].statuses[n] = ContactStatus::stick;
              break;
            case 1:
              state.contacts[0].statuses[n] = ContactStatus::slip;
              break;
            default:
              state.contacts[0].statuses[n] = ContactStatus::glued;
          }

    const double     step    = 1e-5;
    const LA::Vector dV      = some_displacement(*mesh, 1, 4);
    LA::Vector       product = mesh->owned_vector();
    equations.assemble(state, loads);
    equations.tangent().vmult(product, dV);
    const double scale = product.l2_norm();
    LoadRates    rates;
    rates.travel       = 1;
    const auto   force = ground_force(contact.ground(), state, loads, {rates});
    double       gradient       = force.gradient * dV;
    const double gradient_scale = force.gradient.l2_norm() * dV.l2_norm();
    for (const double sign : {-1., 1.})
      {
        LA::Vector V = mesh->owned_vector();
        V            = state.displacement;
        V.add(sign * step, dV);
        const State moved = at(equations, state, V);
        equations.assemble(moved, loads);
        product.add(sign / (2 * step), equations.residual());
        gradient -= sign / (2 * step) *
                    ground_force(contact.ground(), moved, loads).value;
      }

    LA::Vector   direction      = equations.load_direction(state, loads, rates);
    const double direction_norm = direction.l2_norm();
    double       per_travel     = force.per_load[0];
    for (const double sign : {-1., 1.})
      {
        Loads moved = loads;
        moved.place(0, {loads.ground()->moved(sign * step), law});
        equations.assemble(state, moved);
        direction.add(-sign / (2 * step), equations.residual());
        per_travel -= sign / (2 * step) *
                      ground_force(contact.ground(), state, moved).value;
      }

    const double       deviation  = product.l2_norm() / scale;
    const double       by_travel  = direction.l2_norm();
    const unsigned int n_slipping = contact.count_slipping(state, loads);
    if (Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) != 0)
      return;
    std::cout << name << std::endl;
    check_range("  nodes in contact", n_active, 4, points > 0 ? 300 : 30);
    check_range("  nodes that slip", n_slipping, 1, points > 0 ? 100 : 10);
    check_small("  tangent", deviation, 1e-8);
    check_small("  residual by travel", by_travel, 1e-8, direction_norm);
    check_small("  force by displacements", gradient, 1e-8, gradient_scale);
    check_small("  force by travel", per_travel, 1e-8, force.per_load[0]);
    check_true("  not symmetric", !equations.is_symmetric(loads));
  }
} // namespace


int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  for (const auto mass : {MortarMatrix::lumped, MortarMatrix::consistent})
    {
      const std::string kind =
        (mass == MortarMatrix::lumped ? ", lumped mortar matrix"
                                      : ", consistent mortar matrix");
      test("plane" + kind, Shape::plane, mass);
      test("drum" + kind, Shape::drum, mass);
      test("sphere" + kind, Shape::sphere, mass);
    }
  test("sphere, points in cells", Shape::sphere, MortarMatrix::lumped, 3);
}
