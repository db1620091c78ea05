// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_laminate_principal_axes_h
#define biface_laminate_principal_axes_h

#include <deal.II/base/symmetric_tensor.h>
#include <deal.II/base/tensor.h>

#include <array>

namespace Biface
{
  /** An eigenvalue of a symmetric tensor, and its unit eigenvector. */
  struct PrincipalAxis
  {
    double               value;
    dealii::Tensor<1, 3> direction;
  };

  /** The principal axes of a tensor, by Jacobi's rotations, as in deal.II,
   * whose functions in its library have the names of one compiler only. */
  std::array<PrincipalAxis, 3>
  principal_axes(const dealii::SymmetricTensor<2, 3> &tensor);
} // namespace Biface

#endif
