// SPDX-License-Identifier: LGPL-2.1-or-later

// A checkpoint gives back the whole state: displacements, resultants, the
// active set and all components of the multipliers, at all nodes of each rank,
// and what earlier stages have left in the internal forces; also those at the
// end of an earlier stage from which others start, and those of neighbors.

#include <filesystem>

#include <biface/restart/checkpoint.h>

#include "../model/coarse_torus.h"
#include <cord_ply.h>
#include <tests.h>

using namespace dealii;
using namespace Biface;

int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  const Layup     layup(Layup::Parameters(), cord_ply());
  const auto      mesh = coarse_torus(layup);
  ShellEquations  equations(*mesh);
  InternalForces &internal = equations.internal_forces();

  const InternalForces::History initial_history = internal.get_history();
  State state = at(equations, State(*mesh), some_displacement(*mesh, 0.2, 1));
  internal.take_as_prestress(state);
  internal.balance(some_displacement(*mesh, 1, 4));
  state = at(equations, state, some_displacement(*mesh, 0.2, 2));
  internal.set_theory(StrainTheory::linear, state);
  state = at(equations, state, some_displacement(*mesh, 0.3, 3));
  for (unsigned int n = 0; n < mesh->nodes.size(); ++n)
    {
      const Point<2> &alpha = mesh->nodes[n].alpha;
      state.active[n]       = alpha[0] > 0.1;
      for (unsigned int i = 0; i < 3; ++i)
        state.multipliers[n][i] = std::sin(3 * alpha[0] + 7 * alpha[1] + i);
    }

  const std::string directory = "checkpoint";
  if (Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
    std::filesystem::create_directories(directory);
  MPI_Barrier(MPI_COMM_WORLD);
  RunRecord record;
  Progress  end_progress;
  end_progress.n_steps = 7;
  const State end =
    at(equations, State(*mesh), some_displacement(*mesh, 0.1, 5));
  const RestorePoint at_end{end, initial_history, end_progress};
  write_checkpoint(directory,
                   record,
                   *mesh,
                   {{state, internal.get_history(), Progress()}, {{1, at_end}}},
                   {{{at_end, {}}, {at_end, {{1, at_end}}}}, {3}});

  const Checkpoint     checkpoint(directory, MPI_COMM_WORLD);
  const RestorePoints  points    = checkpoint.run(*mesh);
  const NeighborPoints read      = checkpoint.neighbors(*mesh);
  const auto          &neighbors = read.runs;
  const State         &other     = points.last.state;
  const StageEnds     &ends      = points.ends;

  bool same = true;
  for (const auto dof : mesh->locally_relevant)
    same = same && other.displacement(dof) == state.displacement(dof);
  bool same_end = ends.size() == 1 && ends.count(1) == 1;
  for (const auto dof : mesh->locally_relevant)
    same_end =
      same_end && ends.at(1).state.displacement(dof) == end.displacement(dof);
  const auto all = [](const bool on_this_rank) {
    return Utilities::MPI::min(static_cast<int>(on_this_rank),
                               MPI_COMM_WORLD) == 1;
  };
  const InternalForces::History &before     = internal.get_history();
  const InternalForces::History &after      = points.last.history;
  LA::Vector                     difference = before.balancing_forces;
  difference -= after.balancing_forces;
  const bool found[] = {
    all(same),
    all(other.resultants == state.resultants),
    all(other.active == state.active),
    all(other.multipliers == state.multipliers),
    all(after.initial_resultants == before.initial_resultants &&
        after.initial_strains == before.initial_strains),
    all(after.linearization_point.has_value() &&
        after.linearization_point->resultants ==
          before.linearization_point->resultants),
    difference.l2_norm() == 0 && after.balancing_forces.l2_norm() > 0,
    all(same_end && ends.at(1).state.resultants == end.resultants &&
        ends.at(1).history.initial_resultants ==
          initial_history.initial_resultants &&
        !ends.at(1).history.linearization_point &&
        ends.at(1).history.balancing_forces.size() == 0 &&
        ends.at(1).progress.n_steps == 7),
    all(neighbors.size() == 2 && neighbors[0].ends.empty() &&
        neighbors[1].last.state.resultants == end.resultants &&
        neighbors[1].ends.at(1).state.resultants == end.resultants &&
        neighbors[1].last.progress.n_steps == 7 &&
        read.lost_stages == std::set<unsigned int>{3})};
  if (Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) != 0)
    return 0;
  check_true("displacements", found[0]);
  check_true("resultants", found[1]);
  check_true("active set", found[2]);
  check_true("multipliers", found[3]);
  check_true("prestress", found[4]);
  check_true("linearization point", found[5]);
  check_true("balancing forces", found[6]);
  check_true("end of an earlier stage", found[7]);
  check_true("neighbors", found[8]);
}
