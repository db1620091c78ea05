// SPDX-License-Identifier: LGPL-2.1-or-later

// The multipliers of a state vanish at nodes apart from the ground, are
// those of the clearance at nodes in contact, and integrate, as a bilinear
// field, to the reported force and the forces on the shell.

#include <biface/laminate/layup.h>
#include <biface/model/contact/approach.h>
#include <biface/model/contact/contact_interaction.h>
#include <biface/model/contact/contact_pair.h>
#include <biface/model/contact/contact_parameters.h>
#include <biface/model/contact/contact_summary.h>
#include <biface/model/equations/force_terms.h>
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
       const MortarMatrix                 mass)
  {
    const Layup layup(Layup::Parameters(), cord_ply());
    const auto  mesh = coarse_torus(layup);

    ContactParameters parameters;
    parameters.condition.mortar_matrix     = mass;
    parameters.condition.penalty_stiffness = 2;
    parameters.body.shape                  = shape;
    parameters.body.sphere                 = {300};
    const ContactInteraction contact(*mesh, parameters);
    ShellEquations           equations(*mesh, make_force_terms(*mesh, contact));

    State state = at(equations, State(*mesh), some_displacement(*mesh, 0.2, 1));
    Loads loads;
    loads.place(0,
                {contact.ground().moving_body.after_travel(
                   travel_at_first_contact(contact.ground(), state) + 12),
                 contact.ground().laws()});
    contact.settle(state, loads);
    // another displacement, farther back: nodes leave
    loads.place(0, {loads.ground()->moved(-7), contact.ground().laws()});
    state = at(equations, state, some_displacement(*mesh, 0.6, 5));
    const unsigned int n_changes = contact.settle(state, loads);

    double apart = 0, condition = 0, tangential = 0, largest = 0;
    for (unsigned int n = 0; n < mesh->nodes.size(); ++n)
      {
        const Tensor<1, 3> &lambda = state.contacts[0].multipliers[n];
        largest                    = std::max(largest, std::abs(lambda[0]));
        tangential =
          std::max({tangential, std::abs(lambda[1]), std::abs(lambda[2])});
        const double c = contact.ground().clearance(state, loads, n);
        if (state.contacts[0].active[n])
          condition = std::max(condition, std::abs(c - lambda[0] / 2));
        else
          apart = std::max(apart, std::abs(lambda[0]));
      }

    // the traction at Gauss' points of each cell, times the shape functions
    const ContactSummary summary = summarize(contact.ground(), state, loads);
    const Tensor<1, 3>   d       = loads.ground()->direction();
    double               force   = 0;
    LA::Vector           forces  = mesh->owned_vector();
    for (const Cell &cell : mesh->cells)
      {
        std::array<Tensor<1, 3>, 4> traction;
        for (unsigned int s = 0; s < 4; ++s)
          {
            const Node &node = mesh->nodes[cell.nodes[s]];
            traction[s]      = state.contacts[0].multipliers[cell.nodes[s]][0] *
                          loads.ground()
                            ->evaluate(mesh->deformed_position(
                              state.displacement, node, Resultants::outer))
                            .normal;
          }
        MixedElement::NodalVector on_cell;
        const double              gauss = std::sqrt(1. / 3);
        for (unsigned int q = 0; q < 4; ++q)
          {
            const Point<2> xi((1 + (q & 1 ? gauss : -gauss)) / 2,
                              (1 + (q & 2 ? gauss : -gauss)) / 2);
            const auto     N = [&](const unsigned int r) {
              return GeometryInfo<2>::d_linear_shape_function(xi, r);
            };
            Tensor<1, 3> t;
            for (unsigned int s = 0; s < 4; ++s)
              t += N(s) * traction[s];
            force -= cell.geometry.weight / 4 * (t * d);
            for (unsigned int r = 0; r < 4; ++r)
              {
                const Tensor<1, 3> f =
                  cell.geometry.weight / 4 *
                  mesh->nodes[cell.nodes[r]].surface.to_frame(N(r) * t);
                MixedElement::add_face_force(f, r, Resultants::outer, on_cell);
              }
          }
        mesh->add_nodal_forces(cell, on_cell, forces);
      }
    forces.compress(VectorOperation::add);
    mesh->condense(forces);
    force = Utilities::MPI::sum(force, MPI_COMM_WORLD);

    equations.assemble(state, loads);
    const double size = forces.l2_norm();
    forces -= equations.residual();
    equations.assemble(state, Loads());
    forces += equations.residual();
    const double difference = forces.l2_norm();

    largest    = Utilities::MPI::max(largest, MPI_COMM_WORLD);
    apart      = Utilities::MPI::max(apart, MPI_COMM_WORLD);
    condition  = Utilities::MPI::max(condition, MPI_COMM_WORLD);
    tangential = Utilities::MPI::max(tangential, MPI_COMM_WORLD);
    if (Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) != 0)
      return;
    std::cout << name << std::endl;
    check_range("  nodes that left or entered", n_changes, 2, mesh->n_nodes());
    check_true("  multiplier of nodes apart", apart == 0);
    check_true("  tangential multipliers", tangential == 0);
    check_small("  condition of nodes in contact", condition, 1e-14);
    check_small(
      "  maximum pressure", summary.max_pressure - largest, 1e-14, largest);
    check_small("  force", summary.force - force, 1e-13, force);
    if (mass == MortarMatrix::consistent)
      check_small("  forces on the shell", difference, 1e-12, size);
  }
} // namespace


int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  using Shape = RigidBody::Parameters::Shape;
  test(
    "plane, consistent mortar matrix", Shape::plane, MortarMatrix::consistent);
  test("plane, lumped mortar matrix", Shape::plane, MortarMatrix::lumped);
  test("sphere, consistent mortar matrix",
       Shape::sphere,
       MortarMatrix::consistent);
}
