// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include <biface/contact/contact_laws.h>
#include <biface/contact/friction.h>
#include <biface/laminate/layup.h>
#include <biface/model/contact/contact_interaction.h>
#include <biface/model/contact/contact_pair.h>
#include <biface/model/forces/edge_moments.h>
#include <biface/model/state/load_rates.h>
#include <biface/stepping/buckling.h>
#include <biface/stepping/stage_run.h>
#include <biface/stepping/stiffness_of_motions.h>

namespace Biface
{
  using namespace dealii;

  namespace
  {
    using Motion = Stiffness::Motion;


    /** Whether loads change with the load factors: those of constant direction;
     * moments along edges count as if they did. On all ranks. */
    bool
    loads_change(const StageRun &run, LoadRates change)
    {
      if (std::all_of(change.factors.begin(),
                      change.factors.end(),
                      [](const double factor) { return factor == 0; }))
        return false;
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


    /** Whether friction may hold less than before. */
    bool
    friction_falls(const ContactLaws &before, const ContactLaws &now)
    {
      if (now.kind_of_friction() == FrictionKind::glued)
        return false;
      if (!before.has_friction() || !now.has_friction())
        return before.has_friction();
      const FrictionCoefficient &was = before.friction().get_coefficient();
      const FrictionCoefficient &is  = now.friction().get_coefficient();
      return was.get_text() != is.get_text() &&
             !(was.is_constant() && is.is_constant() &&
               was.value(0, 0) <= is.value(0, 0));
    }


    /** Why forces may change in all of a stage though nothing moves; empty if
     * they do not. */
    std::string
    doubt_in(const StageRun &run)
    {
      const Stage &stage = run.stage;
      if (stage.inertia)
        return "the shell has inertia";
      if (stage.transient_rolling)
        return "the wheel rolls on";
      if (stage.damping > 0)
        return "dashpots act";
      if (stage.duration > 0 && run.equations.mesh.get_layup().relaxes())
        return "stresses relax";
      if (run.before &&
          run.before->laws.penalty_stiffness != stage.laws.penalty_stiffness &&
          (run.before->contact || !run.before->bodies.empty()))
        return "the penalty stiffness of contact changes";
      return "";
    }


    /** Why forces may change from the start of a stage to the end of its first
     * step though nothing moves; empty if they do not.
     * @param now the reactions of what is there in the stage. */
    std::string
    doubt_at_start(const StageRun &run, const MovingReactions &now)
    {
      const auto &first = run.progress.first_reactions.of;
      for (const auto &[name, reaction] : now.of)
        if (first.count(name) == 0)
          return "'" + name + "' comes";
      if (!run.before)
        return "";
      for (const auto &[name, reaction] : first)
        if (now.of.count(name) == 0)
          return "'" + name + "' leaves";
      const Stage       &stage  = run.stage;
      const Stage       &before = *run.before;
      const ContactPair &ground = run.contact.ground();
      if (before.inertia || before.damping > 0)
        return "inertia or dashpots end";
      if (before.theory != stage.theory)
        return "the strain theory changes";
      if (before.contact && before.laws.glued && !stage.laws.glued)
        return "glue ends";
      const ContactLaws was = ground.laws(before.laws);
      const ContactLaws is  = ground.laws(stage.laws);
      if (before.contact && friction_falls(was, is))
        return "friction falls";
      // where the shell stands, nodes that stick keep their tractions
      if (run.rolls &&
          (friction_falls(is, was) ||
           before.laws.tangential_stiffness != stage.laws.tangential_stiffness))
        return "friction changes";
      return "";
    }


    /** The stiffness between two equilibria of the only thing that moves
     * between them, with its name; none if several do or the loads change.
     * @param certain whether forces change by the motion alone. */
    std::optional<std::pair<std::string, Stiffness>>
    stiffness(const StageRun        &run,
              const MovingReactions &from,
              const MovingReactions &to,
              const bool             certain)
    {
      const LoadLevel &a = from.level;
      const LoadLevel &b = to.level;
      // in axes that do not turn
      if ((run.stage.contact &&
           (a.wheel_turn != 0 || b.wheel_turn != 0 ||
            a.inclination_angle != 0 || b.inclination_angle != 0)) ||
          a.angular_velocity != b.angular_velocity ||
          a.ground_velocity != b.ground_velocity ||
          a.slip_angle != b.slip_angle ||
          // that of a sealed gas follows from the motion
          (a.pressure != b.pressure && !run.stage.sealed))
        return {};

      const ContactPair  &ground  = run.contact.ground();
      const Tensor<1, 3> &outward = ground.moving_body.at_rest().direction();
      std::vector<std::pair<std::string, Stiffness>> moved;
      const auto add = [&](const std::string  &name,
                           const Motion        motion,
                           const Tensor<1, 3> &direction,
                           const double        amount) {
        if (amount != 0)
          moved.push_back({name, {motion, direction, amount, {}, {}}});
      };
      for (const auto &[name, before] : from.of)
        {
          const auto found = to.of.find(name);
          if (found == to.of.end())
            continue;
          const bool         is_ground = (name == ground.name);
          const Tensor<1, 3> slide =
            (is_ground ? b.slide - a.slide
                       : found->second.displacement - before.displacement);
          const double distance = slide.norm();
          if (distance > 0)
            add(name, Motion::slide, slide / distance, distance);
          if (is_ground)
            {
              add(name, Motion::approach, -outward, b.travel - a.travel);
              add(name, Motion::turn, outward, b.turn - a.turn);
            }
          else
            add(name,
                Motion::turn,
                {},
                (found->second.rotation - before.rotation).norm());
        }
      const auto exerts_nothing = [&](const auto &item) {
        return from.of.at(item.first).force.norm() == 0 &&
               to.of.at(item.first).force.norm() == 0;
      };
      if (moved.size() > 1)
        moved.erase(std::remove_if(moved.begin(), moved.end(), exerts_nothing),
                    moved.end());
      if (moved.size() != 1 ||
          (moved[0].second.motion == Motion::turn &&
           moved[0].first != ground.name) ||
          loads_change(run, change_of(a, b)))
        return {};

      auto &[name, result]           = moved[0];
      const MovingReaction &reaction = to.of.at(name);
      const MovingReaction &before   = from.of.at(name);
      const LoadLevel      &start    = run.progress.first_reactions.level;
      // moments are given about the origin, which is no point of the footprint
      const Tensor<1, 3> center(run.progress.first_contact_point + start.slide -
                                start.travel * outward);
      const Tensor<1, 3> force = reaction.force - before.force;
      const double       over =
        (certain ? result.amount : std::numeric_limits<double>::quiet_NaN());
      result.force = force / over;
      result.moment =
        (reaction.moment - before.moment - cross_product_3d(center, force)) /
        over;
      return moved[0];
    }
  } // namespace


  std::map<std::string, StepStiffness>
  stiffness_of_motions(const StageRun &run, const MovingReactions &now)
  {
    std::map<std::string, StepStiffness> result;
    const MovingReactions               &first = run.progress.first_reactions;
    const auto                          &last  = run.progress.reactions;
    const std::string                    doubt = doubt_in(run);
    const std::string                    doubt_of_secant =
      (doubt.empty() ? doubt_at_start(run, now) : doubt);
    if (const auto secant = stiffness(run, first, now, doubt_of_secant.empty()))
      {
        StepStiffness &item = result[secant->first];
        item.level          = first.level;
        item.loaded         = first.of.at(secant->first);
        item.secant         = secant->second;
        item.doubt          = doubt_of_secant;
      }
    // in the first step of a stage it starts where the secant does
    if (const auto tangent =
          stiffness(run,
                    last ? *last : first,
                    now,
                    last ? doubt.empty() : doubt_of_secant.empty()))
      result[tangent->first].tangent = tangent->second;
    return result;
  }
} // namespace Biface
