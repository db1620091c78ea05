// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_model_state_placed_body_h
#define biface_model_state_placed_body_h

#include <string>

#include <biface/contact/contact_laws.h>
#include <biface/contact/rigid_body.h>
#include <biface/laminate/resultants.h>

namespace Biface
{
  /** A rigid body at its present place, and the laws of its contact. */
  struct PlacedBody
  {
    RigidBody   body;
    ContactLaws laws;
    /** The face of the shell that the body touches. */
    Resultants::Face face = Resultants::outer;
    std::string      name = "foundation";
  };
} // namespace Biface

#endif
