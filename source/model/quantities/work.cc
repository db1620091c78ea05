// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/mpi.h>

#include <biface/model/quantities/work.h>

namespace Biface
{
  using namespace dealii;

  namespace
  {
    /** The work of the forces of the foundation in one state, on nodes that
     * move with it by a given motion. */
    template <typename Motion>
    double
    foundation_work(const ShellMesh   &mesh,
                    const LoadedState &at,
                    const Motion      &motion)
    {
      const LA::Vector &forces = at.forces[ForceTerm::Source::foundation];
      double            work   = 0;
      for (const Node &node : mesh.nodes)
        if (node.locally_owned)
          work += node.surface.from_frame(
                    mesh.force_on_face(forces, node, Resultants::outer)) *
                  motion(mesh.deformed_position(
                    at.state.displacement, node, Resultants::outer));
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
      return (before.forces[source] * change + after.forces[source] * change) /
             2;
    };

    Work result;
    // in equilibrium, the supports exert what is missing
    result.loads = (prescribed ? -work(ForceTerm::Source::shell) -
                                   work(ForceTerm::Source::foundation)
                               : work(ForceTerm::Source::loads));
    if (after.loads.foundation)
      {
        const RigidFoundation &start = *before.loads.foundation;
        const RigidFoundation &end   = *after.loads.foundation;
        result.foundation =
          (foundation_work(mesh,
                           before,
                           [&](const Point<3> &x) {
                             return end.present(start.at_rest(x)) - x;
                           }) +
           foundation_work(mesh,
                           after,
                           [&](const Point<3> &x) {
                             return x - start.present(end.at_rest(x));
                           })) /
          2;
        result.friction =
          contact.friction_work(before.state, after.state, after.loads);
      }
    return result;
  }
} // namespace Biface
