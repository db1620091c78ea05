// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_model_constraints_h
#define biface_model_constraints_h

#include <deal.II/base/types.h>
#include <deal.II/lac/affine_constraints.h>

#include <vector>

#include <biface/model/supports.h>

namespace Biface
{
  class ShellMesh;

  /** A displacement prescribed by a support:
   * @f$v = f\,v_{other} + \bar v@f$, where @f$\bar v@f$ is multiplied by the
   * load factor. */
  struct PrescribedDisplacement
  {
    dealii::types::global_dof_index dof;
    /** Invalid if f is zero. */
    dealii::types::global_dof_index other;
    double                          factor;
    double                          value;
  };


  /**
   * The constraints of the supports on the displacements of a mesh.
   *
   * Throws InputError if they contradict each other, or if a supported point
   * does not exist.
   *
   * @param constraints the supports with zero prescribed displacements, closed.
   * @param prescribed the prescribed displacements that are not zero.
   */
  void
  make_constraints(const Supports                      &supports,
                   const ShellMesh                     &mesh,
                   dealii::AffineConstraints<double>   &constraints,
                   std::vector<PrescribedDisplacement> &prescribed);
} // namespace Biface

#endif
