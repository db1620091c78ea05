// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_model_equations_force_terms_h
#define biface_model_equations_force_terms_h


#include <biface/model/forces/dead_loads.h>
#include <biface/model/forces/force_term.h>
#include <biface/model/forces/pressure_load.h>

namespace Biface
{
  class ContactInteraction;

  /** The forces on the shell except its internal forces; a new kind of force is
   * one more line here. The mesh and the contact are kept by reference. Throws
   * InputError if the loads are invalid. */
  ForceTerms
  make_force_terms(const ShellMesh          &mesh,
                   const ContactInteraction &contact,
                   const DeadLoads          &dead_loads = DeadLoads(),
                   const PressureLoad       &pressure   = PressureLoad());
} // namespace Biface

#endif
