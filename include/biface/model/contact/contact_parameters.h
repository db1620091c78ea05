// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_model_contact_contact_parameters_h
#define biface_model_contact_contact_parameters_h

#include <biface/contact/contact_condition_parameters.h>
#include <biface/contact/friction_parameters.h>
#include <biface/contact/ground_parameters.h>
#include <biface/contact/tread.h>
#include <biface/laminate/resultants.h>

namespace Biface
{
  class EntryDeclarations;


  /** The parameters of the contact between the shell and the ground. */
  struct ContactParameters
  {
    GroundParameters           body;
    ContactConditionParameters condition;
    FrictionParameters         friction;
    TreadParameters            tread;
    /** The face of the shell that touches the body. */
    Resultants::Face face = Resultants::outer;

    void
    add_parameters(EntryDeclarations &prm);

    /** Throws InputError if a value is invalid. */
    void
    check() const;
  };
} // namespace Biface

#endif
