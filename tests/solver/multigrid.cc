// SPDX-License-Identifier: LGPL-2.1-or-later

// GMRES with multigrid inflates the tire on meshes of any fineness in the same
// few iterations, although its cells far from the ground are many times
// longer than wide.

#include <deal.II/base/mpi.h>

#include <biface/model/contact/contact_interaction.h>
#include <biface/model/contact/contact_pair.h>
#include <biface/model/equations/force_terms.h>
#include <biface/model/forces/dead_loads.h>
#include <biface/model/forces/pressure_load.h>
#include <biface/model/state/loads.h>
#include <biface/solver/linear/make_linear_solver.h>
#include <biface/solver/linear/multigrid_solver.h>

#include <name_of.h>
#include <run_analysis.h>
#include <tests.h>

using namespace dealii;
using namespace Biface;

namespace
{
  void
  test(const Formulation formulation, const unsigned int refinement)
  {
    const auto n = [&](const unsigned int coarse) {
      return std::to_string(coarse * refinement);
    };
    const Analysis           analysis(PRM_DIR "/bias_tire.prm",
                            {"Mesh/Intervals alpha_1=-120:-45:" + n(6) +
                                         ", -45:45:" + n(9) + ", 45:120:" + n(6),
                                       "Mesh/Intervals alpha_2=-180:-15:" + n(5) +
                                         ":smooth, -15:15:" + n(10) + ", 15:180:" + n(5) +
                                         ":smooth",
                                       "Formulation=" + name_of(formulation),
                                       "Linear solver/Type=iterative"});
    const ShellMesh         &mesh = analysis.simulation.get_equations().mesh;
    const ContactInteraction contact(mesh, ContactParameters());
    PressureLoad             pressure;
    pressure.kind = PressureKind::dead;
    ShellEquations equations(
      mesh, make_force_terms(mesh, contact, DeadLoads(), pressure));

    Loads loads;
    loads.pressure = 0.15;
    equations.assemble(State(mesh), loads);

    ConditionalOStream no_output(std::cout, false);
    TimerOutput timer(no_output, TimerOutput::never, TimerOutput::wall_times);
    LinearSolver::Parameters::Multigrid multigrid;
    multigrid.coarsest_unknowns = 1000;
    multigrid.max_iterations    = 25;
    MultigridSolver solver(multigrid, mesh, timer);

    LA::Vector x = mesh.owned_vector();
    const bool ok =
      solver.factorize(equations.tangent(), Symmetry::full).success &&
      solver.solve(x, equations.residual(), 1e-6).success;

    const auto direct =
      make_linear_solver(LinearSolver::Parameters(), mesh, timer);
    LA::Vector exact = mesh.owned_vector();
    direct->factorize(equations.tangent(), Symmetry::full);
    direct->solve(exact, equations.residual(), 0);
    x -= exact;
    const double error = x.linfty_norm(), size = exact.linfty_norm();
    if (Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
      {
        check_true(name_of(formulation) + ", " +
                     std::to_string(mesh.n_unknowns()) +
                     " unknowns: solved in 25 iterations",
                   ok);
        check_small("  error", error, 1e-4, size);
      }
  }
} // namespace


int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  for (const unsigned int refinement : {1, 2, 4})
    test(Formulation::paper, refinement);
  // not on the coarsest mesh, whose cells turn by tens of degrees: 1.3e-4 there
  for (const unsigned int refinement : {2, 4})
    test(Formulation::standard, refinement);
}
