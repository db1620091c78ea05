// SPDX-License-Identifier: LGPL-2.1-or-later

// A checkpoint gives back the whole state: displacements, velocities,
// resultants, the active set and all components of the multipliers, at all
// nodes of each rank, and what earlier stages have left in the internal forces;
// also those at the end of an earlier stage from which others start, and those
// of neighbors.

#include <filesystem>

#include <biface/laminate/layup.h>
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

  const Layup           layup(Layup::Parameters(), cord_ply());
  const auto            mesh = coarse_torus(layup);
  ShellEquations        equations(*mesh);
  const InternalForces &internal = equations.internal_forces();

  State state = at(equations, State(*mesh), some_displacement(*mesh, 0.2, 1));
  internal.take_as_prestress(state);
  internal.balance(some_displacement(*mesh, 1, 4), state);
  state = at(equations, state, some_displacement(*mesh, 0.2, 2));
  InternalForces::set_theory(StrainTheory::linear, state);
  state = at(equations, state, some_displacement(*mesh, 0.3, 3));
  for (unsigned int n = 0; n < mesh->nodes.size(); ++n)
    {
      const Point<2> &alpha       = mesh->nodes[n].alpha;
      state.contacts[0].active[n] = alpha[0] > 0.1;
      for (unsigned int i = 0; i < 3; ++i)
        state.contacts[0].multipliers[n][i] =
          std::sin(3 * alpha[0] + 7 * alpha[1] + i);
    }
  state.velocity            = mesh->ghosted_vector();
  const LA::Vector velocity = some_displacement(*mesh, 2, 6);
  state.velocity            = velocity;

  state.terms["term"] = {
    {1, 2}, {mesh->nodes.size(), 2}, {mesh->cells.size(), 3}};
  for (unsigned int n = 0; n < mesh->nodes.size(); ++n)
    for (unsigned int i = 0; i < 2; ++i)
      state.terms["term"].at_nodes[n][i] = mesh->nodes[n].number + i / 2.;
  for (unsigned int c = 0; c < mesh->cells.size(); ++c)
    for (unsigned int i = 0; i < 3; ++i)
      state.terms["term"].at_cells[c][i] = mesh->cells[c].number + i / 3.;

  const std::string directory = "checkpoint";
  if (Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
    std::filesystem::create_directories(directory);
  MPI_Barrier(MPI_COMM_WORLD);
  RunRecord record;
  Progress  end_progress;
  end_progress.n_steps = 7;
  const State end =
    at(equations, State(*mesh), some_displacement(*mesh, 0.1, 5));
  const RestorePoint at_end{end, end_progress};
  write_checkpoint(directory,
                   record,
                   *mesh,
                   {{state, Progress()}, {{1, at_end}}},
                   {{{at_end, {}}, {at_end, {{1, at_end}}}}, {3}});

  const Checkpoint      checkpoint(directory, MPI_COMM_WORLD);
  const RestorePoints   points    = checkpoint.run(*mesh);
  const PerturbedPoints read      = checkpoint.perturbed(*mesh);
  const auto           &neighbors = read.runs;
  const State          &other     = points.last.state;
  const StageEnds      &ends      = points.ends;

  bool same = true;
  for (const auto dof : mesh->locally_relevant)
    same = same && other.displacement(dof) == state.displacement(dof) &&
           other.velocity(dof) == state.velocity(dof);
  bool same_end = ends.size() == 1 && ends.count(1) == 1;
  for (const auto dof : mesh->locally_relevant)
    same_end =
      same_end && ends.at(1).state.displacement(dof) == end.displacement(dof);
  const auto all = [](const bool on_this_rank) {
    return Utilities::MPI::min(static_cast<int>(on_this_rank),
                               MPI_COMM_WORLD) == 1;
  };
  const Prestress &before     = *state.prestress;
  const Prestress &after      = *other.prestress;
  LA::Vector       difference = before.balancing_forces;
  difference -= after.balancing_forces;
  const TermState &term      = state.terms.at("term"),
                  &same_term = other.terms.at("term");
  const bool found[]         = {
            all(same),
            all(other.resultants == state.resultants),
            all(other.contacts[0].active == state.contacts[0].active),
            all(other.contacts[0].multipliers == state.contacts[0].multipliers),
            all(after.resultants == before.resultants &&
        after.strains == before.strains),
            all(other.linearization_point && other.linearization_point->resultants ==
                                       state.linearization_point->resultants),
            difference.l2_norm() == 0 && after.balancing_forces.l2_norm() > 0,
            all(same_end && ends.at(1).state.resultants == end.resultants &&
        !ends.at(1).state.prestress && !ends.at(1).state.linearization_point &&
        ends.at(1).progress.n_steps == 7),
            all(neighbors.size() == 2 && neighbors[0].ends.empty() &&
        neighbors[1].last.state.resultants == end.resultants &&
        neighbors[1].ends.at(1).state.resultants == end.resultants &&
        neighbors[1].last.progress.n_steps == 7 &&
        read.lost_stages == std::set<unsigned int>{3}),
            all(term.numbers == same_term.numbers &&
        term.at_nodes == same_term.at_nodes &&
        term.at_cells == same_term.at_cells)};
  if (Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) != 0)
    return 0;
  check_true("displacements and velocities", found[0]);
  check_true("resultants", found[1]);
  check_true("active set", found[2]);
  check_true("multipliers", found[3]);
  check_true("prestress", found[4]);
  check_true("linearization point", found[5]);
  check_true("balancing forces", found[6]);
  check_true("end of an earlier stage", found[7]);
  check_true("neighbors", found[8]);
  check_true("what a force term remembers", found[9]);
}
