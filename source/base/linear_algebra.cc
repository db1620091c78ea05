// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/lac/lapack_full_matrix.h>

#include <biface/base/linear_algebra.h>

namespace Biface
{
  using namespace dealii;

  bool
  invert(FullMatrix<double> &matrix)
  {
    if (matrix.empty())
      return true;

    // FullMatrix only asserts that a matrix is regular
    LAPACKFullMatrix<double> inverse(matrix.m());
    inverse = matrix;
    try
      {
        inverse.compute_lu_factorization();
      }
    catch (const LACExceptions::ExcSingular &)
      {
        return false;
      }
    inverse.invert();
    matrix = inverse;
    return true;
  }
} // namespace Biface
