// SPDX-License-Identifier: LGPL-2.1-or-later

// The damping of a wheel that rolls with friction on a plane or on a drum, for
// a velocity of the whole wheel, is the derivative of the residual with respect
// to the velocity of the ground; the gyroscopic terms are skew.

#include <deal.II/base/mpi.h>

#include <algorithm>

#include <biface/contact/contact_laws_of_stage.h>
#include <biface/contact/rolling.h>
#include <biface/laminate/layup.h>
#include <biface/model/contact/approach.h>
#include <biface/model/contact/contact_interaction.h>
#include <biface/model/contact/contact_pair.h>
#include <biface/model/contact/contact_parameters.h>
#include <biface/model/equations/force_terms.h>
#include <biface/model/equations/velocity_matrix.h>
#include <biface/model/mesh/rigid_motions.h>
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
       const Formulation                  formulation = Formulation::paper)
  {
    const auto mesh = [formulation](const double density) {
      auto material       = cord_ply();
      material[0].density = density;
      return coarse_torus(
        Layup(Layup::Parameters(), material), formulation, true);
    };
    ContactParameters parameters;
    parameters.condition.penalty_stiffness = 1;
    parameters.friction.coefficient =
      FrictionCoefficient("Friction", "(0.4 + 0.1*p)*(1 + exp(-s/200))/2");
    parameters.friction.critical_velocity = 20;
    parameters.body.line.direction        = Tensor<1, 3>({1, 0.2, -0.1});
    parameters.body.shape                 = shape;
    parameters.body.drum.radius           = 300;
    parameters.body.drum.axis             = Tensor<1, 3>({-0.2, 1, 0.3});

    const auto               light = mesh(0);
    const ContactInteraction contact(*light, parameters);
    ShellEquations equations(*light, make_force_terms(*light, contact));
    State          state =
      at(equations, State(*light), some_displacement(*light, 0.2, 1));
    Loads loads;
    loads.place(0,
                {contact.ground().moving_body.after_travel(
                   travel_at_first_contact(contact.ground(), state) + 15),
                 contact.ground().laws({}, true)});
    loads.rolling = std::make_shared<const Rolling>(
      Rolling{5, GroundMotion::under_wheel(*loads.ground(), 1005, 0.02)});
    contact.settle(state, loads);
    const unsigned int n_active = contact.count_active(state);

    const VelocityMatrix damping(
      contact, state, loads, contact.mesh.constraints);
    double deviation = 0, scale = 0;
    for (unsigned int d = 0; d < 3; ++d)
      {
        const double step = 1e-3;
        LA::Vector   motion(light->owned_vector()), product(motion);
        const auto   entries = rigid_motions(*light)[d];
        std::copy(entries.begin(), entries.end(), motion.begin());
        damping.vmult(product, motion);
        scale = std::max(scale, product.l2_norm());
        for (const double sign : {-1., 1.})
          {
            Loads   moved   = loads;
            Rolling rolling = *loads.rolling;
            rolling.ground.velocity[d] -= sign * step;
            moved.rolling = std::make_shared<const Rolling>(rolling);
            equations.assemble(state, moved);
            product.add(sign / (2 * step), equations.residual());
          }
        deviation = std::max(deviation, product.l2_norm());
      }

    const auto               heavy = mesh(1e-4);
    const ContactInteraction no_friction(*heavy, parameters);
    loads.place(
      0, {*loads.ground(), ContactLaws(contact.ground().laws().condition())});
    const VelocityMatrix gyroscopic(
      no_friction, State(*heavy), loads, no_friction.mesh.constraints);
    const LA::Vector x = some_displacement(*heavy, 1, 4),
                     y = some_displacement(*heavy, 1, 9);
    LA::Vector Gx(heavy->owned_vector()), Gy(Gx);
    gyroscopic.vmult(Gx, x);
    gyroscopic.vmult(Gy, y);
    const double work      = x * Gx;
    const double sum       = x * Gy + y * Gx;
    const double magnitude = x.l2_norm() * Gx.l2_norm();

    if (Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) != 0)
      return;
    std::cout << name << std::endl;
    check_range("  nodes in contact", n_active, 4, 40);
    check_small("  damping", deviation, 1e-8, scale);
    check_range("  gyroscopic forces", magnitude, 1, 1e9);
    check_small("  their power", work, 1e-14, magnitude);
    check_small("  skew", sum, 1e-14, magnitude);
  }
} // namespace


int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  using Shape = RigidBody::Parameters::Shape;
  test("plane", Shape::plane);
  test("drum", Shape::drum);
  test("plane, standard formulation", Shape::plane, Formulation::standard);
}
