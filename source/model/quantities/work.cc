// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/mpi.h>

#include <biface/model/contact/contact_interaction.h>
#include <biface/model/contact/contact_pair.h>
#include <biface/model/contact/contact_summary.h>
#include <biface/model/forces/nodal_forces.h>
#include <biface/model/quantities/work.h>
#include <biface/model/state/loads.h>
#include <biface/model/state/placed_body.h>

namespace Biface
{
  using namespace dealii;

  namespace
  {
    /** The work of the tractions of a body in one state, on nodes that move
     * with it by a given motion. */
    template <typename Motion>
    double
    work_of_body(const ContactPair &pair,
                 const LoadedState &at,
                 const Motion      &motion)
    {
      const ShellMesh     &mesh   = pair.mesh;
      const ContactPoints &points = pair.points;
      const ContactState  &zone   = pair.state_of(at.state);
      double               work   = 0;
      for (const Cell &cell : mesh.wall_elements())
        for (unsigned int i = 0; i < points.on_cell().size(); ++i)
          {
            const unsigned int point = points.number(cell, i);
            if (!zone.active[point])
              continue;
            const Tensor<1, 3> traction =
              pair.traction_of_multipliers(at.state, at.loads, point).total;
            const std::array<double, 4> areas = points.areas(cell, i);
            for (unsigned int r = 0; r < 4; ++r)
              work += areas[r] * (traction * motion(mesh.deformed_position(
                                               at.state.displacement,
                                               mesh.nodes[cell.nodes[r]],
                                               pair.face)));
          }
      return Utilities::MPI::sum(work, mesh.communicator);
    }
  } // namespace


  Work
  work_of_step(const ContactInteraction &contact,
               const LoadedState        &before,
               const LoadedState        &after)
  {
    const ShellMesh &mesh       = contact.mesh;
    const bool       prescribed = mesh.prescribes_displacements();
    LA::Vector       change     = owned_part(after.state.displacement);
    change -= owned_part(before.state.displacement);
    const auto work = [&](const ForceTerm::Source source) {
      // mean forces of the step, the trapezoidal rule
      double sum =
        before.forces[source] * change + after.forces[source] * change;
      if (source == ForceTerm::Source::ground)
        for (const NodalForces *forces : {&before.forces, &after.forces})
          for (const auto &[name, of_body] : forces->of_bodies)
            sum += of_body * change;
      return sum / 2;
    };

    Work result;
    result.damping = -work(ForceTerm::Source::damping);
    // in equilibrium, the supports exert what is missing
    result.loads =
      (prescribed ? result.damping - work(ForceTerm::Source::shell) -
                      work(ForceTerm::Source::ground)
                  : work(ForceTerm::Source::loads));
    for (const ContactPair *pair : contact.present(after.loads))
      {
        const RigidBody &start = pair->body(before.loads)->body;
        const RigidBody &end   = pair->body(after.loads)->body;
        // the motion of a body at each end is that of the point which is in
        // contact there
        result.ground +=
          (work_of_body(*pair,
                        before,
                        [&](const Point<3> &x) {
                          return end.present(start.at_rest(x)) - x;
                        }) +
           work_of_body(*pair,
                        after,
                        [&](const Point<3> &x) {
                          return x - start.present(end.at_rest(x));
                        })) /
          2;
        result.friction +=
          friction_work(*pair, before.state, after.state, after.loads);
      }
    return result;
  }
} // namespace Biface
