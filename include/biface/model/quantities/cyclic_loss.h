// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_model_quantities_cyclic_loss_h
#define biface_model_quantities_cyclic_loss_h

#include <deal.II/lac/full_matrix.h>

#include <optional>
#include <vector>

namespace Biface
{
  /**
   * What a particle with the loss factor 1 dissipates in a turn, as a function
   * of the cycles of its stresses and strains: with
   * @f$\sigma=\sum_n\sigma_n\cos(n\varphi+\alpha_n)@f$ and the strains in phase
   * with them, harmonic n passes n cycles a turn with the loss
   * @f$\pi\sigma_n\varepsilon_n@f$ each,
   * @f[
   *   w=\pi\sum_n n\,\sigma_n\varepsilon_n .
   * @f]
   *
   * The cycles are piecewise linear between given angles. With the changes
   * @f$d_j@f$ of their slopes there, the sum over all harmonics is
   * @f[
   *   w=\frac1\pi\sum_{j,k}d^\sigma_j\,d^\varepsilon_k\,
   *   C(\varphi_j-\varphi_k),\qquad
   *   C(x)=\sum_{n=1}^\infty\frac{\cos nx}{n^3},
   * @f]
   * without truncation. For piecewise constant cycles it would not converge.
   */
  class CyclicLoss
  {
  public:
    /** The form for cycles between given angles.
     * @param angles in ascending order, within a turn. Unit: radians.
     * @param n_harmonics how many are counted, all by default. */
    CyclicLoss(const std::vector<double>        &angles,
               const std::optional<unsigned int> n_harmonics = {});

    /** The symmetric matrix of the quadratic form in the values at the angles,
     * @f$w=\sum_{j,k}\sigma_j\,Q_{jk}\,\varepsilon_k@f$. */
    const dealii::FullMatrix<double> &
    matrix() const
    {
      return Q;
    }

  private:
    dealii::FullMatrix<double> Q;
  };
} // namespace Biface

#endif
