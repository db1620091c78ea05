// SPDX-License-Identifier: LGPL-2.1-or-later

// Multigrid reports a singular matrix as a failed set-up, with a message, also
// where the matrices of the coarser meshes are kept.

#include <deal.II/base/mpi.h>

#include <biface/model/contact/contact_interaction.h>
#include <biface/model/contact/contact_pair.h>
#include <biface/model/equations/force_terms.h>
#include <biface/model/state/loads.h>
#include <biface/solver/linear/multigrid_solver.h>

#include <run_analysis.h>
#include <tests.h>

using namespace dealii;
using namespace Biface;

int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  const Analysis           analysis(PRM_DIR "/bias_tire.prm");
  const ShellMesh         &mesh = analysis.simulation.get_equations().mesh;
  const ContactInteraction contact(mesh, ContactParameters());
  ShellEquations           equations(mesh, make_force_terms(mesh, contact));
  equations.assemble(State(mesh), Loads());

  ConditionalOStream no_output(std::cout, false);
  TimerOutput timer(no_output, TimerOutput::never, TimerOutput::wall_times);
  LinearSolver::Parameters::Multigrid multigrid;
  multigrid.coarsest_unknowns = 1000;
  MultigridSolver solver(multigrid, mesh, timer);

  LA::SparseMatrix singular;
  singular.copy_from(equations.tangent());
  singular = 0;

  const bool root = Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0;
  const bool regular =
    solver.factorize(equations.tangent(), Symmetry::full).success;
  if (root)
    check_true("the tangent is regular", regular);
  for (const bool similar : {true, false})
    {
      const LinearSolverResult result =
        (similar ? solver.keep_factors(singular, Symmetry::full)
                 : solver.factorize(singular, Symmetry::full));
      if (root)
        check_true(similar ? "failure with kept coarse matrices is reported"
                           : "failure with new coarse matrices is reported",
                   !result.success && !result.message.empty());
    }
}
