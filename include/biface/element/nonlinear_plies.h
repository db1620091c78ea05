// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_element_nonlinear_plies_h
#define biface_element_nonlinear_plies_h

#include <array>
#include <memory>
#include <vector>

#include <biface/element/modes.h>
#include <biface/laminate/laminate.h>

namespace Biface
{
  /**
   * What plies that are not linear add to the resultants of ModeStiffness: that
   * of PlyPoints and that of cords.
   *
   * The points of PlyPoints have one thickness stress in the whole element,
   * which follows from the constant mode of the thickness strain; otherwise
   * nearly incompressible layers, which are stretched where a stack of them
   * bends, would lock. Beside them the other modes of the thickness strain have
   * a linear stiffness, see ModeStiffness::keep_varying_thickness_strain().
   *
   * The strains of the modes are evaluated at the 2x2 Gauss points of the
   * element, each with its own law. These points integrate products of modes
   * exactly, so that the energy of an element is
   * @f[
   *   w\Bigl(\tfrac12\sum_m w_m\,E_m\,(\mathbf D\mathbf E)_m
   *   +\sum_{g=1}^4\tfrac14\,\psi(\mathbf E_g)\Bigr) .
   * @f]
   * With one law per element, or with those at the vertices, the forces would
   * have no energy: modes are no sums over the vertices with the weights of the
   * energy.
   */
  class NonlinearPlies
  {
  public:
    /** The derivative of resultants() by the strains, the rows times the
     * weights of their modes: symmetric. Unit: force/length. */
    using Stiffness = std::array<std::array<double, Modes::n>, Modes::n>;

    /** @param sampling the set of strain modes. */
    explicit NonlinearPlies(
      const Laminate      &laminate,
      const StrainSampling sampling = StrainSampling::vertices)
      : points(laminate.ply_points())
      , cords(laminate.cord_points())
      , with_twist(sampling == StrainSampling::means)
    {}

    /** Whether all plies are linear. */
    bool
    empty() const
    {
      return !points && cords.empty();
    }

    /** Whether there are PlyPoints. */
    bool
    is_whole_law() const
    {
      return points != nullptr;
    }

    /** The energy per area.
     * @param E the modes of all strains, including initial ones. */
    double
    energy(const Modes::Vector &E) const;

    /** Its derivative. */
    Modes::Vector
    resultants(const Modes::Vector &E) const;

    /** The second derivative.
     * @param resultants set to them, unless null.
     * @return whether it is not zero. */
    bool
    stiffness(const Modes::Vector &E,
              Stiffness           &result,
              Modes::Vector       *resultants = nullptr) const;

    /** The change of the resultants with that of the strains. */
    static Modes::Vector
    product(const Stiffness &stiffness, const Modes::Vector &dE);

    /** The strains at the vertices, where the thickness strain is the one that
     * belongs to the thickness stress of the element, if they are the whole
     * law. */
    std::array<Resultants::Vector, 4>
    strains_at_vertices(const Modes::Vector &E) const;

    /** The sum of the thicknesses of all points of cords. */
    double
    thickness_of_cords() const;

    /** The sum over the slack ones, at each Gauss point. */
    std::array<double, Modes::n_gauss_points>
    slack_thickness(const Modes::Vector &E) const;

  private:
    std::shared_ptr<const PlyPoints> points;
    std::vector<CordPoint>           cords;
    bool                             with_twist;
  };
} // namespace Biface

#endif
