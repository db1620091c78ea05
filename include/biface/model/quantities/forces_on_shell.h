// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_model_quantities_forces_on_shell_h
#define biface_model_quantities_forces_on_shell_h

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <string>
#include <vector>

#include <biface/base/linear_algebra.h>

namespace Biface
{
  struct Loads;
  class NodalForces;
  class ShellEquations;
  class ShellMesh;
  struct State;


  /** The resultant of the forces of a body on the shell. */
  struct ForceOnShell
  {
    std::string          body;
    dealii::Tensor<1, 3> force;
    /** The moment about the origin. Unit: force times length. */
    dealii::Tensor<1, 3> moment;
    /** The forces, or moments, of a support along its motions: those of
     * SupportedNodes::motions whose body it is, each of the whole structure,
     * see SupportMotion::multiple. Empty for what prescribes no displacement.
     */
    std::vector<double> along_motions;

    /** The moment about another point. */
    dealii::Tensor<1, 3>
    moment_about(const dealii::Point<3> &center) const
    {
      return moment - cross_product_3d(center, force);
    }
  };


  /** The names of the bodies, in the order of forces_on_shell(). */
  std::vector<std::string>
  bodies_on_shell(const ShellEquations &equations);


  /**
   * The forces and moments on the shell of each of its supports, of the
   * ground and of the loads, with damping, in Cartesian components.
   *
   * The forces of the supports are what is missing for equilibrium at the nodes
   * that they hold, @f$\sum_k\lambda_k\mathbf c_k@f$ with the coefficients
   * @f$\mathbf c_k@f$ of their equations, see SupportEquation. All nodal forces
   * act on the faces in their deformed positions; in linear theory, in those
   * about which it is linearized.
   *
   * In equilibrium, the sums over all bodies vanish. Two of them are no bodies
   * in the proper sense:
   * - `prestress`: the constant forces that are not among the loads, see
   *   InternalForces::unlisted_forces(), without those at supports, which count
   *   as forces of the supports;
   * - `interpolation`: the sum of all internal forces. It vanishes if the shell
   *   is flat; if it is curved, rigid motions are interpolated only up to an
   *   error of second order in the size of the cells, and this is their work.
   *
   * Must be called on all ranks, for a converged state.
   *
   * @param forces on the nodes in this state.
   */
  std::vector<ForceOnShell>
  forces_on_shell(const ShellEquations &equations,
                  const State          &state,
                  const NodalForces    &forces);


  /** The forces and moments of each support on the shell, in the order of
   * SupportedNodes::bodies, if given forces are missing on the nodes. Must be
   * called on all ranks.
   * @param displacement gives the positions of the faces; with the entries of
   * all nodes of this rank.
   * @param missing the missing forces on owned unknowns, regardless of
   * supports; only those at supports matter. */
  std::vector<ForceOnShell>
  forces_of_supports(const ShellMesh  &mesh,
                     const LA::Vector &displacement,
                     const LA::Vector &missing);


  /** The displacement of a motion of a support, and the force or moment along
   * it. Unit: length, or degrees; force, or force times length. */
  struct SupportReaction
  {
    double displacement = 0;
    double force        = 0;
  };


  /** The reactions of the motions of all supports, in the order of
   * SupportedNodes::motions.
   * @param forces those of forces_on_shell(). */
  std::vector<SupportReaction>
  support_reactions(const ShellMesh                 &mesh,
                    const Loads                     &loads,
                    const std::vector<ForceOnShell> &forces);


  /** The forces on the straight line through those of two states: at 0 the
   * first ones, at 1 the second ones. */
  std::vector<ForceOnShell>
  interpolated_forces(const std::vector<ForceOnShell> &first,
                      const std::vector<ForceOnShell> &second,
                      const double                     position);


  /** The resultant of the ground among those of forces_on_shell(). */
  const ForceOnShell &
  force_of_ground(const std::vector<ForceOnShell> &forces);
} // namespace Biface

#endif
