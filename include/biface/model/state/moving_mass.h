// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_model_state_moving_mass_h
#define biface_model_state_moving_mass_h

namespace Biface
{
  struct Loads;
  struct State;


  /** A rigid body with a mass, or supports that carry one, in a step in time:
   * the load factor of its motion is unknown, and follows from the forces on
   * it. A motion that only turns has moments, angles and moments of inertia. */
  struct MovingMass
  {
    /** The position of its load factor in Loads::factors. */
    unsigned int factor = 0;
    /** The displacement at the factor 1. Unit: length. */
    double amplitude = 1;
    double mass      = 0;
    /** The constants of a damper, and of a spring without force at the factor
     * 0. Unit: force*time/length, and force/length. */
    double damping = 0, stiffness = 0;
    /** The duration of the step. Unit: time. */
    double duration = 0;
    /** The displacement at the start of the step. Unit: length. */
    double displacement = 0;
    /** The velocity at the start of the step. Unit: length/time. */
    double velocity = 0;
    /** The mean acceleration in the step before; 0 in the first one of a
     * stage. Unit: length/time². */
    double last_acceleration = 0;

    /** The displacement in the step. */
    double
    change(const Loads &end) const;

    /** The velocity at the end of the step, by the rule that the mean velocity
     * is that of both ends. */
    double
    velocity_at_end(const Loads &end) const;

    /** The mean acceleration in the step. */
    double
    acceleration(const Loads &end) const;

    /** What the mass, the damper and the spring take up of the force, in the
     * mean of the step: its work is the change of both
     * energies and what dissipated() gives. */
    struct Resistance
    {
      double value = 0;
      /** The sum of the absolute values that cancel in the value. */
      double magnitude = 0;
      /** The derivative by the displacement at the end. */
      double derivative = 0;
    };

    Resistance
    resistance(const Loads &end) const;

    /** The kinetic energy at a velocity. Unit: force times length. */
    double
    kinetic_energy(const double at_velocity) const
    {
      return mass * at_velocity * at_velocity / 2;
    }

    /** The energy of the spring at a load factor. Unit: force times length. */
    double
    energy_of_spring(const double load_factor) const
    {
      const double displacement = amplitude * load_factor;
      return stiffness * displacement * displacement / 2;
    }

    /** What the damper dissipates in the step. Unit: force times length. */
    double
    dissipated(const Loads &end) const;


    /** The motion of a factor that a state remembers from step to step: its
     * velocity and the mean acceleration in the last step, both of the
     * displacement. */
    struct Motion
    {
      double velocity = 0, acceleration = 0;
    };

    /** The motion that a state has for a factor; none without one. */
    static Motion
    motion_in(const State &state, const unsigned int factor);

    static void
    set_motion(State &state, const unsigned int factor, const Motion &motion);

    /** Let a state forget all motions, as in equilibrium. */
    static void
    bring_to_rest(State &state);
  };
} // namespace Biface

#endif
