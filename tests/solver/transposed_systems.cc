// SPDX-License-Identifier: LGPL-2.1-or-later

// All solvers solve the transposed of an unsymmetric system with the same
// factors or the same preconditioner: its residual is round-off.

#include <deal.II/base/conditional_ostream.h>
#include <deal.II/base/timer.h>

#include <iostream>
#include <string>

#include <biface/model/contact/contact_interaction.h>
#include <biface/model/contact/contact_pair.h>
#include <biface/model/equations/force_terms.h>
#include <biface/model/equations/symmetry.h>
#include <biface/model/forces/dead_loads.h>
#include <biface/model/forces/pressure_load.h>
#include <biface/model/state/loads.h>
#include <biface/solver/linear/multigrid_solver.h>
#include <biface/solver/linear/mumps_solver.h>

#include "laplacian.h"
#include <run_analysis.h>
#include <tests.h>

namespace
{
  void
  check(const std::string      &name,
        LinearSolver           &solver,
        const LA::SparseMatrix &A,
        const LA::Vector       &b,
        const double            tolerance)
  {
    const bool factorized = solver.factorize(A, Symmetry::none).success;
    for (const LinearSystem system : {LinearSystem::transposed,
                                      LinearSystem::original,
                                      LinearSystem::transposed})
      {
        const bool   as_it_is = (system == LinearSystem::original);
        LA::Vector   x(b), residual(b);
        const bool   solved = solver.solve_system(system, x, b, 1e-12).success;
        const double relative =
          SystemMatrix{A, system}.residual(residual, x, b) / b.l2_norm();
        if (Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
          check_small(name + (as_it_is ? "" : ", transposed") +
                        (factorized && solved ? "" : " failed"),
                      relative,
                      tolerance);
      }
  }
} // namespace


int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  ConditionalOStream               no_output(std::cout, false);
  TimerOutput timer(no_output, TimerOutput::never, TimerOutput::wall_times);

  {
    Laplacian system;
    system.set(0.1);
    // flow along the lines
    for (const auto i : system.rhs.locally_owned_elements())
      for (auto entry = system.matrix.begin(i); entry != system.matrix.end(i);
           ++entry)
        if (entry->column() == i + 1)
          entry->value() = 0.5;

    for (const bool single_precision : {true, false})
      {
        MumpsSolver mumps(MPI_COMM_WORLD, timer, single_precision);
        check(single_precision ? "MUMPS, single precision" : "MUMPS",
              mumps,
              system.matrix,
              system.rhs,
              1e-10);
      }
  }

  {
    // pressure that follows the free edges of a panel
    const Analysis           analysis(DATA_DIR "/panel_with_free_edges.prm",
                            {"Mesh/Intervals alpha_1=0:10:16",
                                       "Mesh/Intervals alpha_2=0:10:16",
                                       "Linear solver/Type=iterative"});
    const ShellMesh         &mesh = analysis.simulation.get_equations().mesh;
    const ContactInteraction contact(mesh, ContactParameters());
    PressureLoad             pressure;
    pressure.kind = PressureKind::follower;
    ShellEquations equations(
      mesh, make_force_terms(mesh, contact, DeadLoads(), pressure));
    Loads loads;
    loads.pressure = 10;
    equations.assemble(State(mesh), loads);

    LinearSolver::Parameters::Multigrid parameters;
    parameters.coarsest_unknowns = 500;
    MultigridSolver  multigrid(parameters, mesh, timer);
    MumpsSolver      mumps(MPI_COMM_WORLD, timer);
    const LA::Vector b = arbitrary_displacements(mesh, 1);
    LA::Vector       x(b), exact(b), of_original(b);
    multigrid.factorize(equations.tangent(), Symmetry::none);
    const bool solved = multigrid.solve_transposed(x, b, 1e-12).success;
    mumps.factorize(equations.tangent(), Symmetry::none);
    mumps.solve_transposed(exact, b, 0);
    mumps.solve(of_original, b, 0);
    x -= exact;
    of_original -= exact;
    const double size = exact.linfty_norm(), error = x.linfty_norm(),
                 difference = of_original.linfty_norm();
    if (Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
      {
        check_true("the panel is not symmetric", difference > 0.05 * size);
        check_small(std::string("multigrid, transposed") +
                      (solved ? "" : " failed"),
                    error,
                    1e-9,
                    size);
      }
  }
}
