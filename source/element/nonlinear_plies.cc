// SPDX-License-Identifier: LGPL-2.1-or-later

#include <algorithm>

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


  namespace
  {
    using AtPoints = std::array<Resultants::Vector, n_gauss_points>;

    AtPoints
    at_gauss_points(const Modes::Vector &E)
    {
      AtPoints strains;
      for (unsigned int g = 0; g < n_gauss_points; ++g)
        strains[g] = Modes::at_gauss_point(E, g);
      return strains;
    }
  } // namespace


  double
  NonlinearPlies::energy(const Modes::Vector &E) const
  {
    const AtPoints strains = at_gauss_points(E);
    double         sum     = 0;
    if (points)
      {
        const auto state = points->thickness_state(strains);
        for (unsigned int g = 0; g < n_gauss_points; ++g)
          sum += points->energy(strains[g], state, g);
      }
    for (const Resultants::Vector &strain : strains)
      for (const CordPoint &cord : cords)
        sum += cord.thickness *
               cord.law->response(strain_along(cord, strain)).energy;
    return sum / n_gauss_points;
  }


  Modes::Vector
  NonlinearPlies::resultants(const Modes::Vector &E) const
  {
    const AtPoints strains = at_gauss_points(E);
    AtPoints       at_points;
    if (points)
      {
        const auto          state = points->thickness_state(strains);
        PlyPoints::Response response;
        for (unsigned int g = 0; g < n_gauss_points; ++g)
          {
            points->respond(strains[g], state, g, false, response);
            at_points[g] = response.H;
          }
      }
    for (unsigned int g = 0; g < n_gauss_points; ++g)
      for (const CordPoint &cord : cords)
        {
          const double stress =
            cord.law->response(strain_along(cord, strains[g])).stress;
          for (unsigned int s = 0; s < Resultants::n_tangential; ++s)
            at_points[g][s] += cord.thickness * stress * cord.direction[s];
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
    const AtPoints                                 strains = at_gauss_points(E);
    AtPoints                                       at_points;
    std::array<Resultants::Matrix, n_gauss_points> C;
    std::array<bool, n_gauss_points>               any{};

    if (points)
      {
        // how the thickness stress changes by the modes
        std::array<double, Modes::n> f{};
        double                       compliance = 0;
        const auto                   state = points->thickness_state(strains);
        PlyPoints::Response          response;
        for (unsigned int g = 0; g < n_gauss_points; ++g)
          {
            points->respond(strains[g], state, g, true, response);
            at_points[g] = response.H;
            C[g]         = response.C;
            any[g]       = true;
            Modes::for_parts_at_gauss_point(g,
                                            with_twist,
                                            [&](const unsigned int m,
                                                const unsigned int s,
                                                const double       value) {
                                              f[m] += value * response.f[s] /
                                                      n_gauss_points;
                                            });
            compliance += response.compliance / n_gauss_points;
          }
        for (unsigned int m = 0; m < Modes::n; ++m)
          for (unsigned int n = 0; n < Modes::n; ++n)
            result[m][n] += f[m] * f[n] / compliance;
      }

    for (unsigned int g = 0; g < n_gauss_points; ++g)
      {
        for (const CordPoint &cord : cords)
          {
            const auto at = cord.law->response(strain_along(cord, strains[g]));
            for (unsigned int s = 0; s < Resultants::n_tangential; ++s)
              at_points[g][s] += cord.thickness * at.stress * cord.direction[s];
            if (at.modulus == 0)
              continue;
            any[g] = true;
            for (unsigned int s = 0; s < Resultants::n_tangential; ++s)
              for (unsigned int t = 0; t < Resultants::n_tangential; ++t)
                C[g][s][t] += cord.thickness * at.modulus * cord.direction[s] *
                              cord.direction[t];
          }
        if (!any[g])
          continue;

        // C times the modes, then the modes times that
        std::array<std::array<double, Modes::n>, Resultants::n> by_mode{};
        Modes::for_parts_at_gauss_point(
          g,
          with_twist,
          [&](const unsigned int m, const unsigned int s, const double value) {
            for (unsigned int t = 0; t < Resultants::n; ++t)
              by_mode[t][m] += value / n_gauss_points * C[g][t][s];
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
    return std::any_of(
      any.begin(), any.end(), [](const bool here) { return here; });
  }


  std::array<Resultants::Vector, 4>
  NonlinearPlies::strains_at_vertices(const Modes::Vector &E) const
  {
    auto strains = Modes::at_vertices(E);
    if (points)
      {
        const auto H = Modes::at_vertices(resultants(E));
        for (unsigned int v = 0; v < 4; ++v)
          strains[v][Resultants::thickness] = points->thickness_strain(
            strains[v], H[v][Resultants::thickness] / points->get_thickness());
      }
    return strains;
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
