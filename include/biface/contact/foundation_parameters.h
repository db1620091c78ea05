// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_contact_foundation_parameters_h
#define biface_contact_foundation_parameters_h

#include <deal.II/base/parameter_handler.h>

#include <memory>

#include <biface/contact/rigid_drum.h>
#include <biface/contact/rigid_foundation.h>
#include <biface/contact/rigid_sphere.h>

namespace Biface
{
  /** Which foundation the shell is pressed on. */
  struct FoundationParameters
  {
    enum class Type
    {
      plane,
      drum,
      sphere
    };

    Type                    type = Type::plane;
    RigidFoundation::Path   path;
    RigidDrum::Parameters   drum;
    RigidSphere::Parameters sphere;

    void
    add_parameters(dealii::ParameterHandler &prm);
  };


  /** Make the foundation. Throws InputError where the parameters do not
   * describe one. */
  std::shared_ptr<const RigidFoundation>
  make_foundation(const FoundationParameters &parameters);
} // namespace Biface

#endif
