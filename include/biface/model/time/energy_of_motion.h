// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_model_time_energy_of_motion_h
#define biface_model_time_energy_of_motion_h

#include <deal.II/base/tensor.h>

#include <biface/model/quantities/work.h>

namespace Biface
{
  class ContactInteraction;
  struct Loads;
  class NodalForces;
  class ShellEquations;
  struct State;


  /** The energies of a shell that moves, with its bodies, and the momenta of
   * the shell. Unit: force times length, and force times time. */
  struct EnergyOfMotion
  {
    /** The kinetic energy, in the frame of the axle if the shell is a wheel
     * that rolls. */
    double kinetic = 0;
    /** The potential of centrifugal forces on a wheel that rolls, see
     * InertiaOfWheel::potential(). */
    double centrifugal = 0;
    /** The energy of ShellEquations::strain_energy(). */
    double strain = 0;
    /** The energy of the springs of contact. */
    double contact = 0;
    /** The kinetic energy of bodies and supports with masses, and the energy of
     * their springs, see MovingMass. */
    double               of_masses = 0, of_springs = 0;
    dealii::Tensor<1, 3> momentum;
    /** About the origin. Unit: force times length times time. */
    dealii::Tensor<1, 3> angular_momentum;

    double
    sum() const
    {
      return kinetic + centrifugal + strain + contact + of_masses + of_springs;
    }
  };


  /** Must be called on all ranks.
   * @param state that moves; at the end of a StepInTime, with its masses. */
  EnergyOfMotion
  energy_of_motion(const ShellEquations     &equations,
                   const ContactInteraction &contact,
                   const State              &state,
                   const Loads              &loads);


  /**
   * The work in a StepInTime, by the forces over the step: it is exact, so that
   * Work::unbalanced is round-off and what the iteration has left.
   *
   * Must be called on all ranks.
   *
   * @param state at the end of the step, with its new velocity.
   * @param loads there.
   * @param forces on the nodes over the step.
   * @param after the energies at the end of the step.
   */
  Work
  work_in_time(const ShellEquations     &equations,
               const ContactInteraction &contact,
               const State              &state,
               const Loads              &loads,
               const NodalForces        &forces,
               const EnergyOfMotion     &after);


  /** The error in time of a step. */
  struct ErrorInTime
  {
    /** Whether the shell has been at rest in the steps before, so that no
     * acceleration before tells the error. */
    bool from_rest = false;
    /** The norm of @f$\frac{\Delta t^3}{12}\dot{\mathbf a}@f$ with the mass
     * matrix, relative to the motion in the step with the largest velocity so
     * far. The change of the accelerations is that from the middle of the step
     * before; 0 in the first step of a stage. */
    double value = 0;
  };

  /** Must be called on all ranks.
   * @param state, loads at the end of the step. */
  ErrorInTime
  error_in_time(const ShellEquations &equations,
                const State          &state,
                const Loads          &loads);


  /** Let a state at the end of a step remember what error_in_time() needs: its
   * acceleration, and the largest energy of the motion since the start of the
   * stage; and the motions of masses.
   * @param state at the end of the step, with its new velocity.
   * @param loads there. */
  void
  remember_motion(const ShellEquations &equations,
                  const Loads          &loads,
                  State                &state);
} // namespace Biface

#endif
