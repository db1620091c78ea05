// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_laminate_stiffness_along_h
#define biface_laminate_stiffness_along_h

#include <deal.II/base/tensor.h>

#include <array>

namespace Biface
{
  class Laminate;

  /** `[p][q]` is the force on the face p by the strain of the face q. Unit:
   * force/length. */
  using StiffnessOfFaces = std::array<std::array<double, 2>, 2>;

  /** Laminate::stiffness_along() a direction between the axes of the laminate,
   * a unit vector. */
  StiffnessOfFaces
  stiffness_along(const Laminate             &laminate,
                  const dealii::Tensor<1, 2> &direction);

  /** Whether stiffness_along() is the same in all directions. */
  bool
  is_isotropic(const Laminate &laminate);

  /** The bending stiffness for a curvature along a direction: the moment per
   * length of a plane section about the height at which it turns without a
   * resultant force, for the unit curvature. Unit: force times length. */
  double
  bending_stiffness_along(const Laminate             &laminate,
                          const dealii::Tensor<1, 2> &direction);
} // namespace Biface

#endif
