// SPDX-License-Identifier: LGPL-2.1-or-later

// The tangent is symmetric, and says so, unless a ground is there with the
// consistent mortar matrix, or a follower pressure that is not zero on a
// shell with free edges, or the law is not symmetric. On a shell whose edges
// are held, a follower pressure leaves it symmetric.

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

#include "coarse_torus.h"
#include <cord_ply.h>
#include <tests.h>

using namespace dealii;
using namespace Biface;

namespace
{
  void
  test(const std::string &name,
       const ThicknessLaw law,
       const MortarMatrix mass,
       const PressureKind kind,
       const bool         symmetric,
       const bool         with_pressure,
       const bool         with_ground,
       const bool         closed      = false,
       const Formulation  formulation = Formulation::paper)
  {
    Layup::Parameters parameters;
    parameters.law = law;
    const Layup layup(parameters, cord_ply());
    const auto  mesh = coarse_torus(layup, formulation, closed);

    ContactParameters contact_parameters;
    contact_parameters.condition.mortar_matrix     = mass;
    contact_parameters.condition.penalty_stiffness = 1;
    const ContactInteraction contact(*mesh, contact_parameters);
    PressureLoad             pressure;
    pressure.kind = kind;
    ShellEquations equations(
      *mesh, make_force_terms(*mesh, contact, DeadLoads(), pressure));

    State state = at(equations, State(*mesh), some_displacement(*mesh, 0.2, 1));
    Loads loads;
    loads.pressure = (with_pressure ? 0.1 : 0.);
    if (with_ground)
      loads.place(0,
                  {contact.ground().moving_body.after_travel(
                     travel_at_first_contact(contact.ground(), state) + 6),
                   contact.ground().laws()});
    contact.settle(state, loads);
    equations.assemble(state, loads);

    LA::Vector       product = mesh->owned_vector();
    const LA::Vector x       = some_displacement(*mesh, 1, 6);
    const LA::Vector y       = some_displacement(*mesh, 1, 7);
    equations.tangent().vmult(product, y);
    double skew = product * x;
    equations.tangent().vmult(product, x);
    skew = std::abs(skew - product * y) / (product.l2_norm() * y.l2_norm());

    check_true(name,
               (skew < 1e-12) == symmetric &&
                 equations.tangent_is_symmetric(loads) == symmetric);
  }
} // namespace


int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  const auto law        = ThicknessLaw::symmetric;
  const auto asymmetric = ThicknessLaw::asymmetric;
  const auto consistent = MortarMatrix::consistent;
  const auto lumped     = MortarMatrix::lumped;
  const auto dead       = PressureKind::dead;
  const auto follower   = PressureKind::follower;

  test("symmetric: no ground", law, consistent, dead, true, true, false);
  test(
    "not: consistent mortar matrix", law, consistent, dead, false, true, true);
  test("symmetric: lumped mortar matrix", law, lumped, dead, true, true, true);
  test("not: follower pressure and free edges",
       law,
       lumped,
       follower,
       false,
       true,
       false);
  for (const auto formulation : {Formulation::paper, Formulation::standard})
    test("symmetric: follower pressure and held edges",
         law,
         lumped,
         follower,
         true,
         true,
         true,
         true,
         formulation);
  test("symmetric: follower pressure of 0",
       law,
       lumped,
       follower,
       true,
       false,
       false);
  test("not: asymmetric law", asymmetric, lumped, dead, false, false, false);
}
