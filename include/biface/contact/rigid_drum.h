// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_contact_rigid_drum_h
#define biface_contact_rigid_drum_h

#include <biface/contact/rigid_sphere.h>

namespace Biface
{
  /** A rigid cylinder without end: across its axis it is a RigidSphere. */
  class RigidDrum : public RigidFoundation
  {
  public:
    struct Parameters
    {
      double               radius = 854;
      dealii::Tensor<1, 3> axis{{0, 1, 0}};

      void
      add_parameters(dealii::ParameterHandler &prm);
    };

    /** Throws InputError where the parameters are not those of a drum. */
    RigidDrum(const Path &path, const Parameters &parameters);

    FoundationPoint
    evaluate(const dealii::Point<3> &x) const override;

    double
    travel_to(const dealii::Point<3> &x) const override;

  private:
    const dealii::Tensor<1, 3> axis;
    const RigidSphere          section;
  };
} // namespace Biface

#endif
