// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_laminate_resultants_h
#define biface_laminate_resultants_h

#include <deal.II/base/tensor.h>

namespace Biface
{
  /**
   * The order of the eleven strains of a shell with two faces, and of the
   * work-conjugate resultants:
   *
   * | 0, 1 | 2, 3 | 4, 5 | 6, 7 | 8, 9 | 10 |
   * |---|---|---|---|---|---|
   * | @f$E_{11}^\mp@f$ | @f$E_{22}^\mp@f$ | @f$2E_{12}^\mp@f$ |
   * @f$2E_{13}^\mp@f$ | @f$2E_{23}^\mp@f$ | @f$E_{33}@f$ |
   *
   * The inner face (-) comes first. Strains are pure numbers, resultants are
   * forces per length.
   */
  namespace Resultants
  {
    constexpr unsigned int n = 11;

    /** The inner and the outer face. */
    enum Face : unsigned int
    {
      inner = 0,
      outer = 1
    };

    /** The index of a tangential strain; @p ab is 0, 1, 2 for 11, 22, 12. */
    constexpr unsigned int
    tangential(const unsigned int ab, const unsigned int face)
    {
      return 2 * ab + face;
    }

    /** The number of tangential strains, which come first. */
    constexpr unsigned int n_tangential = 6;

    /** The components of a tensor that a tangential strain stands for, by
     * @p ab. */
    constexpr unsigned int tangential_pairs[3][2] = {{0, 0}, {1, 1}, {0, 1}};

    /** The index of a transverse shear strain; @p a is 0, 1 for 13, 23. */
    constexpr unsigned int
    transverse(const unsigned int a, const unsigned int face)
    {
      return 6 + 2 * a + face;
    }

    /** The index of the thickness strain @f$E_{33}@f$. */
    constexpr unsigned int thickness = 10;

    using Vector = dealii::Tensor<1, n>;
    using Matrix = dealii::Tensor<2, n>;
  } // namespace Resultants
} // namespace Biface

#endif
