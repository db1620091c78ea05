// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_model_contact_contact_parameters_h
#define biface_model_contact_contact_parameters_h

#include <biface/contact/contact_condition.h>
#include <biface/contact/friction.h>
#include <biface/contact/rigid_body.h>
#include <biface/contact/tread.h>
#include <biface/laminate/resultants.h>

namespace Biface
{
  class EntryDeclarations;


  /** The parameters of the contact between the shell and the ground. */
  struct ContactParameters
  {
    RigidBody::Parameters        body;
    ContactCondition::Parameters condition;
    FrictionLaw::Parameters      friction;
    TreadParameters              tread;
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
