// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/mpi.h>

#include <optional>
#include <utility>

#include <biface/model/forces/edge_moments.h>
#include <biface/model/quantities/forces_on_shell.h>
#include <biface/model/state/load_rates.h>
#include <biface/model/state/loads.h>
#include <biface/stepping/buckling.h>
#include <biface/stepping/stage_run.h>
#include <biface/stepping/stiffness_of_motions.h>

namespace Biface
{
  using namespace dealii;

  namespace
  {
    constexpr const char *ground_name = "foundation";


    /** Whether loads change with the load factors: those of constant direction;
     * moments along edges count as if they did. On all ranks. */
    bool
    loads_change(const StageRun &run, LoadRates change)
    {
      // that of a sealed gas follows from the motion
      change.pressure          = 0;
      const ShellMesh &mesh    = run.equations.mesh;
      LA::Vector       forces  = mesh.owned_vector();
      bool             moments = false;
      for (const ForceTerm *term : run.equations.get_terms())
        if (term->source() == ForceTerm::Source::loads)
          {
            term->add_dead_forces(change, forces);
            if (dynamic_cast<const FollowerMoments *>(term) != nullptr)
              moments = moments || !term->elements().empty();
          }
      return Utilities::MPI::logical_or(moments, mesh.communicator) ||
             forces.linfty_norm() > 0;
    }


    /** The stiffness between two equilibria of the only thing that moves
     * between them; none if several do or the loads change. */
    std::optional<std::pair<std::string, double>>
    stiffness(const StageRun        &run,
              const MovingReactions &from,
              const MovingReactions &to)
    {
      // in axes that do not turn
      const auto turned = [](const LoadLevel &level) {
        return level.wheel_turn != 0 || level.inclination_angle != 0 ||
               level.rolls();
      };
      const bool has_ground = to.of.count(ground_name) > 0;
      if ((has_ground && (turned(from.level) || turned(to.level))) ||
          from.level.angular_velocity != to.level.angular_velocity ||
          from.level.time != to.level.time ||
          // a body that has left
          from.of.size() != to.of.size() ||
          // that of a sealed gas follows from the motion
          (from.level.pressure != to.level.pressure && !run.stage.sealed))
        return {};

      std::optional<std::pair<std::string, double>> result;
      for (const auto &[name, now] : to.of)
        {
          const auto found = from.of.find(name);
          // a body that has just come
          if (found == from.of.end())
            return {};
          const MovingReaction &before = found->second;
          const Tensor<1, 3>    moved  = now.displacement - before.displacement;
          const bool rotated = (now.rotation - before.rotation).norm() > 0;
          if (moved.norm() == 0 && !rotated)
            continue;
          if (result || rotated)
            return {};
          result.emplace(
            name, (now.force - before.force) * moved / moved.norm_square());
        }
      if (!result || loads_change(run, change_of(from.level, to.level)))
        return {};
      return result;
    }
  } // namespace


  std::map<std::string, StiffnessOfMotion>
  stiffness_of_motions(const StageRun &run, const MovingReactions &now)
  {
    std::map<std::string, StiffnessOfMotion> result;
    const Progress                          &progress = run.progress;
    // dashpots, inertia and relaxation add forces of their own
    if (run.stage.inertia || run.stage.damping > 0 || run.stage.duration > 0 ||
        run.changes_penalty_stiffness())
      return result;
    if (progress.first_reactions)
      if (const auto secant = stiffness(run, *progress.first_reactions, now))
        result[secant->first].secant = secant->second;
    if (progress.reactions)
      if (const auto tangent = stiffness(run, *progress.reactions, now))
        result[tangent->first].tangent = tangent->second;
    return result;
  }
} // namespace Biface
