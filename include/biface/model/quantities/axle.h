// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_model_quantities_axle_h
#define biface_model_quantities_axle_h

#include <deal.II/base/tensor.h>

#include <vector>

namespace Biface
{
  struct Loads;
  class ShellMesh;


  /** The motion of the axle of a wheel: the mean of the translations of the
   * edges that its rim holds. Turns and other motions of them do not count.
   * Unit: length. */
  dealii::Tensor<1, 3>
  displacement_of_axle(const ShellMesh &mesh, const Loads &loads);

  /** The motion of the axle of a wheel by given load factors, or its velocity
   * by their rates. Unit: length, or length/time. */
  dealii::Tensor<1, 3>
  displacement_of_axle(const ShellMesh           &mesh,
                       const std::vector<double> &factors);
} // namespace Biface

#endif
