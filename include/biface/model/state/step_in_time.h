// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_model_state_step_in_time_h
#define biface_model_state_step_in_time_h

#include <vector>

#include <biface/model/state/damping_in_time.h>
#include <biface/model/state/load_rates.h>
#include <biface/model/state/loads.h>
#include <biface/model/state/moving_mass.h>
#include <biface/model/state/state.h>

namespace Biface
{
  /**
   * A step in time from one state to another, by the energy-momentum method
   * @cite SimoTarnow1992. With the velocities @f$\mathbf v@f$,
   * @f[
   *   \frac{\mathbf V_1-\mathbf V_0}{\Delta t}
   *     =\frac{\mathbf v_0+\mathbf v_1}2,\qquad
   *   \mathbf M\,\frac{\mathbf v_1-\mathbf v_0}{\Delta t}
   *     =\bar{\mathbf f}(\mathbf V_0,\mathbf V_1) .
   * @f]
   * The forces over the step, ForceTerm::add_over_step(), do the work by which
   * the energy of each term changes.
   *
   * It belongs to the State at the end of the step while that is sought, see
   * State::step.
   */
  struct StepInTime
  {
    /** The state and the loads at the start. */
    State start;
    Loads loads_at_start;
    /** The pressure and the load factors in the middle of the step. */
    LoadRates middle;
    /** Unit: time. */
    double        duration = 0;
    DampingInTime damping;
    /** The bodies and supports that move with their masses. */
    std::vector<MovingMass> masses;
    /** About the axle, of what turns with a wheel beside the shell: rim, brake
     * and drive. Unit: mass*length². */
    double moment_of_inertia = 0;
    /** Whether the tangent holds points that slip against their traction, too,
     * by its secant: an iteration that would throw them to and fro then
     * converges, though more slowly. */
    bool secant_of_friction = false;
    /** What is added to the accelerations that the displacements give, at nodes
     * whose supports move: there the velocity at the end is that of the
     * supports. Readable at all nodes of this rank; empty for nothing. Unit:
     * length/time². */
    LA::Vector of_supports;

    /** The mass with a load factor, which there must be. */
    const MovingMass &
    mass_with(const unsigned int factor) const;

    /** The part of the change of the stresses that acts over the step,
     * @f$\kappa=\frac12+\frac\chi2+\tau/\Delta t@f$ with
     * DampingInTime::numerical and DampingInTime::of_stiffness. */
    double
    weight_of_end() const
    {
      return 0.5 + damping.numerical / 2 + damping.of_stiffness / duration;
    }

    /** The loads over the step, given those at its end, where bodies are. */
    Loads
    over_step(const Loads &end) const;

    /** The angular velocity of a wheel that rolls: its mean in the step, in
     * which it changes evenly, and its rate. Unit: radians/time, and
     * radians/time². */
    struct Spin
    {
      double mean = 0, acceleration = 0;
    };

    /** @param end the loads at the end, with Loads::rolling. */
    Spin
    spin(const Loads &end) const;

    /** The velocity at the end of the step (locally owned entries), given the
     * state there. */
    LA::Vector
    velocity(const State &end) const;

    /** The mean acceleration in the step (locally owned entries), given the
     * state at its end. */
    LA::Vector
    acceleration(const State &end) const;
  };


  /** The state that moves on from a given one for a duration, with its velocity
   * and without forces: an initial guess. */
  LA::Vector
  extrapolated(const State &state, const double duration);
} // namespace Biface

#endif
