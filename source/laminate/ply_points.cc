// SPDX-License-Identifier: LGPL-2.1-or-later

#include <algorithm>
#include <cmath>
#include <utility>

#include <biface/laminate/ply_points.h>

namespace Biface
{
  using namespace dealii;

  namespace
  {
    constexpr unsigned int max_thickness_steps = 50;
    /** Of Newton's method for strains, which converges quadratically. */
    constexpr double small_change = 1e-9;


    /** Change a strain, but not beyond its lowest value. */
    void
    change(double &strain, const double by, const double lowest)
    {
      strain = strain + by > lowest ? strain + by : (strain + lowest) / 2;
    }
  } // namespace


  PointStrains::Vector
  PlyPoints::Point::strain(const Resultants::Vector &E) const
  {
    PointStrains::Vector e;
    for (unsigned int p = 0; p < 2; ++p)
      {
        for (unsigned int ab = 0; ab < 3; ++ab)
          e[ab] += tangential[ab][p] * E[Resultants::tangential(ab, p)];
        for (unsigned int a = 0; a < 2; ++a)
          for (unsigned int c = 0; c < 2; ++c)
            e[PointStrains::transverse(a)] +=
              shear[p][a][c] * E[Resultants::transverse(c, p)];
      }
    return e;
  }


  PlyPoints::PlyPoints(std::vector<Point>        points,
                       const double              thickness,
                       const Resultants::Matrix &remainder,
                       const bool                along_normal)
    : points(std::move(points))
    , thickness(thickness)
    , remainder(remainder)
    , along_normal(along_normal)
  {}


  namespace
  {
    /** The mean of the shear strains a3 of both faces. */
    double
    mean_shear(const Resultants::Vector &E, const unsigned int a)
    {
      return (E[Resultants::transverse(a, 0)] +
              E[Resultants::transverse(a, 1)]) /
             2;
    }
  } // namespace


  double
  PlyPoints::director_strain(const Resultants::Vector &E) const
  {
    double strain = E[Resultants::thickness];
    if (along_normal)
      for (unsigned int a = 0; a < 2; ++a)
        strain += mean_shear(E, a) * mean_shear(E, a) / 2;
    return strain;
  }


  PlyPoints::ThicknessState
  PlyPoints::thickness_state(const Resultants::Vector &E) const
  {
    const unsigned int                n = points.size();
    std::vector<PointStrains::Vector> strains(n);
    std::vector<double>               lowest(n);
    for (unsigned int k = 0; k < n; ++k)
      {
        strains[k] = points[k].strain(E);
        lowest[k]  = points[k].law->lowest_thickness_strain(strains[k]);
        strains[k][PointStrains::thickness] =
          points[k].law->free_thickness_strain(strains[k]);
      }

    std::vector<MaterialLaw::ThicknessStress> at(n);
    ThicknessState                            result{PointStrains::none, {}};
    double                                    largest = 1;
    for (unsigned int step = 0; largest > small_change; ++step)
      {
        double lacking = thickness * director_strain(E), compliance = 0;
        for (unsigned int k = 0; k < n; ++k)
          {
            at[k] = points[k].law->thickness_stress(strains[k]);
            lacking +=
              points[k].thickness * (at[k].stress / at[k].modulus -
                                     strains[k][PointStrains::thickness]);
            compliance +=
              points[k].thickness / (points[k].area * at[k].modulus);
            if (!(at[k].modulus > 0 && step < max_thickness_steps))
              {
                result.strains.assign(n, PointStrains::none);
                return result;
              }
          }
        result.stress = lacking / compliance;
        largest       = 0;
        for (unsigned int k = 0; k < n; ++k)
          {
            double      &e = strains[k][PointStrains::thickness];
            const double by =
              (result.stress / points[k].area - at[k].stress) / at[k].modulus;
            change(e, by, lowest[k]);
            largest = std::max(largest, std::abs(by));
          }
      }
    for (unsigned int k = 0; k < n; ++k)
      result.strains.push_back(strains[k][PointStrains::thickness]);
    return result;
  }


  double
  PlyPoints::energy(const Resultants::Vector &E) const
  {
    const ThicknessState state = thickness_state(E);
    double               sum   = E * (remainder * E) / 2;
    for (unsigned int k = 0; k < points.size(); ++k)
      {
        PointStrains::Vector strain     = points[k].strain(E);
        strain[PointStrains::thickness] = state.strains[k];
        sum +=
          points[k].thickness * points[k].area * points[k].law->energy(strain);
      }
    return sum;
  }


  Resultants::Vector
  PlyPoints::resultants(const Resultants::Vector &E,
                        Resultants::Matrix       *stiffness) const
  {
    using PointStrains::transverse;
    constexpr unsigned int n_others = PointStrains::thickness;

    const ThicknessState state = thickness_state(E);
    Resultants::Vector   H     = remainder * E;
    H[Resultants::thickness] += thickness * state.stress;

    // the sum of t L^T f, and of t/(m b_3333)
    Resultants::Vector f;
    double             compliance = 0;
    if (stiffness)
      *stiffness = remainder;
    for (unsigned int k = 0; k < points.size(); ++k)
      {
        const Point         &point      = points[k];
        PointStrains::Vector strain     = point.strain(E);
        strain[PointStrains::thickness] = state.strains[k];
        PointStrains::Vector S;
        PointStrains::Matrix b;
        point.law->evaluate(strain, S, b);

        const double weight = point.thickness * point.area;
        for (unsigned int p = 0; p < 2; ++p)
          {
            for (unsigned int ab = 0; ab < 3; ++ab)
              H[Resultants::tangential(ab, p)] +=
                weight * point.tangential[ab][p] * S[ab];
            for (unsigned int c = 0; c < 2; ++c)
              for (unsigned int a = 0; a < 2; ++a)
                H[Resultants::transverse(c, p)] +=
                  weight * point.shear[p][a][c] * S[transverse(a)];
          }
        if (!stiffness)
          continue;

        // the moduli at constant thickness stress, and their product with L
        const PointStrains::Vector &b_3    = b[PointStrains::thickness];
        const double                b_3333 = b_3[PointStrains::thickness];
        compliance += point.thickness / (point.area * b_3333);
        std::array<Resultants::Vector, n_others> qL;
        std::array<double, n_others>             by_stress;
        for (unsigned int i = 0; i < n_others; ++i)
          {
            by_stress[i]       = b_3[i] / b_3333;
            const auto modulus = [&](const unsigned int j) {
              return b[i][j] - by_stress[i] * b_3[j];
            };
            for (unsigned int p = 0; p < 2; ++p)
              {
                for (unsigned int cd = 0; cd < 3; ++cd)
                  qL[i][Resultants::tangential(cd, p)] =
                    weight * modulus(cd) * point.tangential[cd][p];
                for (unsigned int c = 0; c < 2; ++c)
                  qL[i][Resultants::transverse(c, p)] =
                    weight * (modulus(transverse(0)) * point.shear[p][0][c] +
                              modulus(transverse(1)) * point.shear[p][1][c]);
              }
          }
        for (unsigned int p = 0; p < 2; ++p)
          {
            for (unsigned int ab = 0; ab < 3; ++ab)
              {
                const unsigned int s = Resultants::tangential(ab, p);
                f[s] +=
                  point.thickness * point.tangential[ab][p] * by_stress[ab];
                (*stiffness)[s] += point.tangential[ab][p] * qL[ab];
              }
            for (unsigned int c = 0; c < 2; ++c)
              for (unsigned int a = 0; a < 2; ++a)
                {
                  const unsigned int s = Resultants::transverse(c, p);
                  f[s] += point.thickness * point.shear[p][a][c] *
                          by_stress[transverse(a)];
                  (*stiffness)[s] += point.shear[p][a][c] * qL[transverse(a)];
                }
          }
      }
    if (stiffness)
      {
        // the thickness strain and f change the thickness stress
        f[Resultants::thickness] = thickness;
        for (unsigned int s = 0; s < Resultants::n; ++s)
          for (unsigned int t = 0; t < Resultants::n; ++t)
            (*stiffness)[s][t] += f[s] * f[t] / compliance;
      }
    if (along_normal)
      {
        // the derivatives of the strain of the director
        const double                H_33 = H[Resultants::thickness];
        std::array<unsigned int, 4> shear;
        std::array<double, 4>       factor;
        for (unsigned int a = 0; a < 2; ++a)
          for (unsigned int p = 0; p < 2; ++p)
            {
              shear[2 * a + p]  = Resultants::transverse(a, p);
              factor[2 * a + p] = mean_shear(E, a) / 2;
            }
        for (unsigned int i = 0; i < 4; ++i)
          H[shear[i]] += factor[i] * H_33;
        if (stiffness)
          {
            Resultants::Matrix &C = *stiffness;
            for (unsigned int i = 0; i < 4; ++i)
              for (unsigned int s = 0; s < Resultants::n; ++s)
                C[s][shear[i]] += factor[i] * C[s][Resultants::thickness];
            for (unsigned int i = 0; i < 4; ++i)
              C[shear[i]] += factor[i] * C[Resultants::thickness];
            for (unsigned int i = 0; i < 4; ++i)
              for (unsigned int j = 0; j < 4; ++j)
                if (i / 2 == j / 2)
                  C[shear[i]][shear[j]] += H_33 / 4;
          }
      }
    return H;
  }


  double
  thickness_strain(const MaterialLaw   &law,
                   PointStrains::Vector strain,
                   const double         stress)
  {
    double      &e      = strain[PointStrains::thickness];
    const double lowest = law.lowest_thickness_strain(strain);
    e                   = law.free_thickness_strain(strain);
    for (unsigned int step = 0; step < max_thickness_steps; ++step)
      {
        const auto   at = law.thickness_stress(strain);
        const double by = (stress - at.stress) / at.modulus;
        if (!(at.modulus > 0))
          return PointStrains::none;
        change(e, by, lowest);
        if (std::abs(by) <= small_change)
          return e;
      }
    return PointStrains::none;
  }
} // namespace Biface
