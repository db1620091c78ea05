// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_element_slack_cords_h
#define biface_element_slack_cords_h

#include <deal.II/base/symmetric_tensor.h>
#include <deal.II/base/tensor.h>

#include <array>
#include <vector>

#include <biface/element/modes.h>
#include <biface/laminate/cord_point.h>

namespace Biface
{
  /**
   * The derivative of SlackCords::resultants(): at each Gauss point of the
   * element a matrix for the tangential strains of both faces, to be subtracted
   * from ModeStiffness.
   */
  struct SlackStiffness
  {
    std::array<dealii::SymmetricTensor<2, Resultants::n_tangential>,
               Modes::n_gauss_points>
      at_points;
    /** Whether there are slack cords at a point; otherwise its matrix is zero.
     */
    std::array<bool, Modes::n_gauss_points> any{};
  };


  /**
   * What the resultants of ModeStiffness lack where cords are slack, see
   * CordPoint.
   *
   * The strains of the modes are evaluated at the 2x2 Gauss points of the
   * element, each with its own slack cords. These points integrate products of
   * modes exactly, so that the energy of an element is
   * @f[
   *   w\Bigl(\tfrac12\sum_m w_m\,E_m\,(\mathbf D\mathbf E)_m
   *   -\tfrac12\sum_{g=1}^4\tfrac14\sum_k\kappa_k t_k\min(0,e_{gk})^2\Bigr)
   * @f]
   * with the thicknesses @f$t_k@f$ of the points k in the plies. With one sign
   * per element, or with those at the vertices, the forces would have no
   * energy: modes are no sums over the vertices with the weights of the energy.
   */
  class SlackCords
  {
  public:
    /** @param sampling the set of strain modes. */
    explicit SlackCords(
      const std::vector<CordPoint> &cords,
      const StrainSampling          sampling = StrainSampling::vertices)
      : cords(cords), with_twist(sampling == StrainSampling::means)
    {}

    /** Whether there are no cords that can go slack. */
    bool
    empty() const
    {
      return cords.empty();
    }

    /** The energy that is missing, per area.
     * @param E the modes of all strains, including initial ones. */
    double
    energy(const Modes::Vector &E) const;

    /** Its derivative: the resultants that are missing. */
    Modes::Vector
    resultants(const Modes::Vector &E) const;

    /** The second derivative. */
    SlackStiffness
    stiffness(const Modes::Vector &E) const;

    /** The sum of the thicknesses of all points. */
    double
    thickness() const;

    /** The sum over the slack ones, at each Gauss point. */
    std::array<double, Modes::n_gauss_points>
    slack_thickness(const Modes::Vector &E) const;

  private:
    std::vector<CordPoint> cords;
    bool                   with_twist;
  };
} // namespace Biface

#endif
