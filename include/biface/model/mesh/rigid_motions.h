// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_model_mesh_rigid_motions_h
#define biface_model_mesh_rigid_motions_h

#include <deal.II/base/tensor.h>

#include <string>
#include <vector>

#include <biface/base/linear_algebra.h>
#include <biface/model/mesh/shell_mesh.h>

namespace Biface
{
  /**
   * The infinitesimal rigid motions that the supports leave free, in words:
   * "translation along y", "rotation about x", or "translation along x with
   * rotation about z" for a combination. Rotations are about axes through the
   * mean of all nodes.
   *
   * Such a shell is held only by its loads or by contact, if at all. Must be
   * called on all ranks.
   */
  std::vector<std::string>
  free_rigid_motions(const ShellMesh &mesh);

  /** The names of motions, separated by commas. */
  std::string
  in_words(const std::vector<std::string> &names);


  /** A rigid motion of the deformed shell. */
  struct RigidMotion
  {
    /** The name of the motion, such as "translation along y", see
     * free_rigid_motions(). */
    std::string name;
    /** The displacements of the locally owned unknowns, for a shell of unit
     * size; zero where constraints determine them. */
    LA::Vector displacement;
    /** The vector of the rotation; zero for a translation. */
    dealii::Tensor<1, 3> rotation;
  };


  /**
   * A basis of the infinitesimal rigid motions of the deformed shell that meet
   * no resistance.
   *
   * Must be called on all ranks.
   *
   * @param displacement that of the shell.
   * @param stiffness that of what holds it in addition to the supports; null
   * for nothing.
   */
  std::vector<RigidMotion>
  free_rigid_motions(const ShellMesh        &mesh,
                     const LA::Vector       &displacement,
                     const LA::SparseMatrix *stiffness = nullptr);

  /** The change of nodal forces that turn with the shell, per unit of an
   * infinitesimal rotation: the cross products of its vector and the forces.
   */
  LA::Vector
  turned(const ShellMesh            &mesh,
         const dealii::Tensor<1, 3> &rotation,
         const LA::Vector           &forces);

  /**
   * The six rigid motions of the shell, three translations and three rotations,
   * as nodal displacements: the entries of each for the locally owned degrees
   * of freedom, in their order. Supports are ignored.
   */
  std::vector<std::vector<double>>
  rigid_motions(const ShellMesh &mesh);
} // namespace Biface

#endif
