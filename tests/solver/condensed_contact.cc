// SPDX-License-Identifier: LGPL-2.1-or-later

// Points in contact that the factors of a matrix do not contain: their unit
// forces are what the tangent with them has more, corrected solutions are those
// with them, and the ones that are chosen satisfy the contact conditions of the
// linearized shell, with both masses, at nodes and in cells.

#include <deal.II/base/timer.h>

#include <cmath>

#include <biface/laminate/layup.h>
#include <biface/model/contact/approach.h>
#include <biface/model/contact/contact_interaction.h>
#include <biface/model/contact/contact_pair.h>
#include <biface/model/contact/contact_parameters.h>
#include <biface/model/equations/force_terms.h>
#include <biface/model/state/loads.h>
#include <biface/model/state/placed_body.h>
#include <biface/solver/condensed_contact.h>
#include <biface/solver/linear/mumps_solver.h>

#include "../model/coarse_torus.h"
#include <cord_ply.h>
#include <tests.h>

using namespace dealii;
using namespace Biface;

namespace
{
  /** Factors in double precision also of a small matrix. */
  class ExactFactors : public MumpsSolver
  {
  public:
    explicit ExactFactors(TimerOutput &timer)
      : MumpsSolver(MPI_COMM_WORLD, timer, false)
    {}

    bool
    solve_by_factors(std::vector<LA::Vector>       &x,
                     const std::vector<LA::Vector> &b) override
    {
      for (unsigned int i = 0; i < b.size(); ++i)
        if (!solve(x[i], b[i], 0).success)
          return false;
      return true;
    }
  };


  double
  difference(const LA::Vector &x, const LA::Vector &exact)
  {
    LA::Vector error(x);
    error -= exact;
    return error.l2_norm() / exact.l2_norm();
  }


  void
  test(const std::string       &name,
       const ContactParameters &parameters,
       const double             roughness)
  {
    ConditionalOStream no_output(std::cout, false);
    TimerOutput timer(no_output, TimerOutput::never, TimerOutput::wall_times);
    const Layup layup(Layup::Parameters(), cord_ply());
    const auto  mesh = coarse_torus(layup);
    const ContactInteraction contact(*mesh, parameters);
    ShellEquations           equations(*mesh, make_force_terms(*mesh, contact));
    ExactFactors             solver(timer);

    State state = at(equations,
                     contact.unloaded_state(),
                     some_displacement(*mesh, roughness, 1));
    Loads loads;
    loads.place(0,
                {contact.ground().moving_body.after_travel(
                   travel_at_first_contact(contact.ground(), state) + 10),
                 contact.ground().laws()});
    contact.update_active_set(state, loads);
    const ActiveSet all = contact.active_points(state);

    // without half of the points, the same on all ranks
    const auto numbers = contact_points(contact);
    ActiveSet  base    = all;
    for (unsigned int i = 0; i < base.size(); ++i)
      base[i] = all[i] && numbers[i].second % 2 > 0;
    contact.set_active_points(state, base);
    equations.assemble(state, loads);
    const LA::Vector residual(equations.residual());

    CondensedContact condensed(equations, contact, solver);
    const auto       points = condensed.differences(all, base);
    const auto       units = contact_constraints(contact, state, loads, points);

    const LA::Vector probe = some_displacement(*mesh, 1, 5);
    LA::Vector       with(probe), x(probe), forces(probe);
    equations.tangent().vmult(with, probe);
    for (const ContactConstraint &unit : units)
      {
        double motion = 0;
        for (const auto &[entry, derivative] : unit.gradient)
          motion += derivative * probe.begin()[entry];
        with.add(unit.stiffness * Utilities::MPI::sum(motion, MPI_COMM_WORLD),
                 unit.forces);
      }

    solver.factorize(equations.tangent(), Symmetry::none);
    condensed.restart(state);
    const auto chosen = condensed.choose(state, loads, points, residual);
    solver.solve(x, with, 0);

    // an assembly with the points, and what adds them to the last one
    contact.set_active_points(state, all);
    ShellEquations other(*mesh, make_force_terms(*mesh, contact));
    other.assemble(state, loads);
    ActiveSet alone = all;
    for (unsigned int i = 0; i < alone.size(); ++i)
      alone[i] = all[i] && !base[i];
    contact.set_active_points(state, alone);
    equations.add_contact(state, loads);
    contact.set_active_points(state, all);
    other.tangent().vmult(forces, probe);
    const double tangent_with_points = difference(with, forces);
    equations.tangent().vmult(with, probe);
    const double added_tangent = difference(with, forces);
    const double added_residual =
      difference(equations.residual(), other.residual());
    const double added_scale =
      equations.relative_residual() / other.relative_residual() - 1;

    const auto correction = condensed.correction(state, loads);
    if (correction)
      (*correction)(x);
    const double corrected = difference(x, probe);

    // the contact conditions of the linearized shell
    ActiveSet touching = base;
    for (unsigned int i = 0; i < base.size(); ++i)
      touching[i] = base[i] || (chosen && (*chosen)[i]);
    contact.set_active_points(state, touching);
    other.assemble(state, loads);
    ExactFactors exact(timer);
    exact.factorize(other.tangent(), Symmetry::none);
    exact.solve(x, other.residual(), 0);
    unsigned int n_touching = 0, n_violated = 0;
    for (unsigned int i = 0; i < points.size(); ++i)
      {
        double motion = 0;
        for (const auto &[entry, derivative] : units[i].gradient)
          motion += derivative * x.begin()[entry];
        const double clearance =
          units[i].clearance - Utilities::MPI::sum(motion, MPI_COMM_WORLD);
        bool is_active = false;
        for (unsigned int n = 0; n < numbers.size(); ++n)
          is_active = is_active || (numbers[n] == points[i] && touching[n]);
        is_active = Utilities::MPI::logical_or(is_active, MPI_COMM_WORLD);
        if (is_active)
          ++n_touching;
        if (is_active != (clearance < 0))
          ++n_violated;
      }
    if (Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) != 0)
      return;
    std::cout << name << std::endl;
    check_true("  points are added", chosen && correction);
    check_small("  tangent by unit forces", tangent_with_points, 1e-12);
    check_small("  tangent that is added", added_tangent, 1e-12);
    check_small("  residual that is added", added_residual, 1e-12);
    check_small("  its scale", added_scale, 1e-12);
    check_small("  corrected solution", corrected, 1e-6);
    check_range("  points that touch", n_touching, 1, points.size() - 1);
    check_true("  contact conditions", n_violated == 0);
  }
} // namespace


int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  ContactParameters                parameters;
  parameters.body.line.direction     = Tensor<1, 3>({1, 0, 0});
  parameters.condition.mortar_matrix = MortarMatrix::lumped;
  test("lumped", parameters, 0.05);
  parameters.condition.mortar_matrix = MortarMatrix::consistent;
  test("consistent", parameters, 0.05);
  parameters.condition.points_per_side = 2;
  test("in cells", parameters, 0.1);
}
