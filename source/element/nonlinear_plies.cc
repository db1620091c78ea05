// SPDX-License-Identifier: LGPL-2.1-or-later

#include <biface/element/nonlinear_plies.h>

namespace Biface
{
  using namespace dealii;
  using Modes::n_gauss_points;

  namespace
  {
    double
    strain_along(const CordPoint &cord, const Resultants::Vector &E)
    {
      double e = 0;
      for (unsigned int s = 0; s < Resultants::n_tangential; ++s)
        e += cord.direction[s] * E[s];
      return e;
    }
  } // namespace


  double
  NonlinearPlies::energy(const Modes::Vector &E) const
  {
    double sum = 0;
    for (unsigned int g = 0; g < n_gauss_points; ++g)
      {
        const Resultants::Vector strain = Modes::at_gauss_point(E, g);
        if (points)
          sum += points->energy(strain);
        for (const CordPoint &cord : cords)
          sum += cord.thickness *
                 cord.law->response(strain_along(cord, strain)).energy;
      }
    return sum / n_gauss_points;
  }


  Modes::Vector
  NonlinearPlies::resultants(const Modes::Vector &E) const
  {
    std::array<Resultants::Vector, n_gauss_points> at_points;
    for (unsigned int g = 0; g < n_gauss_points; ++g)
      {
        const Resultants::Vector strain = Modes::at_gauss_point(E, g);
        if (points)
          at_points[g] = points->resultants(strain);
        for (const CordPoint &cord : cords)
          {
            const double stress =
              cord.law->response(strain_along(cord, strain)).stress;
            for (unsigned int s = 0; s < Resultants::n_tangential; ++s)
              at_points[g][s] += cord.thickness * stress * cord.direction[s];
          }
      }
    return Modes::from_gauss_points(at_points, with_twist);
  }


  bool
  NonlinearPlies::stiffness(const Modes::Vector &E,
                            Stiffness           &result,
                            Modes::Vector       *resultants) const
  {
    for (auto &row : result)
      row.fill(0);
    std::array<Resultants::Vector, n_gauss_points> at_points;
    bool                                           any = false;
    for (unsigned int g = 0; g < n_gauss_points; ++g)
      {
        const Resultants::Vector strain = Modes::at_gauss_point(E, g);
        Resultants::Matrix       C;
        bool                     any_here = false;
        if (points)
          {
            at_points[g] = points->resultants(strain, &C);
            any_here     = true;
          }
        for (const CordPoint &cord : cords)
          {
            const auto at = cord.law->response(strain_along(cord, strain));
            for (unsigned int s = 0; s < Resultants::n_tangential; ++s)
              at_points[g][s] += cord.thickness * at.stress * cord.direction[s];
            if (at.modulus == 0)
              continue;
            any_here = true;
            for (unsigned int s = 0; s < Resultants::n_tangential; ++s)
              for (unsigned int t = 0; t < Resultants::n_tangential; ++t)
                C[s][t] += cord.thickness * at.modulus * cord.direction[s] *
                           cord.direction[t];
          }
        if (!any_here)
          continue;
        any = true;

        // C times the modes, then the modes times that
        std::array<std::array<double, Modes::n>, Resultants::n> by_mode{};
        Modes::for_parts_at_gauss_point(
          g,
          with_twist,
          [&](const unsigned int m, const unsigned int s, const double value) {
            for (unsigned int t = 0; t < Resultants::n; ++t)
              by_mode[t][m] += value / n_gauss_points * C[t][s];
          });
        Modes::for_parts_at_gauss_point(
          g,
          with_twist,
          [&](const unsigned int m, const unsigned int s, const double value) {
            for (unsigned int n = 0; n < Modes::n; ++n)
              result[m][n] += value * by_mode[s][n];
          });
      }
    if (resultants)
      *resultants = Modes::from_gauss_points(at_points, with_twist);
    return any;
  }


  Modes::Vector
  NonlinearPlies::product(const Stiffness &stiffness, const Modes::Vector &dE)
  {
    Modes::Vector dH;
    for (const Modes::Group &group : Modes::groups)
      for (unsigned int i = 0; i < group.size; ++i)
        {
          const unsigned int m = group.first_mode + i;
          for (unsigned int n = 0; n < Modes::n; ++n)
            dH[m] += stiffness[m][n] * dE[n];
          dH[m] /= group.weight(i);
        }
    return dH;
  }


  double
  NonlinearPlies::thickness_of_cords() const
  {
    double sum = 0;
    for (const CordPoint &cord : cords)
      sum += cord.thickness;
    return sum;
  }


  std::array<double, n_gauss_points>
  NonlinearPlies::slack_thickness(const Modes::Vector &E) const
  {
    std::array<double, n_gauss_points> sums{};
    for (unsigned int g = 0; g < n_gauss_points; ++g)
      {
        const Resultants::Vector strain = Modes::at_gauss_point(E, g);
        for (const CordPoint &cord : cords)
          if (cord.law->is_slack(strain_along(cord, strain)))
            sums[g] += cord.thickness;
      }
    return sums;
  }
} // namespace Biface
