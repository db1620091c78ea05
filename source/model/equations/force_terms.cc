// SPDX-License-Identifier: LGPL-2.1-or-later

#include <biface/model/contact/contact_forces.h>
#include <biface/model/contact/contact_interaction.h>
#include <biface/model/equations/force_terms.h>
#include <biface/model/forces/edge_moments.h>
#include <biface/model/forces/end_plates.h>
#include <biface/model/forces/inertia_of_wheel.h>
#include <biface/model/forces/joints.h>
#include <biface/model/forces/pressure_at_folds.h>
#include <biface/model/forces/pressure_on_directors.h>

namespace Biface
{
  ForceTerms
  make_force_terms(const ShellMesh          &mesh,
                   const ContactInteraction &contact,
                   const DeadLoads          &dead_loads,
                   const PressureLoad       &pressure)
  {
    ForceTerms terms;
    terms.push_back(std::make_unique<DeadForces>(mesh, dead_loads));
    terms.push_back(std::make_unique<PressureForces>(mesh, pressure));
    if (pressure.kind == PressureKind::follower &&
        mesh.formulation != Formulation::paper)
      terms.push_back(std::make_unique<PressureOnDirectors>(mesh, pressure));
    if (mesh.n_folds() > 0)
      {
        terms.push_back(std::make_unique<Joints>(mesh));
        terms.push_back(std::make_unique<PressureAtFolds>(mesh, pressure));
      }
    if (!pressure.end_plates.empty())
      terms.push_back(std::make_unique<EndPlates>(mesh, pressure));
    terms.push_back(
      std::make_unique<FollowerMoments>(mesh, dead_loads.edge_moments));
    terms.push_back(std::make_unique<InertiaOfWheel>(mesh));
    for (const auto &pair : contact.pairs)
      terms.push_back(std::make_unique<ContactForces>(*pair));
    return terms;
  }
} // namespace Biface
