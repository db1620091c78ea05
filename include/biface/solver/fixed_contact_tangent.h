// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_solver_fixed_contact_tangent_h
#define biface_solver_fixed_contact_tangent_h

#include <deal.II/base/timer.h>

#include <memory>
#include <utility>
#include <vector>

#include <biface/base/linear_algebra.h>
#include <biface/model/mesh/rigid_motions.h>

namespace Biface
{
  class ContactInteraction;
  class ContactPair;
  struct Loads;
  class ShellEquations;
  class ShellMesh;
  struct State;
  class TangentMatrix;


  /**
   * The tangent of an equilibrium for motions that do not change the nodes in
   * contact, for eigenvalue problems: with the prestress and the loads that
   * follow the shell, without the gas sealed in it. In linear strain theory it
   * is that of the shape about which the strains are linearized, with the
   * stresses of the equilibrium.
   *
   * The nodes in contact are held along the normal of the body by the
   * penalty stiffness of the contact condition, with the lumped mortar matrix,
   * so that contact never makes the tangent unsymmetric. With friction, they
   * also stick to the body; see TangentialLaw::stick_all(). While
   * the shell rolls, the whole tangent of the contact is part of it instead:
   * friction follows from the slip velocity, needs the lumped mortar matrix,
   * and makes the tangent unsymmetric.
   */
  class FixedContactTangent
  {
  public:
    /** The objects are kept by reference. */
    FixedContactTangent(ShellEquations           &equations,
                        const ContactInteraction &contact,
                        dealii::TimerOutput      &timer);

    ~FixedContactTangent();

    /** Compute the tangent of the shell without the bodies, or with them if it
     * rolls with friction. The last assembly of the equations is lost. */
    void
    assemble(const State &state, const Loads &loads, LA::SparseMatrix &K);

    /** Add the stiffness that holds the nodes in contact, if there are bodies,
     * and if assemble() has not. */
    void
    add_contact_stiffness(const State      &state,
                          const Loads      &loads,
                          LA::SparseMatrix &K);

    /** The rigid motions of the shell that neither supports nor bodies
     * resist; none while it rolls. */
    std::vector<RigidMotion>
    free_motions(const State &state, const Loads &loads);

    /** The motions among free_motions() that loads and reactions do not resist,
     * either, such as a rotation of an unloaded shell.
     * @param K the tangent of the equilibrium. */
    std::vector<RigidMotion>
    neutral_motions(const State            &state,
                    const Loads            &loads,
                    const LA::SparseMatrix &K);

    /** The loads without the bodies in contact. */
    static Loads
    without_bodies(const Loads &loads);

    /** Whether the shell rolls with friction, so that the bodies act with their
     * own derivatives. */
    static bool
    rolls_with_friction(const Loads &loads);

    /** The state and the loads whose tangent assemble() computes. */
    static std::pair<State, Loads>
    of_tangent(const State &state, const Loads &loads);

    /** Add the stiffness by which a body holds the nodes in contact, if it does
     * not roll with friction, to a matrix with any constraints. */
    static void
    add_stiffness_of(const ContactPair &pair,
                     const State       &state,
                     const Loads       &loads,
                     TangentMatrix     &stiffness);

    /** Whether the tangent that assemble() gave for these loads is symmetric,
     * see ShellEquations::is_symmetric(). */
    bool
    is_symmetric(const Loads &loads, const LA::SparseMatrix &K) const;

    /** Whether loads alone can make the tangent unsymmetric, see
     * ShellEquations::is_symmetric_but_for_loads(). */
    bool
    is_symmetric_but_for_loads(const Loads &loads) const;

  private:
    /** The stiffness by which the bodies hold the nodes in contact. */
    const LA::SparseMatrix &
    stiffness_of_contact(const State &state, const Loads &loads);

    ShellEquations           &equations;
    const ContactInteraction &contact;
    dealii::TimerOutput      &timer;
    /** The matrix of stiffness_of_contact(), kept for its pattern. */
    std::unique_ptr<TangentMatrix> of_contact;
  };


  /** The shape of an eigenvector, or its real and imaginary parts, with the
   * entries of all nodes of this rank and those that constraints give; the
   * largest displacement of a face is 1, its square the sum of those of the
   * parts. */
  std::vector<LA::Vector>
  normalized_shapes(const ShellMesh               &mesh,
                    const std::vector<LA::Vector> &parts);
} // namespace Biface

#endif
