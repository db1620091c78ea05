// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_model_quantities_point_displacement_h
#define biface_model_quantities_point_displacement_h

#include <deal.II/base/tensor.h>

#include <vector>

#include <biface/base/linear_algebra.h>
#include <biface/model/mesh/named_points.h>
#include <biface/model/mesh/shell_mesh.h>

namespace Biface
{
  /** The displacements of both faces at a point, Cartesian and in the frame of
   * the coordinate lines. */
  struct PointDisplacement
  {
    /** The displacements of the inner and the outer face, then of those between
     * layers, from the inside out: Cartesian components, and those in the frame
     * of the node. Unit: length. */
    std::vector<dealii::Tensor<1, 3>> global, local;
  };


  /** The displacements at a named point, the same on all ranks. Must be called
   * on all ranks. */
  PointDisplacement
  displacement_at(const NamedPoint &point,
                  const LA::Vector &displacement,
                  const ShellMesh  &mesh);
} // namespace Biface

#endif
