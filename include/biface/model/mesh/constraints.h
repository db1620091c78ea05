// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_model_mesh_constraints_h
#define biface_model_mesh_constraints_h

#include <deal.II/base/tensor.h>
#include <deal.II/base/types.h>
#include <deal.II/lac/affine_constraints.h>

#include <array>
#include <string>
#include <valarray>
#include <vector>

#include <biface/model/mesh/support_motion.h>

namespace Biface
{
  class MeshNodes;
  struct Supports;

  /** A constrained unknown whose constraint is not homogeneous: the sum of
   * @p values, each multiplied by one of Loads::factors, is added to the
   * entries of the constraint. */
  struct PrescribedDisplacement
  {
    dealii::types::global_dof_index dof;
    std::valarray<double>           values;
  };


  /** An equation of a support for the displacements of the faces at a node, or
   * at the nodes of a joint. */
  struct SupportEquation
  {
    /** The coefficients of the displacements of all faces, node by node: those
     * of @f$v_1@f$ from the inner to the outer face, then those of @f$v_2@f$
     * and @f$v_3@f$. The forces of the support on the faces are a multiple of
     * the coefficients. */
    std::valarray<double> coefficients;
    /** The parts of the right-hand side, which is their sum, each multiplied by
     * one of Loads::factors. */
    std::valarray<double> values;
    /** The support: a position in SupportedNodes::bodies; invalid if the
     * equation connects faces with each other: those of a layer that does not
     * exist, or at a joint. */
    unsigned int body;
    /** The fraction of the forces of the support on the node itself; the rest
     * acts on the partner of a node on a cyclic edge. */
    double share;
    /** The position in Loads::factors of the factor of the displacement, if
     * it is prescribed and not zero everywhere; otherwise invalid. */
    unsigned int factor = dealii::numbers::invalid_unsigned_int;
  };


  /** The nodes of this rank that supports hold, and the supports. */
  struct SupportedNodes
  {
    struct Item
    {
      /** The position of the node in MeshNodes::nodes; several at a joint. */
      std::vector<unsigned int> nodes;
      /** The node with the same displacements on the second of two cyclic
       * edges, while the node is on the first; invalid if there is none. */
      unsigned int partner;
      /** The linearly independent equations. If several supports hold a
       * displacement, the equation is that of the first one, in the order of
       * @p bodies. */
      std::vector<SupportEquation> equations;
    };

    /** The names of the supports: points, then edges. */
    std::vector<std::string> bodies;
    /** The positions in @p bodies of the edges of alpha_2, if they are
     * cyclic. */
    std::array<unsigned int, 2> cyclic_bodies;
    std::vector<Item>           items;
    /** The motions of supports, see find_support_motions(). */
    std::vector<SupportMotion> motions;
  };


  /**
   * The constraints of the supports on the displacements of a mesh.
   *
   * The equations of all supports at a node are eliminated together, each for
   * the unknown with the largest coefficient.
   *
   * Between cyclic edges, the unknowns on the edge alpha_2 max depend on those
   * on the edge alpha_2 min, and supports of either hold both.
   *
   * Throws InputError if they contradict each other, or if a supported point
   * does not exist.
   *
   * Where a layer does not exist, its half difference is zero. The nodes of a
   * joint, see MeshNodes::joints, are eliminated together, too.
   *
   * @param constraints the supports with zero prescribed displacements, closed.
   * @param prescribed the prescribed displacements that are not zero.
   * @param supported the equations themselves, without motions.
   */
  void
  make_constraints(const Supports                      &supports,
                   const MeshNodes                     &mesh,
                   dealii::AffineConstraints<double>   &constraints,
                   std::vector<PrescribedDisplacement> &prescribed,
                   SupportedNodes                      &supported);
} // namespace Biface

#endif
