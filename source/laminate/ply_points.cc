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
    /** See relative(): of Newton's method, which converges quadratically. */
    constexpr double small_change = 1e-9;


    void
    relax(const Relaxed<PointStrains::Vector> &relaxed,
          MaterialLaw::ThicknessStress        &at)
    {
      // the law of a point within a step is linear in the elastic stress, so
      // that its tangent has the same factor
      at.stress =
        relaxed.factor * at.stress + relaxed.stress[PointStrains::thickness];
      at.modulus *= relaxed.factor;
    }


    bool
    can_approach(const PointStrains::Vector &strain, const double lowest)
    {
      return std::isfinite(lowest) && strain[PointStrains::thickness] > lowest;
    }


    /** Reduce a strain toward its lowest value. */
    void
    approach(PointStrains::Vector &strain, const double lowest)
    {
      // halfway, so that no number of steps reaches the lowest strain itself
      double &e = strain[PointStrains::thickness];
      e         = (e + lowest) / 2;
    }


    /** A change of a strain, relative to the square of the stretch. */
    double
    relative(const double by, const double strain)
    {
      return std::abs(by / (1 + 2 * strain));
    }


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


  void
  PlyPoints::Point::add_resultants(const PointStrains::Vector &S,
                                   Resultants::Vector         &H) const
  {
    // the transpose of what strain() does, so that the work of the resultants
    // is that of the stresses
    const double weight = thickness * area;
    for (unsigned int p = 0; p < 2; ++p)
      {
        for (unsigned int ab = 0; ab < 3; ++ab)
          H[Resultants::tangential(ab, p)] +=
            weight * tangential[ab][p] * S[ab];
        for (unsigned int c = 0; c < 2; ++c)
          for (unsigned int a = 0; a < 2; ++a)
            H[Resultants::transverse(c, p)] +=
              weight * shear[p][a][c] * S[PointStrains::transverse(a)];
      }
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
    // E has the distance of the faces along the normal, the points the length
    // of the director, which leans where it is sheared
    double strain = E[Resultants::thickness];
    if (along_normal)
      for (unsigned int a = 0; a < 2; ++a)
        strain += mean_shear(E, a) * mean_shear(E, a) / 2;
    return strain;
  }


  PlyPoints::ThicknessState
  PlyPoints::thickness_state(const Places        &places,
                             const RelaxedPoints &relaxed) const
  {
    const unsigned int                n = places.size() * points.size();
    std::vector<PointStrains::Vector> strains(n);
    std::vector<double>               lowest(n);
    double                            given = 0;
    for (unsigned int i = 0; i < places.size(); ++i)
      {
        given += thickness * director_strain(places[i]);
        for (unsigned int k = 0; k < points.size(); ++k)
          {
            PointStrains::Vector &e = strains[i * points.size() + k];
            e                       = points[k].strain(places[i]);
            lowest[i * points.size() + k] =
              points[k].law->lowest_thickness_strain(e);
            e[PointStrains::thickness] =
              points[k].law->free_thickness_strain(e);
          }
      }

    // Newton's method for the strains of all points and their common stress
    // (section 4 of doc/theory.md, "Rubber at large strains"): eliminated point
    // by point, the strains leave one equation for the stress.
    std::vector<MaterialLaw::ThicknessStress> at(n);
    ThicknessState                            result{PointStrains::none, {}};
    double                                    largest = 1;
    for (unsigned int step = 0; largest > small_change; ++step)
      {
        double lacking = given, compliance = 0;
        for (unsigned int k = 0; k < n; ++k)
          {
            const Point &point = points[k % points.size()];
            at[k]              = point.law->thickness_stress(strains[k]);
            if (relaxed.size() > 0)
              relax(relaxed[k], at[k]);
            lacking += point.thickness * (at[k].stress / at[k].modulus -
                                          strains[k][PointStrains::thickness]);
            compliance += point.thickness / (point.area * at[k].modulus);
            if (!(at[k].modulus > 0 || can_approach(strains[k], lowest[k])) ||
                step == max_thickness_steps)
              {
                result.strains.assign(n, PointStrains::none);
                return result;
              }
          }
        // where the stress does not rise with the strain, that is too large
        bool rises = true;
        for (unsigned int k = 0; k < n; ++k)
          if (!(at[k].modulus > 0))
            {
              approach(strains[k], lowest[k]);
              rises = false;
            }
        if (!rises)
          continue;
        result.stress = lacking / compliance;
        largest       = 0;
        for (unsigned int k = 0; k < n; ++k)
          {
            const double by =
              (result.stress / points[k % points.size()].area - at[k].stress) /
              at[k].modulus;
            largest = std::max(
              largest, relative(by, strains[k][PointStrains::thickness]));
            change(strains[k][PointStrains::thickness], by, lowest[k]);
          }
      }
    for (unsigned int k = 0; k < n; ++k)
      result.strains.push_back(strains[k][PointStrains::thickness]);
    return result;
  }


  double
  PlyPoints::thickness_strain(const Resultants::Vector &E,
                              const RelaxedPoints      &relaxed,
                              const double              stress) const
  {
    Resultants::Vector others     = E;
    others[Resultants::thickness] = 0;
    double strain                 = -director_strain(others);
    for (unsigned int k = 0; k < points.size(); ++k)
      strain += points[k].thickness / thickness *
                Biface::thickness_strain(*points[k].law,
                                         relaxed.size() > 0
                                           ? relaxed[k]
                                           : Relaxed<PointStrains::Vector>(),
                                         points[k].strain(E),
                                         stress / points[k].area);
    return strain;
  }


  double
  PlyPoints::energy(const Resultants::Vector &E,
                    const RelaxedPoints      &relaxed,
                    const ThicknessState     &state,
                    const unsigned int        number) const
  {
    double sum = E * (remainder * E) / 2;
    for (unsigned int k = 0; k < points.size(); ++k)
      {
        const PointStrains::Vector at_point = strain(E, state, number, k);
        double                     energy   = points[k].law->energy(at_point);
        if (relaxed.size() > 0)
          {
            const auto &at = relaxed[number * points.size() + k];
            energy         = at.factor * energy + at.stress * at_point;
          }
        sum += points[k].thickness * points[k].area * energy;
      }
    return sum;
  }


  void
  PlyPoints::respond(const Resultants::Vector &E,
                     const RelaxedPoints      &relaxed,
                     const ThicknessState     &state,
                     const unsigned int        number,
                     const bool                with_changes,
                     Response                 &response) const
  {
    using PointStrains::transverse;
    constexpr unsigned int n_others = PointStrains::thickness;

    Resultants::Vector &H = response.H, &f = response.f;
    const double        H_33 = thickness * state.stress;
    H                        = remainder * E;
    H[Resultants::thickness] += H_33;
    if (with_changes)
      {
        f                        = Resultants::Vector();
        f[Resultants::thickness] = thickness;
        response.C               = remainder;
        response.compliance      = 0;
      }
    if (along_normal)
      for (unsigned int a = 0; a < 2; ++a)
        for (unsigned int p = 0; p < 2; ++p)
          {
            // the derivative of the strain of the director
            const unsigned int s    = Resultants::transverse(a, p);
            const double       lean = mean_shear(E, a) / 2;
            H[s] += lean * H_33;
            if (with_changes)
              {
                f[s] += lean * thickness;
                for (unsigned int q = 0; q < 2; ++q)
                  response.C[s][Resultants::transverse(a, q)] += H_33 / 4;
              }
          }

    for (unsigned int k = 0; k < points.size(); ++k)
      {
        const Point         &point = points[k];
        PointStrains::Vector S;
        PointStrains::Matrix b;
        point.law->evaluate(strain(E, state, number, k), S, b);
        if (relaxed.size() > 0)
          {
            const auto &at = relaxed[number * points.size() + k];
            S              = at.factor * S + at.stress;
            b *= at.factor;
          }

        const double weight = point.thickness * point.area;
        point.add_resultants(S, H);
        if (!with_changes)
          continue;

        // the moduli at constant thickness stress, and their product with L
        const PointStrains::Vector &b_3    = b[PointStrains::thickness];
        const double                b_3333 = b_3[PointStrains::thickness];
        response.compliance += point.thickness / (point.area * b_3333);
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
                response.C[s] += point.tangential[ab][p] * qL[ab];
              }
            for (unsigned int c = 0; c < 2; ++c)
              for (unsigned int a = 0; a < 2; ++a)
                {
                  const unsigned int s = Resultants::transverse(c, p);
                  f[s] += point.thickness * point.shear[p][a][c] *
                          by_stress[transverse(a)];
                  response.C[s] += point.shear[p][a][c] * qL[transverse(a)];
                }
          }
      }
  }


  PlyPoints::Changes::Changes(const PlyPoints      &plies,
                              const Places         &places,
                              const RelaxedPoints  &relaxed,
                              const ThicknessState &state)
    : plies(plies)
  {
    for (unsigned int i = 0; i < places.size(); ++i)
      {
        lean.emplace_back();
        if (plies.along_normal)
          for (unsigned int a = 0; a < 2; ++a)
            lean.back()[a] = mean_shear(places[i], a);
        for (unsigned int k = 0; k < plies.points.size(); ++k)
          {
            const Point         &point = plies.points[k];
            PointStrains::Vector S;
            moduli.emplace_back();
            point.law->evaluate(
              plies.strain(places[i], state, i, k), S, moduli.back());
            factors.push_back(
              relaxed.size() > 0 ? relaxed[factors.size()].factor : 1.);
            compliance +=
              point.thickness / (point.area * modulus_33(moduli.size() - 1));
          }
      }
  }


  void
  PlyPoints::Changes::elastic_stresses(
    const Places                            &strains,
    const std::vector<PointStrains::Vector> &added,
    std::vector<PointStrains::Vector>       &stresses) const
  {
    const unsigned int                n_points = plies.points.size();
    std::vector<PointStrains::Vector> e(moduli.size());
    double                            lacking = 0;
    for (unsigned int i = 0; i < strains.size(); ++i)
      {
        double director = strains[i][Resultants::thickness];
        for (unsigned int a = 0; a < 2; ++a)
          director += lean[i][a] * mean_shear(strains[i], a);
        lacking += plies.thickness * director;
        for (unsigned int k = i * n_points; k < (i + 1) * n_points; ++k)
          {
            const Point &point = plies.points[k - i * n_points];
            e[k]               = point.strain(strains[i]);
            e[k][PointStrains::thickness] =
              -(factors[k] * (moduli[k][PointStrains::thickness] * e[k]) +
                added[k][PointStrains::thickness]) /
              modulus_33(k);
            lacking -= point.thickness * e[k][PointStrains::thickness];
          }
      }
    // first each point with its thickness stress held, then the change of the
    // common one that makes their strains add up to that of the director
    const double by_stress = lacking / compliance;
    stresses.resize(moduli.size());
    for (unsigned int k = 0; k < moduli.size(); ++k)
      {
        e[k][PointStrains::thickness] +=
          by_stress / (plies.points[k % n_points].area * modulus_33(k));
        stresses[k] = moduli[k] * e[k];
      }
  }


  void
  PlyPoints::Changes::resultants(
    const std::vector<PointStrains::Vector> &added,
    const ArrayView<Resultants::Vector>     &resultants) const
  {
    const unsigned int n_points = plies.points.size();
    double             sum      = 0;
    for (unsigned int k = 0; k < moduli.size(); ++k)
      sum += plies.points[k % n_points].thickness *
             added[k][PointStrains::thickness] / modulus_33(k);
    // the director is held: what some points yield others take up, under a
    // common thickness stress
    const double by_stress = sum / compliance;
    for (unsigned int i = 0; i < resultants.size(); ++i)
      {
        Resultants::Vector &H    = resultants[i];
        H                        = Resultants::Vector();
        H[Resultants::thickness] = plies.thickness * by_stress;
        for (unsigned int a = 0; a < 2; ++a)
          for (unsigned int p = 0; p < 2; ++p)
            H[Resultants::transverse(a, p)] +=
              lean[i][a] / 2 * plies.thickness * by_stress;
        for (unsigned int k = i * n_points; k < (i + 1) * n_points; ++k)
          {
            const Point &point = plies.points[k - i * n_points];
            // of the thickness strain
            const double change =
              (by_stress / point.area - added[k][PointStrains::thickness]) /
              modulus_33(k);
            const PointStrains::Vector S =
              added[k] +
              factors[k] * change * moduli[k][PointStrains::thickness];
            point.add_resultants(S, H);
          }
      }
  }


  double
  thickness_strain(const MaterialLaw                   &law,
                   const Relaxed<PointStrains::Vector> &relaxed,
                   PointStrains::Vector                 strain,
                   const double                         stress)
  {
    double      &e      = strain[PointStrains::thickness];
    const double lowest = law.lowest_thickness_strain(strain);
    e                   = law.free_thickness_strain(strain);
    for (unsigned int step = 0; step < max_thickness_steps; ++step)
      {
        auto at = law.thickness_stress(strain);
        relax(relaxed, at);
        if (!(at.modulus > 0))
          {
            if (!can_approach(strain, lowest))
              return PointStrains::none;
            approach(strain, lowest);
            continue;
          }
        const double by   = (stress - at.stress) / at.modulus;
        const double size = relative(by, e);
        change(e, by, lowest);
        if (size <= small_change)
          return e;
      }
    return PointStrains::none;
  }
} // namespace Biface
