// SPDX-License-Identifier: LGPL-2.1-or-later

// The derivative of the residual with respect to the loads, at rates of the
// pressure, of the load factor and of the ground's travel, is that of its
// differences, with dead and with follower loads; and likewise at the rate of a
// motion that turns a body, without and with friction. So are the derivatives
// of the power of the body in this motion.

#include <biface/contact/body_parameters.h>
#include <biface/laminate/layup.h>
#include <biface/model/contact/approach.h>
#include <biface/model/contact/contact_interaction.h>
#include <biface/model/contact/contact_pair.h>
#include <biface/model/contact/contact_parameters.h>
#include <biface/model/equations/force_terms.h>
#include <biface/model/equations/shell_equations.h>
#include <biface/model/forces/dead_loads.h>
#include <biface/model/forces/pressure_load.h>
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
  test(const std::string &name, const PressureKind kind)
  {
    const Layup layup(Layup::Parameters(), cord_ply());
    const auto  mesh = coarse_torus(layup);

    ContactParameters parameters;
    parameters.condition.penalty_stiffness = 1;
    parameters.body.shape  = RigidBody::Parameters::Shape::sphere;
    parameters.body.sphere = {120};
    const ContactInteraction contact(*mesh, parameters);

    PressureLoad pressure;
    pressure.kind = kind;
    pressure.distribution =
      parse_position_formula("distribution", "1 + 0.3*sin(alpha_1/20)");
    DeadLoads dead_loads;
    dead_loads.edge_moments = parse_edge_moments(
      "moments", "alpha_2 max: 3 follower, alpha_2 min: -2 dead");
    dead_loads.area_force = Tensor<1, 3>({0.01, 0.02, -0.03});
    ShellEquations equations(
      *mesh, make_force_terms(*mesh, contact, dead_loads, pressure));

    State state = at(equations, State(*mesh), some_displacement(*mesh, 0.2, 1));
    Loads loads;
    loads.pressure = 0.1;
    loads.factors  = {0.7};
    loads.place(0,
                {contact.ground().moving_body.after_travel(
                   travel_at_first_contact(contact.ground(), state) + 6),
                 contact.ground().laws()});
    contact.settle(state, loads);

    const bool is_root = Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0;
    if (is_root)
      std::cout << name << std::endl;
    const std::pair<const char *, LoadRates> cases[] = {
      {"  pressure", {0.3, {0}, 0}},
      {"  load factor", {0, {2}, 0}},
      {"  travel", {0, {0}, 1}},
      {"  all of them", {-0.2, {1}, 0.5}}};
    for (const auto &[what, rates] : cases)
      {
        LA::Vector   deviation = equations.load_direction(state, loads, rates);
        const double scale     = deviation.l2_norm();
        const double step      = 1e-4;
        for (const double sign : {-1., 1.})
          {
            Loads moved = loads;
            moved.pressure += sign * step * rates.pressure;
            moved.factors[0] += sign * step * rates.factors[0];
            moved.place(0,
                        {loads.ground()->moved(sign * step * rates.travel),
                         contact.ground().laws()});
            equations.assemble(state, moved);
            deviation.add(-sign / (2 * step), equations.residual());
          }
        const double error = deviation.l2_norm();
        if (is_root)
          check_small(what, error, 1e-7, scale);
      }
  }


  void
  test_turning_body(const BodyParameters::Shape shape,
                    const std::string          &friction)
  {
    const Layup layup(Layup::Parameters(), cord_ply());
    const auto  mesh = coarse_torus(layup);

    ContactParameters ground;
    ground.condition.penalty_stiffness   = 1;
    ground.friction.tangential_stiffness = 0.5;
    BodyParameters bar;
    bar.name   = "bar";
    bar.shape  = shape;
    bar.radius = 120;
    // a plane turns about a point of it
    bar.point =
      Point<3>(shape == BodyParameters::Shape::sphere ? 360 : 240, 5, -8);
    bar.axis     = Tensor<1, 3>({0.3, 1, -0.5});
    bar.friction = FrictionCoefficient("Friction", friction);
    BodyMotion motion;
    motion.name        = "screw";
    motion.translation = Tensor<1, 3>({-3, 1, 2});
    motion.turn        = 0.2;
    BodyMotion camber;
    camber.name   = "camber";
    camber.turn   = -0.1;
    camber.axis   = Tensor<1, 3>({1, 0.2, 2});
    camber.factor = 1;
    bar.motions   = {motion, camber};
    const ContactInteraction contact(*mesh, ground, {bar});
    const ContactPair       &pair = *contact.pairs[1];
    ShellEquations           equations(*mesh, make_force_terms(*mesh, contact));
    const auto               loads_at = [&](const double factor) {
      Loads loads;
      loads.factors = {factor, 0.5 * factor};
      loads.place(1,
                  {pair.moving_body.after_motions(
                     loads.factors, [](const RigidBody &body) { return body; }),
                   pair.laws()});
      return loads;
    };

    State state =
      at(equations, contact.unloaded_state(), some_displacement(*mesh, 0.2, 1));
    // nodes stick to the body, and slip where the pressure is small
    contact.settle(state, loads_at(0.2));
    equations.commit_step(state, loads_at(0.2), {0, 1}, state);
    contact.settle(state, loads_at(0.7));
    const unsigned int n_active = contact.count_active(state);

    LA::Vector deviation =
      equations.load_direction(state, loads_at(0.7), {0, {1, 0.5}, 0});
    const double scale = deviation.l2_norm(), step = 1e-4;
    for (const double sign : {-1., 1.})
      {
        equations.assemble(state, loads_at(0.7 + sign * step));
        deviation.add(-sign / (2 * step), equations.residual());
      }
    const double error = deviation.l2_norm();

    const LoadRates           rates{0, {1, 0}, 0}, moves{0, {1, 0.5}, 0};
    const LinearizedResultant power =
      power_of_body(pair, state, loads_at(0.7), rates, {moves});
    double     by_motion = -power.per_load[0], by_displacement = 0;
    LA::Vector direction = some_displacement(*mesh, 1, 3);
    by_displacement      = -(power.gradient * direction);
    for (const double sign : {-1., 1.})
      {
        const double part = sign / (2 * step);
        by_motion +=
          part *
          power_of_body(pair, state, loads_at(0.7 + sign * step), rates).value;
        LA::Vector V = some_displacement(*mesh, 0.2, 1);
        V.add(sign * step, direction);
        by_displacement +=
          part *
          power_of_body(pair, at(equations, state, V), loads_at(0.7), rates)
            .value;
      }
    const double scale_of_displacement = power.gradient.l2_norm();
    if (Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) != 0)
      return;
    check_true("nodes touch the turning body", n_active > 3);
    check_small("its motion", error, 1e-6, scale);
    check_small("its power by its motion", by_motion, 1e-6, power.per_load[0]);
    check_small("its power by displacements",
                by_displacement,
                1e-6,
                scale_of_displacement);
  }
} // namespace


int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  test("dead pressure", PressureKind::dead);
  test("follower pressure", PressureKind::follower);
  using Shape = BodyParameters::Shape;
  for (const Shape shape : {Shape::sphere, Shape::plane})
    for (const std::string friction : {"0", "0.3"})
      test_turning_body(shape, friction);
}
