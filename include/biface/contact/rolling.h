// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_contact_rolling_h
#define biface_contact_rolling_h

#include <deal.II/base/tensor.h>

#include <biface/contact/friction.h>

namespace Biface
{
  /**
   * The axes of a wheel on the ground, those of ISO 8855: forward, to the left
   * and up from the ground, right-handed. Its axle is the y axis.
   */
  struct WheelAxes
  {
    dealii::Tensor<1, 3> forward, left, up;

    /** @param direction toward the ground, not along the axle; any length. */
    explicit WheelAxes(const dealii::Tensor<1, 3> &direction);

    /** Whether a wheel can roll on the ground in this direction: the sine of
     * the angle between the ground and the axle is below 0.9. */
    static bool
    fit(const dealii::Tensor<1, 3> &direction);
  };


  /**
   * Steady rolling, seen in the frame that moves with the axle: the shape and
   * the ground are at rest, and the material flows through the mesh.
   *
   * With the angular velocity @f$\Omega@f$ of the wheel, right-handed about the
   * y axis, a particle moves with @f$-\Omega\,\partial\mathbf
   * x/\partial\varphi@f$, since the coordinate @f$\varphi@f$ is left-handed
   * about y.
   */
  struct Rolling
  {
    /** @f$\Omega@f$. Unit: radians/time. */
    double angular_velocity = 0;

    /** @f$\mathbf v_g@f$: that of the ground in the frame of the axle. Unit:
     * length/time. */
    dealii::Tensor<1, 3> ground_velocity;

    /** @f$s_c@f$, see SlipVelocityLaw. */
    double critical_velocity = 0;

    /** The velocity of a particle relative to the ground.
     * @param slope @f$\partial\mathbf x/\partial\varphi@f$ */
    dealii::Tensor<1, 3>
    relative_velocity(const dealii::Tensor<1, 3> &slope) const
    {
      return -angular_velocity * slope - ground_velocity;
    }

    /** The velocity of the ground under a wheel that moves over it with a given
     * speed.
     * @param slip_angle by which the wheel moves to the left of its plane, in
     * radians. */
    static dealii::Tensor<1, 3>
    ground_velocity_of(const WheelAxes &axes,
                       const double     speed,
                       const double     slip_angle);
  };


  /**
   * Coulomb's law of friction by the slip velocity @f$\mathbf s@f$, the
   * tangential part of the velocity of a particle relative to the ground,
   * regularized by the critical velocity @f$s_c@f$:
   * @f[
   *   \mathbf t=-\tau(p)\,\frac{\mathbf s}{\sqrt{|\mathbf s|^2+s_c^2}}
   * @f]
   * with the limit @f$\tau(p)@f$ of FrictionLaw. It has no history. A particle
   * that sticks creeps with a velocity below @f$s_c@f$.
   */
  class SlipVelocityLaw
  {
  public:
    /** @param law kept by reference. */
    SlipVelocityLaw(const FrictionLaw &law, const double critical_velocity)
      : law(law), critical_velocity(critical_velocity)
    {}

    /** The traction on the shell, with its derivatives. */
    struct Traction
    {
      dealii::Tensor<1, 3> value;
      dealii::Tensor<2, 3> per_slip;
      dealii::Tensor<1, 3> per_pressure;
    };

    Traction
    traction(const dealii::Tensor<1, 3> &slip, const double pressure) const;

    /** Whether a particle counts as slipping. */
    bool
    slips(const dealii::Tensor<1, 3> &slip) const
    {
      return slip.norm() > critical_velocity;
    }

  private:
    const FrictionLaw &law;
    const double       critical_velocity;
  };
} // namespace Biface

#endif
