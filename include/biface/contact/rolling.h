// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_contact_rolling_h
#define biface_contact_rolling_h

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

namespace Biface
{
  class FrictionLaw;
  class RigidBody;


  /**
   * The axes of a wheel on the ground, those of ISO 8855: forward, to the left
   * and up from the ground, right-handed. Its axle is the y axis.
   */
  struct WheelAxes
  {
    dealii::Tensor<1, 3> forward, left, up;

    /** The axes for a direction toward the ground.
     * @param direction toward the ground, not along the axle; any length. */
    explicit WheelAxes(const dealii::Tensor<1, 3> &direction);

    /** Whether a wheel can roll on the ground in this direction: the sine of
     * the angle between the ground and the axle is below 0.9. */
    static bool
    fit(const dealii::Tensor<1, 3> &direction);
  };


  /** The rigid motion of the ground in the frame of the axle: a plane moves
   * straight ahead, a drum turns. */
  struct GroundMotion
  {
    /** The velocity of @p point. Unit: length/time. */
    dealii::Tensor<1, 3> velocity;
    /** The angular velocity as a vector; zero for a plane. Unit:
     * radians/time. */
    dealii::Tensor<1, 3> spin;
    dealii::Point<3>     point;

    dealii::Tensor<1, 3>
    at(const dealii::Point<3> &x) const
    {
      return velocity + dealii::cross_product_3d(spin, x - point);
    }

    /**
     * The motion of the ground under a wheel that moves over it with a given
     * speed: that of its surface, for a drum where the line of travel meets it.
     *
     * @param ground no sphere. A drum moves along its circumference, so that it
     * must have been turned by the slip angle, see ground_at_slip_angle().
     * @param slip_angle by which the wheel moves to the left of its plane, in
     * radians.
     */
    static GroundMotion
    under_wheel(const RigidBody &ground,
                const double     speed,
                const double     slip_angle);
  };


  /** The ground at rest under a wheel that is steered: a drum is turned under
   * the wheel about its line of travel, and the wheel then moves over it to the
   * left of its plane by the slip angle, in radians. A plane remains as it
   * is. */
  RigidBody
  ground_at_slip_angle(const RigidBody &ground, const double slip_angle);


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
    /** The angular velocity @f$\Omega@f$ of the wheel. Unit: radians/time. */
    double angular_velocity = 0;

    /** The motion @f$\mathbf v_g(\mathbf x)@f$ of the ground. */
    GroundMotion ground{};

    /** The velocity of a particle relative to the ground.
     * @param x its position.
     * @param slope @f$\partial\mathbf x/\partial\varphi@f$ */
    dealii::Tensor<1, 3>
    relative_velocity(const dealii::Point<3>     &x,
                      const dealii::Tensor<1, 3> &slope) const
    {
      return -angular_velocity * slope - ground.at(x);
    }
  };


  /**
   * Coulomb's law of friction by the slip velocity @f$\mathbf s@f$, the
   * tangential part of the velocity of a particle relative to the ground,
   * regularized by the critical velocity @f$s_c@f$ of FrictionLaw:
   * @f[
   *   \mathbf t=-\tau(p,|\mathbf s|)\,
   *   \frac{\mathbf s}{\sqrt{|\mathbf s|^2+s_c^2}}
   * @f]
   * with the limit @f$\tau@f$ of FrictionLaw. It has no history. A particle
   * that sticks creeps with a velocity below @f$s_c@f$.
   */
  class SlipVelocityLaw
  {
  public:
    /** The law with the limit of a FrictionLaw.
     * @param law kept by reference. */
    explicit SlipVelocityLaw(const FrictionLaw &law) : law(law)
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
    slips(const dealii::Tensor<1, 3> &slip) const;

  private:
    const FrictionLaw &law;
  };
} // namespace Biface

#endif
