// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_model_quantities_rolling_summary_h
#define biface_model_quantities_rolling_summary_h

#include <deal.II/base/tensor.h>

#include <optional>
#include <vector>

#include <biface/model/quantities/hysteresis.h>

namespace Biface
{
  class ContactInteraction;
  class ContactPair;
  struct ForceOnShell;
  struct Loads;
  class ShellEquations;
  struct State;


  /** The forces and powers of a wheel that rolls over a plane or a drum. */
  struct RollingSummary
  {
    /** The force and moment of the ground on the wheel, in the axes of
     * WheelAxes at the contact center. There the line from the center of the
     * wheel down in its middle plane meets the ground; the moment is about this
     * point. */
    dealii::Tensor<1, 3> force, moment;

    /** The distance of the contact center from the center of the wheel. */
    double loaded_radius = 0;

    /** The moment of the axle on the wheel, see axle_moment(). Unit: force
     * times length. */
    double axle_moment = 0;

    /** The component of the velocity over the ground in the plane of the wheel,
     * per angular velocity; not a number without one. Unit: length. */
    double rolling_radius = 0;

    /** The powers of the axle on the wheel, of the ground on the wheel, and
     * that which friction turns into heat. Their balance is @p mismatch, axle +
     * ground - friction - what relaxes: the error of the mesh, which is zero in
     * the limit. Most of it is @p normal_power, the power of the contact
     * pressure on particles that cross the surface of the ground at the edge of
     * contact, where a segment of the mesh is half in contact; @p mismatch plus
     * @p normal_power is the rest. */
    double axle_power = 0, ground_power = 0, friction_power = 0,
           normal_power = 0, mismatch = 0;

    /** The parts of @p friction_power of nodes that slip and of bristles that
     * leave the ground, see BristleLines::Powers; but for an error of the mesh
     * they are all of it. Without bristles all is sliding. */
    double sliding_power = 0, release_power = 0;

    /** The hysteresis, if any ply has a loss factor, or relaxes. */
    std::optional<Hysteresis> hysteresis;

    /** The power of the hysteresis, and the drag that has this power at the
     * speed over the ground, of which what loss factors cause is no part of
     * @p force; not a number without a speed. */
    double hysteresis_power = 0, rolling_resistance = 0;
  };


  /** The slip velocity at each node of this rank, see
   * PointInContact::slip_velocity(); zero at nodes that are not in contact.
   * Unit: length/time. */
  std::vector<dealii::Tensor<1, 3>>
  slip_velocities(const ContactPair &contact,
                  const State       &state,
                  const Loads       &loads);

  /** The angular velocity with which the particles in contact have the velocity
   * of the ground in the mean, weighted by the forces that they carry: nearly
   * that of free rolling. None if nothing is in contact. Must be called on all
   * ranks. Unit: radians/time. */
  std::optional<double>
  angular_velocity_without_slip(const ContactPair &contact,
                                const State       &state,
                                const Loads       &loads);

  /** The figures of a converged state of a rolling wheel. Must be called on all
   * ranks.
   * @param exerted the force of the ground. */
  RollingSummary
  summarize_rolling(const ShellEquations     &equations,
                    const ContactInteraction &interaction,
                    const State              &state,
                    const Loads              &loads,
                    const ForceOnShell       &exerted);
} // namespace Biface

#endif
