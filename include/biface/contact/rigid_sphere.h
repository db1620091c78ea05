// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_contact_rigid_sphere_h
#define biface_contact_rigid_sphere_h

#include <deal.II/base/parameter_handler.h>

#include <biface/contact/rigid_foundation.h>

namespace Biface
{
  /** A rigid ball; where its radius is negative, what is around a hollow one.
   */
  class RigidSphere : public RigidFoundation
  {
  public:
    struct Parameters
    {
      double radius = 100;

      void
      add_parameters(dealii::ParameterHandler &prm);
    };

    /** Throws InputError where the parameters are not those of a sphere. */
    RigidSphere(const Path &path, const Parameters &parameters);

    /** @param radius any number but 0. */
    RigidSphere(const Path &path, const double radius)
      : RigidFoundation(path), radius(radius)
    {}

    FoundationPoint
    evaluate(const dealii::Point<3> &x) const override;

    double
    travel_to(const dealii::Point<3> &x) const override;

  private:
    const double radius;
  };
} // namespace Biface

#endif
