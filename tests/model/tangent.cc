// SPDX-License-Identifier: LGPL-2.1-or-later

// The tangent of a prestressed shell in contact is minus the derivative of its
// residual for a fixed active set, and symmetric where it claims to be; with a
// plane, a drum and a sphere, and with points in cells.

#include <cmath>

#include <biface/input/parameter_tools.h>
#include <biface/laminate/layup.h>
#include <biface/model/contact/approach.h>
#include <biface/model/contact/contact_interaction.h>
#include <biface/model/contact/contact_pair.h>
#include <biface/model/contact/contact_parameters.h>
#include <biface/model/equations/force_terms.h>
#include <biface/model/forces/dead_loads.h>
#include <biface/model/forces/pressure_load.h>
#include <biface/model/state/loads.h>
#include <biface/model/state/placed_body.h>
#include <biface/model/state/strain_theory.h>

#include "coarse_torus.h"
#include <cord_ply.h>
#include <name_of.h>
#include <tests.h>

using namespace dealii;
using namespace Biface;

namespace
{
  const std::string bias_plies = "cord: 1.2 @ 52, cord: 1.2 @ -52, "
                                 "cord: 1.2 @ 52, cord: 1.2 @ -52";


  using Shape = RigidBody::Parameters::Shape;


  void
  test(const std::string &name,
       const ThicknessLaw law,
       const MortarMatrix mass,
       const StrainTheory theory,
       const PressureKind pressure_kind = PressureKind::dead,
       const std::string &plies         = bias_plies,
       const Shape        ground        = Shape::plane,
       const std::string &shear         = "constant strain",
       const std::string &compression   = "E_L",
       const Formulation  formulation   = Formulation::paper,
       const std::string &layers        = "one",
       const unsigned int points        = 0)
  {
    Layup::Parameters parameters;
    parameters.plies             = parse_plies("plies", plies);
    parameters.layers            = parse_layers("layers", layers);
    parameters.law               = law;
    parameters.shear_law         = parse_transverse_shear("shear", shear);
    auto materials               = cord_ply();
    materials[0].E_L_compression = compression;
    const Layup layup(parameters, materials);
    const auto  mesh = coarse_torus(layup, formulation);

    // ground as soft as the shell, so that neither hides the other
    ContactParameters contact_parameters;
    contact_parameters.condition.mortar_matrix     = mass;
    contact_parameters.condition.penalty_stiffness = 1;
    contact_parameters.condition.points_per_side   = points;
    contact_parameters.body.shape                  = ground;
    contact_parameters.body.line.direction = Tensor<1, 3>({1, 0.2, -0.1});
    contact_parameters.body.drum.radius    = 80;
    contact_parameters.body.drum.axis      = Tensor<1, 3>({0.3, 1, 0.1});
    contact_parameters.body.sphere.radius  = 120;
    const ContactInteraction contact(*mesh, contact_parameters);

    PressureLoad pressure;
    pressure.kind         = pressure_kind;
    pressure.distribution = parse_position_formula(
      "distribution", "1 + 0.3*sin(alpha_1/20) + 0.1*x/250");
    DeadLoads dead_loads;
    dead_loads.edge_moments = parse_edge_moments(
      "moments", "alpha_2 max: 3 follower, alpha_2 min: -2 dead");
    ShellEquations equations(
      *mesh, make_force_terms(*mesh, contact, dead_loads, pressure));
    const InternalForces &internal = equations.internal_forces();
    State                 state =
      at(equations, contact.unloaded_state(), some_displacement(*mesh, 0.2, 1));
    const auto resultants = state.resultants;
    internal.take_as_prestress(state);

    // the prestress stays, and is in equilibrium with what is not listed
    double change = state.displacement.linfty_norm(), stress = 0;
    for (unsigned int c = 0; c < resultants.size(); ++c)
      {
        change = std::hypot(
          change, (internal.total_resultants(state, c) - resultants[c]).norm());
        stress = std::max(stress, resultants[c].norm());
      }
    equations.assemble(state, Loads());
    const double unbalanced = equations.residual().l2_norm();

    change = Utilities::MPI::max(change, MPI_COMM_WORLD);
    stress = Utilities::MPI::max(stress, MPI_COMM_WORLD);

    state = at(equations, state, some_displacement(*mesh, 0.2, 2));
    InternalForces::set_theory(theory, state);
    state = at(equations, state, some_displacement(*mesh, 0.2, 3));

    Loads loads;
    loads.pressure = 0.1;
    loads.factors  = {0.7};
    loads.place(0,
                {contact.ground().moving_body.after_travel(
                   travel_at_first_contact(contact.ground(), state) + 6),
                 contact.ground().laws()});
    const unsigned int n_active = contact.settle(state, loads);

    equations.assemble(state, loads);
    const double force = equations.residual().l2_norm();

    LA::Vector       product = mesh->owned_vector();
    const LA::Vector x       = some_displacement(*mesh, 1, 6);
    const LA::Vector y       = some_displacement(*mesh, 1, 7);
    equations.tangent().vmult(product, y);
    double skew = product * x;
    equations.tangent().vmult(product, x);
    skew = std::abs(skew - product * y) / (product.l2_norm() * y.l2_norm());
    const bool is_symmetric = (skew < 1e-12);

    const double step      = 1e-5;
    double       deviation = 0;
    for (const unsigned int seed : {4, 5})
      {
        const LA::Vector direction = some_displacement(*mesh, 1, seed);
        equations.assemble(state, loads);
        equations.tangent().vmult(product, direction);
        const double scale = product.l2_norm();

        for (const double sign : {-1., 1.})
          {
            LA::Vector V = mesh->owned_vector();
            V            = state.displacement;
            V.add(sign * step, direction);
            equations.assemble(at(equations, state, V), loads);
            product.add(sign / (2 * step), equations.residual());
          }
        deviation = std::hypot(deviation, product.l2_norm() / scale);
      }

    const unsigned int n_nodes = mesh->n_nodes();
    if (Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
      {
        std::cout << name << std::endl;
        check_true("  prestressed", stress > 1);
        check_small("  prestress, its change", change, 1e-14, stress);
        check_small("  and its forces", unbalanced, 1e-12, stress);
        check_range("  nodes in contact",
                    n_active,
                    ground == Shape::plane ? 4 : 2,
                    n_nodes / 2 * std::max(1U, points * points));
        check_true("  forces are there", force > 1);
        check_small("  tangent", deviation, 1e-8);
        check_true("  symmetric or not, as it says",
                   is_symmetric == equations.is_symmetric(loads));
        std::cout << (is_symmetric ? "  symmetric" : "  not symmetric")
                  << std::endl;
      }
  }
} // namespace


int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  test("symmetric law, consistent mortar matrix",
       ThicknessLaw::symmetric,
       MortarMatrix::consistent,
       StrainTheory::nonlinear);
  test("symmetric law, lumped mortar matrix",
       ThicknessLaw::symmetric,
       MortarMatrix::lumped,
       StrainTheory::nonlinear);
  test("asymmetric law, consistent mortar matrix",
       ThicknessLaw::asymmetric,
       MortarMatrix::consistent,
       StrainTheory::nonlinear);
  test("linear theory",
       ThicknessLaw::symmetric,
       MortarMatrix::consistent,
       StrainTheory::linear);
  test("transverse shear from equilibrium",
       ThicknessLaw::symmetric,
       MortarMatrix::lumped,
       StrainTheory::nonlinear,
       PressureKind::dead,
       bias_plies,
       Shape::plane,
       "equilibrium");
  for (const auto theory : {StrainTheory::nonlinear, StrainTheory::linear})
    test(std::string("slack cords") +
           (theory == StrainTheory::linear ? ", linear theory" : ""),
         ThicknessLaw::symmetric,
         MortarMatrix::lumped,
         theory,
         PressureKind::dead,
         bias_plies,
         Shape::plane,
         "equilibrium",
         "E_L/100");
  for (const auto formulation : {Formulation::standard, Formulation::vertices})
    test("formulation: " + name_of(formulation),
         ThicknessLaw::symmetric,
         MortarMatrix::lumped,
         StrainTheory::nonlinear,
         PressureKind::follower,
         bias_plies,
         Shape::plane,
         "equilibrium",
         "E_L/100",
         formulation);
  test("follower pressure",
       ThicknessLaw::symmetric,
       MortarMatrix::lumped,
       StrainTheory::nonlinear,
       PressureKind::follower);
  test("follower pressure, linear theory",
       ThicknessLaw::symmetric,
       MortarMatrix::lumped,
       StrainTheory::linear,
       PressureKind::follower);
  // lines of the coarse torus, whose cells grow by 1.1
  const double first = 110 * 0.1 / (std::pow(1.1, 5) - 1);
  const double begin = -60 + first, end = begin + first * (1.1 + 1.21);
  test("plies that change along the meridian",
       ThicknessLaw::symmetric,
       MortarMatrix::lumped,
       StrainTheory::nonlinear,
       PressureKind::follower,
       "cord: 2 + 0.02*alpha_1 @ 52 - 0.1*alpha_1, cord: 2.4 @ -52, "
       "cord: 1 @ 52 from " +
         number_to_string(begin) + " to " + number_to_string(end));
  for (const auto theory : {StrainTheory::nonlinear, StrainTheory::linear})
    test(std::string("layers, one of which ends") +
           (theory == StrainTheory::linear ? ", linear theory" : ""),
         ThicknessLaw::symmetric,
         MortarMatrix::lumped,
         theory,
         PressureKind::follower,
         "cord: 2 + 0.02*alpha_1 @ 52 - 0.1*alpha_1, cord: 2.4 @ -52, "
         "cord: 1 @ 52 from " +
           number_to_string(begin) + " to " + number_to_string(end),
         Shape::plane,
         "constant strain",
         "E_L/100",
         Formulation::standard,
         "1/2, 3/2, 1");
  for (const auto mass : {MortarMatrix::lumped, MortarMatrix::consistent})
    {
      const std::string name =
        (mass == MortarMatrix::lumped ? "lumped mortar matrix"
                                      : "consistent mortar matrix");
      test("drum, " + name,
           ThicknessLaw::symmetric,
           mass,
           StrainTheory::nonlinear,
           PressureKind::dead,
           bias_plies,
           Shape::drum);
      test("sphere, " + name,
           ThicknessLaw::symmetric,
           mass,
           StrainTheory::nonlinear,
           PressureKind::dead,
           bias_plies,
           Shape::sphere);
    }
  test("points in cells, layers, drum",
       ThicknessLaw::symmetric,
       MortarMatrix::lumped,
       StrainTheory::nonlinear,
       PressureKind::dead,
       bias_plies,
       Shape::drum,
       "constant strain",
       "E_L",
       Formulation::standard,
       "3, 1",
       3);
}
