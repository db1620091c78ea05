// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_model_quantities_work_h
#define biface_model_quantities_work_h

namespace Biface
{
  class ContactInteraction;
  struct Loads;
  class NodalForces;
  struct State;


  /** Work done on the shell. Unit: force times length. */
  struct Work
  {
    /** The work of the loads and of prescribed displacements. */
    double loads = 0;
    /** The work of the moving ground on the nodes in contact. */
    double ground = 0;
    /** The part of @p ground that friction dissipates. */
    double friction = 0;
    /** The work that ViscousDamping dissipates or, in motion, the damping that
     * is proportional to mass and stiffness. */
    double damping = 0;
    /** The work that numerical damping dissipates in motion. */
    double numerical = 0;
    /** The work that contact but for friction dissipates in motion. */
    double contact = 0;
    /** The growth of the energies in motion beyond the work without what is
     * dissipated. */
    double unbalanced = 0;

    Work &
    operator+=(const Work &other)
    {
      loads += other.loads;
      ground += other.ground;
      friction += other.friction;
      damping += other.damping;
      numerical += other.numerical;
      contact += other.contact;
      unbalanced += other.unbalanced;
      return *this;
    }

    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &loads &ground &friction &damping &numerical &contact &unbalanced;
    }
  };


  /** A converged state, its loads, and the forces on its nodes, kept by
   * reference. */
  struct LoadedState
  {
    const State       &state;
    const Loads       &loads;
    const NodalForces &forces;
  };


  /**
   * The work in a step, by the trapezoidal rule: mean forces times
   * displacements. Its error decreases with the square of the size of the step.
   * Loads and ground do as much work as the strain energy increases by,
   * plus that of friction and damping, and the small elastic energy in the
   * springs of contact.
   *
   * Must be called on all ranks.
   *
   * @param before, after the start and the end of the step, both with a
   * ground or both without.
   */
  Work
  work_of_step(const ContactInteraction &contact,
               const LoadedState        &before,
               const LoadedState        &after);
} // namespace Biface

#endif
