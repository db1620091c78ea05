// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/mpi.h>

#include <biface/model/work.h>

namespace Biface
{
  using namespace dealii;

  namespace
  {
    /** The work of the forces of the foundation in one state, on nodes that
     * move with it by a given motion. */
    template <typename Motion>
    double
    foundation_work(const ShellEquations &equations,
                    const State          &state,
                    const Loads          &loads,
                    const Motion         &motion)
    {
      const ShellMesh &mesh = equations.mesh;
      const LA::Vector forces =
        equations.nodal_forces(ForceTerm::Source::foundation, state, loads);
      double work = 0;
      for (const Node &node : mesh.nodes)
        if (node.locally_owned)
          work += node.surface.from_frame(
                    mesh.force_on_face(forces, node, Resultants::outer)) *
                  motion(mesh.deformed_position(
                    state.displacement, node, Resultants::outer));
      return Utilities::MPI::sum(work, mesh.communicator);
    }
  } // namespace


  Work
  work_of_step(const ShellEquations     &equations,
               const ContactInteraction &contact,
               const State              &before,
               const Loads              &loads_before,
               const State              &after,
               const Loads              &loads_after)
  {
    const ShellMesh &mesh       = equations.mesh;
    const bool       prescribed = mesh.prescribes_displacements();
    LA::Vector       change     = owned_part(after.displacement);
    change -= owned_part(before.displacement);
    const auto work = [&](const ForceTerm::Source source) {
      return (equations.nodal_forces(source, before, loads_before) * change +
              equations.nodal_forces(source, after, loads_after) * change) /
             2;
    };

    Work result;
    // in equilibrium, the supports exert what is missing
    result.loads = (prescribed ? -work(ForceTerm::Source::shell) -
                                   work(ForceTerm::Source::foundation)
                               : work(ForceTerm::Source::loads));
    if (loads_after.foundation)
      {
        const RigidFoundation &start = *loads_before.foundation;
        const RigidFoundation &end   = *loads_after.foundation;
        result.foundation =
          (foundation_work(equations,
                           before,
                           loads_before,
                           [&](const Point<3> &x) {
                             return end.present(start.at_rest(x)) - x;
                           }) +
           foundation_work(equations,
                           after,
                           loads_after,
                           [&](const Point<3> &x) {
                             return x - start.present(end.at_rest(x));
                           })) /
          2;
        result.friction = contact.friction_work(before, after, loads_after);
      }
    return result;
  }
} // namespace Biface
