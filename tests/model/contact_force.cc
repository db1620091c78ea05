// SPDX-License-Identifier: LGPL-2.1-or-later

// With the lumped mortar matrix the nodal forces add up to the reported force
// on a curved ground and act through its axis or its center; with both masses
// the derivatives of force and residual by the displacements and the travel are
// correct.

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
  test(const std::string           &name,
       const RigidBody::Parameters &ground,
       const MortarMatrix           mass)
  {
    const Layup layup(Layup::Parameters(), cord_ply());
    const auto  mesh = coarse_torus(layup);

    ContactParameters parameters;
    parameters.condition.mortar_matrix     = mass;
    parameters.condition.penalty_stiffness = 1;
    parameters.body                        = ground;
    const ContactInteraction contact(*mesh, parameters);
    ShellEquations           equations(*mesh, make_force_terms(*mesh, contact));

    State state = at(equations, State(*mesh), some_displacement(*mesh, 0.2, 1));
    Loads loads;
    loads.place(0,
                {contact.ground().moving_body.after_travel(
                   travel_at_first_contact(contact.ground(), state)),
                 contact.ground().laws()});
    const double touching =
      std::abs(remaining_travel(contact.ground(), state, loads)) / mesh->size();
    loads.place(0, {loads.ground()->moved(6), contact.ground().laws()});
    const unsigned int n_active = contact.settle(state, loads);

    // the forces of the contact alone
    equations.assemble(state, Loads());
    LA::Vector forces = equations.residual();
    forces *= -1;
    equations.assemble(state, loads);
    forces += equations.residual();

    Tensor<1, 3>       sum, moment;
    const auto        &line = ground.line;
    const Tensor<1, 3> d    = line.direction / line.direction.norm();
    const double       radius =
      (ground.shape == Shape::drum ? ground.drum.radius : ground.sphere.radius)
        .value_or(0);
    // it has come by as much as it lacks at the point of its line
    const double   travel = -loads.ground()->clearance(line.point);
    const Point<3> center = line.point + (radius - travel) * d;
    for (const Node &node : mesh->nodes)
      if (node.locally_owned)
        {
          const Tensor<1, 3> force = node.surface.from_frame(
            mesh->force_on_any_face(forces, node, Resultants::outer));
          sum += force;
          moment +=
            cross_product_3d(mesh->deformed_position(
                               state.displacement, node, Resultants::outer) -
                               center,
                             force);
        }
    sum    = Utilities::MPI::sum(sum, MPI_COMM_WORLD);
    moment = Utilities::MPI::sum(moment, MPI_COMM_WORLD);

    LoadRates rates;
    rates.travel       = 1;
    const auto   force = ground_force(contact.ground(), state, loads, {rates});
    const double scale = force.value;

    // derivatives with respect to the travel
    const double step  = 1e-5;
    const auto   moved = [&](const double travel) {
      Loads result = loads;
      result.place(0, {loads.ground()->moved(travel), contact.ground().laws()});
      return result;
    };
    const double per_travel =
      (ground_force(contact.ground(), state, moved(step)).value -
       ground_force(contact.ground(), state, moved(-step)).value) /
      (2 * step);
    LA::Vector   direction      = equations.load_direction(state, loads, rates);
    const double direction_norm = direction.l2_norm();
    for (const double sign : {-1., 1.})
      {
        equations.assemble(state, moved(sign * step));
        direction.add(-sign / (2 * step), equations.residual());
      }

    // and to the displacements
    const LA::Vector dV             = some_displacement(*mesh, 1, 4);
    double           gradient       = force.gradient * dV;
    const double     gradient_scale = force.gradient.l2_norm() * dV.l2_norm();
    for (const double sign : {-1., 1.})
      {
        LA::Vector V = mesh->owned_vector();
        V            = state.displacement;
        V.add(sign * step, dV);
        gradient -=
          sign / (2 * step) *
          ground_force(contact.ground(), at(equations, state, V), loads).value;
      }

    const double       deviation = direction.l2_norm();
    const unsigned int n_nodes   = mesh->n_nodes();
    if (Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) != 0)
      return;
    std::cout << name << std::endl;
    check_small("  travel left when it touches", touching, 1e-14);
    check_range("  nodes in contact", n_active, 2, n_nodes / 2);
    // with the consistent mortar matrix, nodes that are held take part of the
    // force
    if (mass == MortarMatrix::lumped)
      {
        check_small("  sum of the forces", sum * d + scale, 1e-12, scale);
        check_small("  moment about axis or center",
                    ground.shape == Shape::drum ? moment * ground.drum.axis
                                                : moment.norm(),
                    1e-12,
                    scale * std::abs(radius));
      }
    check_small("  force by travel",
                force.per_load[0] - per_travel,
                1e-8,
                force.per_load[0]);
    check_small("  residual by travel", deviation, 1e-8, direction_norm);
    check_small("  force by displacements", gradient, 1e-8, gradient_scale);
  }
} // namespace


int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  RigidBody::Parameters ground;
  // the drum's axis is across it, so that the drum's center is on the line
  ground.line.direction = Tensor<1, 3>({1, 0.2, -0.1});
  ground.line.point     = Point<3>(10, 2, -1);
  ground.drum.axis      = Tensor<1, 3>({-0.2, 1, 0});
  ground.drum.axis /= ground.drum.axis.norm();

  ground.shape       = Shape::drum;
  ground.drum.radius = 80;
  test("drum, lumped mortar matrix", ground, MortarMatrix::lumped);
  test("drum, consistent mortar matrix", ground, MortarMatrix::consistent);
  ground.drum.radius = -400;
  test("hollow drum, lumped mortar matrix", ground, MortarMatrix::lumped);

  ground.shape         = Shape::sphere;
  ground.sphere.radius = 120;
  test("sphere, lumped mortar matrix", ground, MortarMatrix::lumped);
  test("sphere, consistent mortar matrix", ground, MortarMatrix::consistent);
}
