// SPDX-License-Identifier: LGPL-2.1-or-later

#include <biface/element/slack_cords.h>

namespace Biface
{
  using namespace dealii;
  using Modes::n_gauss_points;

  namespace
  {
    /** Call a function with each slack cord at each Gauss point: the number of
     * the point, the cord, and its strain. */
    template <typename Function>
    void
    for_slack_cords(const std::vector<CordPoint> &cords,
                    const Modes::Vector          &E,
                    const Function               &function)
    {
      for (unsigned int g = 0; g < n_gauss_points; ++g)
        {
          const Tensor<1, Resultants::n_tangential> strain =
            Modes::tangential_at_gauss_point(E, g);
          for (const CordPoint &cord : cords)
            {
              const double e = cord.direction * strain + cord.initial_strain;
              if (e < 0)
                function(g, cord, e);
            }
        }
    }
  } // namespace


  double
  SlackCords::energy(const Modes::Vector &E) const
  {
    double sum = 0;
    for_slack_cords(
      cords, E, [&](const unsigned int, const CordPoint &cord, const double e) {
        sum += cord.loss * cord.thickness * e * e / 2;
      });
    return sum / n_gauss_points;
  }


  Modes::Vector
  SlackCords::resultants(const Modes::Vector &E) const
  {
    std::array<Tensor<1, Resultants::n_tangential>, n_gauss_points> at_points;
    for_slack_cords(
      cords,
      E,
      [&](const unsigned int g, const CordPoint &cord, const double e) {
        at_points[g] += cord.loss * cord.thickness * e * cord.direction;
      });
    return Modes::from_gauss_points(at_points, with_twist);
  }


  SlackStiffness
  SlackCords::stiffness(const Modes::Vector &E) const
  {
    SlackStiffness result;
    for_slack_cords(
      cords, E, [&](const unsigned int g, const CordPoint &cord, const double) {
        result.any[g] = true;
        for (unsigned int i = 0; i < Resultants::n_tangential; ++i)
          for (unsigned int j = i; j < Resultants::n_tangential; ++j)
            result.at_points[g][i][j] += cord.loss * cord.thickness *
                                         cord.direction[i] * cord.direction[j];
      });
    return result;
  }


  double
  SlackCords::thickness() const
  {
    double sum = 0;
    for (const CordPoint &cord : cords)
      sum += cord.thickness;
    return sum;
  }


  std::array<double, n_gauss_points>
  SlackCords::slack_thickness(const Modes::Vector &E) const
  {
    std::array<double, n_gauss_points> sums{};
    for_slack_cords(
      cords, E, [&](const unsigned int g, const CordPoint &cord, const double) {
        sums[g] += cord.thickness;
      });
    return sums;
  }
} // namespace Biface
