// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/quadrature_lib.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include <biface/laminate/cord_law.h>
#include <biface/laminate/laminate.h>
#include <biface/laminate/material.h>

namespace Biface
{
  using namespace dealii;

  namespace
  {
    std::vector<SymmetricTensor<4, 3>>
    rotated_stiffnesses(const std::vector<Ply> &plies)
    {
      std::vector<SymmetricTensor<4, 3>> stiffnesses;
      for (const Ply &ply : plies)
        stiffnesses.push_back(
          rotate_about_normal(ply.laws.stiffness, ply.angle));
      return stiffnesses;
    }


    std::vector<double>
    thicknesses(const std::vector<Ply> &plies)
    {
      std::vector<double> values;
      for (const Ply &ply : plies)
        values.push_back(ply.thickness);
      return values;
    }


    /** The direction of the cords, in terms of the tangential strains 11, 22,
     * 2*12: their strain is the scalar product. */
    std::array<double, 3>
    cord_direction(const double angle)
    {
      const double c = std::cos(angle), s = std::sin(angle);
      return {{c * c, s * s, c * s}};
    }


    TransverseShear::FaceStrains
    transverse_strains(const Resultants::Vector &E)
    {
      TransverseShear::FaceStrains strains;
      for (unsigned int face = 0; face < 2; ++face)
        for (unsigned int a = 0; a < 2; ++a)
          strains[face][a] = E[Resultants::transverse(a, face)];
      return strains;
    }
  } // namespace


  StrainsOfPlies
  mean(const std::array<StrainsOfPlies, 4> &at_vertices)
  {
    StrainsOfPlies result = at_vertices[0];
    result.E              = Resultants::Vector();
    const auto set_mean   = [&](auto member) {
      for (unsigned int k = 0; k < (result.*member).size(); ++k)
        {
          auto &value  = (result.*member)[k];
          value.stress = {};
          for (const StrainsOfPlies &at : at_vertices)
            value.stress += 0.25 * (at.*member)[k].stress;
        }
    };
    set_mean(&StrainsOfPlies::points);
    set_mean(&StrainsOfPlies::cords);
    for (const StrainsOfPlies &at : at_vertices)
      result.E += at.E / 4.;
    return result;
  }


  Laminate::Laminate(std::vector<Ply>             plies,
                     const ThicknessLaw           law,
                     const double                 reference_height,
                     const TransverseShearLaw    &shear_law,
                     const std::array<double, 2> &curvature,
                     const WallOfLayer           &wall,
                     const bool                   along_normal)
    : plies(std::move(plies))
    , rotated(rotated_stiffnesses(this->plies))
    , law(law)
    , functions(thickness(), reference_height, curvature)
    , transverse_shear(shear_law, thicknesses(this->plies), rotated, wall)
    , along_normal(along_normal)
    , D(integrate_stiffness())
  {
    if (std::any_of(this->plies.begin(), this->plies.end(), [](const Ply &ply) {
          return ply.laws.rubber || ply.laws.relaxation;
        }))
      set_points();
  }


  Laminate
  Laminate::with_plies(std::vector<Ply> other) const
  {
    return Laminate(std::move(other),
                    law,
                    functions.reference_height,
                    transverse_shear.get_law(),
                    functions.curvature,
                    transverse_shear.get_wall(),
                    along_normal);
  }


  double
  Laminate::thickness() const
  {
    double h = 0;
    for (const Ply &ply : plies)
      h += ply.thickness;
    return h;
  }


  double
  Laminate::thickness_stiffness() const
  {
    // springs in series, as the plies of a wall that is free to spread carry
    // the same thickness stress
    double compliance = 0;
    for (const Ply &ply : plies)
      compliance += ply.thickness * invert(ply.laws.stiffness)[2][2][2][2];
    return 1 / compliance;
  }


  double
  Laminate::membrane_stiffness() const
  {
    double stiffness = 0;
    for (const Ply &ply : plies)
      stiffness += ply.thickness * std::max(ply.laws.stiffness[0][0][0][0],
                                            ply.laws.stiffness[1][1][1][1]);
    return stiffness;
  }


  std::array<std::array<double, 2>, 2>
  Laminate::stiffness_along(const unsigned int a) const
  {
    std::array<std::array<double, 2>, 2> stiffness{};
    double                               z = 0;
    for (unsigned int k = 0; k < plies.size(); ++k)
      {
        const SymmetricTensor<4, 3> &b = rotated[k];
        const double                 modulus =
          b[a][a][a][a] - b[a][a][2][2] * b[2][2][a][a] / b[2][2][2][2];
        const StrainMoments moments(functions, z, z + plies[k].thickness);
        for (unsigned int p = 0; p < 2; ++p)
          for (unsigned int q = 0; q < 2; ++q)
            stiffness[p][q] += modulus * moments.second[a][a][p][q];
        z += plies[k].thickness;
      }
    return stiffness;
  }


  std::array<double, 2>
  Laminate::face_heights() const
  {
    return {{-functions.reference_height,
             functions.thickness - functions.reference_height}};
  }


  bool
  Laminate::is_symmetric() const
  {
    return law != ThicknessLaw::asymmetric;
  }


  Resultants::Matrix
  Laminate::integrate_stiffness() const
  {
    using namespace Resultants;

    const double h = thickness();
    Matrix       D;
    // f_ab^p and A of the symmetric law
    std::array<std::array<double, 2>, 3> f{};
    double                               A = 0;

    double z = 0;
    for (unsigned int k = 0; k < plies.size(); ++k)
      {
        const Ply                   &ply = plies[k];
        const SymmetricTensor<4, 3> &b   = rotated[k];
        const StrainMoments          w(functions, z, z + ply.thickness);
        z += ply.thickness;

        const double b_3333 = b[2][2][2][2];
        A += w.inverse_area / b_3333;

        for (unsigned int ab = 0; ab < 3; ++ab)
          {
            const auto  &i      = tangential_pairs[ab];
            const double b_ab33 = b[i[0]][i[1]][2][2];
            for (unsigned int p = 0; p < 2; ++p)
              {
                // 'asymmetric' has the thickness resultant of the
                // three-dimensional law, but tangential ones of plane stress: a
                // row without its column
                f[ab][p] += b_ab33 / b_3333 * w.first[ab][p];
                if (law == ThicknessLaw::asymmetric)
                  D[Resultants::thickness][tangential(ab, p)] +=
                    b_ab33 * w.stressed[ab][p];
              }
            for (unsigned int cd = 0; cd < 3; ++cd)
              {
                const auto  &j      = tangential_pairs[cd];
                const double q_abcd = b[i[0]][i[1]][j[0]][j[1]] -
                                      b_ab33 * b[2][2][j[0]][j[1]] / b_3333;
                for (unsigned int p = 0; p < 2; ++p)
                  for (unsigned int q = 0; q < 2; ++q)
                    D[tangential(ab, p)][tangential(cd, q)] +=
                      q_abcd * w.second[ab][cd][p][q];
              }
          }

        if (law == ThicknessLaw::asymmetric)
          D[Resultants::thickness][Resultants::thickness] += b_3333 * w.area;
      }

    for (unsigned int p = 0; p < 2; ++p)
      for (unsigned int q = 0; q < 2; ++q)
        for (unsigned int a = 0; a < 2; ++a)
          for (unsigned int c = 0; c < 2; ++c)
            D[transverse(a, p)][transverse(c, q)] =
              transverse_shear.stiffness(p, q)[a][c];

    // the constant thickness stress is eliminated, so that the law derives from
    // an energy and does not lock (section 4 of doc/theory.md)
    if (law == ThicknessLaw::symmetric)
      {
        for (unsigned int ab = 0; ab < 3; ++ab)
          for (unsigned int p = 0; p < 2; ++p)
            {
              for (unsigned int cd = 0; cd < 3; ++cd)
                for (unsigned int q = 0; q < 2; ++q)
                  D[tangential(ab, p)][tangential(cd, q)] +=
                    f[ab][p] * f[cd][q] / A;
              D[tangential(ab, p)][Resultants::thickness] =
                D[Resultants::thickness][tangential(ab, p)] = h * f[ab][p] / A;
            }
        D[Resultants::thickness][Resultants::thickness] = h * h / A;
      }
    return D;
  }


  std::shared_ptr<const MaterialLaw>
  Laminate::law_of(const unsigned int ply) const
  {
    return plies[ply].laws.rubber
             ? plies[ply].laws.rubber
             : std::make_shared<const LinearLaw>(rotated[ply], along_normal);
  }


  PlyPoints::Point
  Laminate::point(const unsigned int ply, const double z) const
  {
    PlyPoints::Point point;
    // all strains at a height are linear in those of the faces: their
    // coefficients are what unit strains of the faces cause
    point.area = functions.area(z);
    for (unsigned int p = 0; p < 2; ++p)
      {
        for (unsigned int ab = 0; ab < 3; ++ab)
          point.tangential[ab][p] = functions.strain(ab, p, z);
        for (unsigned int c = 0; c < 2; ++c)
          {
            TransverseShear::FaceStrains unit;
            unit[p][c]               = 1;
            const Tensor<1, 2> shear = transverse_shear.strain(unit, ply, z);
            for (unsigned int a = 0; a < 2; ++a)
              point.shear[p][a][c] = shear[a];
          }
      }
    return point;
  }


  void
  Laminate::set_points()
  {
    // rubber and relaxation have no constant stiffness: their laws are
    // evaluated at points over the thickness
    std::vector<PlyPoints::Point> of_plies;
    // the transverse shear stiffness that the points lack, see TransverseShear
    Resultants::Matrix remainder;
    for (unsigned int s = Resultants::transverse(0, 0);
         s < Resultants::thickness;
         ++s)
      for (unsigned int t = Resultants::transverse(0, 0);
           t < Resultants::thickness;
           ++t)
        remainder[s][t] = D[s][t];

    double z = 0;
    for (unsigned int k = 0; k < plies.size(); ++k)
      {
        const auto law = law_of(k);
        functions.integrate(
          z, z + plies[k].thickness, [&](const double at, const double weight) {
            PlyPoints::Point next = point(k, at);
            next.thickness        = weight;
            next.law              = law;
            next.relaxation       = plies[k].laws.relaxation;
            next.height           = at;
            next.ply              = k;
            for (unsigned int p = 0; p < 2; ++p)
              for (unsigned int q = 0; q < 2; ++q)
                for (unsigned int a = 0; a < 2; ++a)
                  for (unsigned int c = 0; c < 2; ++c)
                    for (unsigned int d = 0; d < 2; ++d)
                      for (unsigned int e = 0; e < 2; ++e)
                        remainder[Resultants::transverse(d, p)]
                                 [Resultants::transverse(e, q)] -=
                          weight * next.area * next.shear[p][a][d] *
                          rotated[k][a][2][c][2] * next.shear[q][c][e];
            of_plies.push_back(std::move(next));
          });
        z += plies[k].thickness;
      }
    points = std::make_shared<const PlyPoints>(
      std::move(of_plies), thickness(), remainder, along_normal);
  }


  namespace
  {
    /** A value at a height, linear between the points of a ply; nothing relaxed
     * if there are no values.
     * @param points those of all plies.
     * @param sides of the ply. */
    template <typename Stress, typename Point>
    Relaxed<Stress>
    between_points(const std::vector<Relaxed<Stress>> &values,
                   const std::vector<Point>           &points,
                   const std::pair<double, double>    &sides,
                   const double                        z)
    {
      // the last points of the ply around z, or its two closest ones
      std::vector<unsigned int> of_ply;
      if (!values.empty())
        for (unsigned int k = 0; k < points.size(); ++k)
          if (sides.first < points[k].height && points[k].height < sides.second)
            of_ply.push_back(k);
      if (of_ply.empty())
        return {};
      unsigned int i = 0;
      while (i + 2 < of_ply.size() && points[of_ply[i + 1]].height < z)
        ++i;
      const unsigned int
        below = of_ply[i],
        above = of_ply[std::min<std::size_t>(i + 1, of_ply.size() - 1)];
      Relaxed<Stress> result = values[below];
      if (below != above)
        {
          const double part = (z - points[below].height) /
                              (points[above].height - points[below].height);
          result.stress += part * (values[above].stress - values[below].stress);
        }
      return result;
    }
  } // namespace


  Relaxed<PointStrains::Vector>
  Laminate::relaxed(const StrainsOfPlies &strains,
                    const unsigned int    ply,
                    const double          z) const
  {
    return between_points(
      strains.points, points->get_points(), sides_of_ply(ply), z);
  }


  Relaxed<double>
  Laminate::relaxed_cords(const StrainsOfPlies &strains,
                          const unsigned int    ply,
                          const double          z) const
  {
    if (strains.cords.empty())
      return {};
    return between_points(strains.cords, cord_points(), sides_of_ply(ply), z);
  }


  std::pair<double, double>
  Laminate::sides_of_ply(const unsigned int ply) const
  {
    double inner = 0;
    for (unsigned int p = 0; p < ply; ++p)
      inner += plies[p].thickness;
    return {inner, inner + plies[ply].thickness};
  }


  PointStrains::Vector
  Laminate::point_strain(const StrainsOfPlies &strains,
                         const unsigned int    ply,
                         const double          z) const
  {
    const PlyPoints::Point at       = point(ply, z);
    PointStrains::Vector   strain   = at.strain(strains.E);
    strain[PointStrains::thickness] = thickness_strain(
      *law_of(ply),
      relaxed(strains, ply, z),
      strain,
      points->thickness_state({&strains.E, 1}, strains.points).stress /
        at.area);
    return strain;
  }


  std::array<std::array<double, 2>, 2>
  Laminate::mass_moments() const
  {
    std::array<std::array<double, 2>, 2> moments{};
    double                               z = 0;
    for (const Ply &ply : plies)
      {
        const FaceMoments N(functions, z, z + ply.thickness);
        z += ply.thickness;
        for (unsigned int p = 0; p < 2; ++p)
          for (unsigned int q = 0; q < 2; ++q)
            moments[p][q] += ply.material.density * N.second[p][q];
      }
    return moments;
  }


  std::vector<CordPoint>
  Laminate::cord_points() const
  {
    static const QGauss<1> quadrature(2);
    std::vector<CordPoint> points;
    double                 z = 0;
    for (unsigned int k = 0; k < plies.size(); ++k)
      {
        const Ply &ply = plies[k];
        if (ply.laws.cords)
          {
            const std::array<double, 3> direction = cord_direction(ply.angle);
            // two points are exact as long as a ply is slack or taut as a whole
            // (section 4, "Cords that go slack")
            for (unsigned int g = 0; g < quadrature.size(); ++g)
              {
                const double at = z + quadrature.point(g)[0] * ply.thickness;
                CordPoint    point;
                point.height = at;
                point.ply    = k;
                for (unsigned int ab = 0; ab < 3; ++ab)
                  for (unsigned int p = 0; p < 2; ++p)
                    point.direction[Resultants::tangential(ab, p)] =
                      functions.strain(ab, p, at) * direction[ab];
                point.thickness =
                  quadrature.weight(g) * ply.thickness * functions.area(at);
                point.law        = ply.laws.cords;
                point.relaxation = ply.laws.relaxation;
                points.push_back(point);
              }
          }
        z += ply.thickness;
      }
    return points;
  }


  Resultants::Matrix
  Laminate::stiffness_of_slack_cords() const
  {
    // energies that are derived from it must be positive for every pattern of
    // slack cords, section 4 of doc/theory.md, "Nearly incompressible layers"
    Resultants::Matrix matrix = D;
    for (const CordPoint &cord : cord_points())
      for (unsigned int s = 0; s < Resultants::n_tangential; ++s)
        for (unsigned int t = 0; t < Resultants::n_tangential; ++t)
          matrix[s][t] += cord.law->lowest_modulus() * cord.thickness *
                          cord.direction[s] * cord.direction[t];
    return matrix;
  }


  double
  Laminate::tangential_strain(const Resultants::Vector &E,
                              const unsigned int        ab,
                              const double              z) const
  {
    return functions.strain(ab, 0, z) * E[Resultants::tangential(ab, 0)] +
           functions.strain(ab, 1, z) * E[Resultants::tangential(ab, 1)];
  }


  double
  Laminate::cord_strain(const Resultants::Vector &E,
                        const unsigned int        ply,
                        const double              z) const
  {
    const auto along = cord_direction(plies[ply].angle);
    double     e     = 0;
    for (unsigned int ab = 0; ab < 3; ++ab)
      e += along[ab] * tangential_strain(E, ab, z);
    return e;
  }


  Resultants::Vector
  Laminate::initial_resultants() const
  {
    using namespace Resultants;

    Vector H;
    double z = 0;
    for (const Ply &ply : plies)
      {
        const SymmetricTensor<2, 3> stress =
          rotate_about_normal(ply.initial_stress, ply.angle);
        // transverse shear keeps the integrals of a plate, those of N
        const StrainMoments w(functions, z, z + ply.thickness);
        const FaceMoments   N(functions, z, z + ply.thickness);
        z += ply.thickness;

        for (unsigned int p = 0; p < 2; ++p)
          {
            for (unsigned int ab = 0; ab < 3; ++ab)
              H[tangential(ab, p)] +=
                stress[tangential_pairs[ab][0]][tangential_pairs[ab][1]] *
                w.stressed[ab][p];
            for (unsigned int a = 0; a < 2; ++a)
              H[transverse(a, p)] += stress[a][2] * N.first[p];
          }
        H[Resultants::thickness] += stress[2][2] * w.area;
      }
    return H;
  }


  bool
  Laminate::is_slack(const Resultants::Vector &E,
                     const unsigned int        ply,
                     const double              z) const
  {
    const CordLaw *const cords = plies[ply].laws.cords.get();
    return cords && cords->is_slack(cord_strain(E, ply, z));
  }


  SymmetricTensor<2, 3>
  Laminate::strain(const StrainsOfPlies &strains,
                   const unsigned int    ply,
                   const double          z) const
  {
    if (points)
      return PointStrains::to_strain(point_strain(strains, ply, z));
    const Resultants::Vector &E = strains.E;
    SymmetricTensor<2, 3>     strain;
    strain[0][0] = tangential_strain(E, 0, z);
    strain[1][1] = tangential_strain(E, 1, z);
    strain[0][1] = tangential_strain(E, 2, z) / 2;
    const Tensor<1, 2> shear =
      transverse_shear.strain(transverse_strains(E), ply, z);
    for (unsigned int a = 0; a < 2; ++a)
      strain[a][2] = shear[a] / 2;
    if (law == ThicknessLaw::symmetric)
      {
        // the force S_33 mu/mu-bar = H_33/h is the same at all heights; each
        // ply has the thickness strain that gives it
        const SymmetricTensor<4, 3> &b = rotated[ply];
        const double                 stress =
          D[Resultants::thickness] * E / (thickness() * functions.area(z));
        strain[2][2] = (stress - (b * strain)[2][2]) / b[2][2][2][2];
      }
    else
      strain[2][2] = E[Resultants::thickness];
    return strain;
  }


  SymmetricTensor<2, 3>
  Laminate::stress(const StrainsOfPlies &strains,
                   const unsigned int    ply,
                   const double          z) const
  {
    const Resultants::Vector &E = strains.E;
    SymmetricTensor<2, 3>     stress;
    if (points)
      {
        const auto here = relaxed(strains, ply, z);
        stress          = PointStrains::to_stress(
          here.factor * law_of(ply)->stress(point_strain(strains, ply, z)) +
          here.stress);
      }
    else
      {
        const SymmetricTensor<4, 3> &b = rotated[ply];
        SymmetricTensor<2, 3>        e = strain(E, ply, z);
        stress                         = b * e;
        if (law == ThicknessLaw::asymmetric)
          {
            // tangential stresses of plane stress, the others of the
            // three-dimensional law
            const double S_33 = stress[2][2];
            e[2][2] -= S_33 / b[2][2][2][2];
            stress       = b * e;
            stress[2][2] = S_33;
          }
        // those whose integrals with N^- and N^+ are the resultants
        const Tensor<1, 2> shear =
          transverse_shear.stress(transverse_strains(E), ply, z);
        for (unsigned int a = 0; a < 2; ++a)
          stress[a][2] = shear[a];
      }

    const Ply &p = plies[ply];
    if (p.laws.cords)
      {
        // cords add a stress along their own direction to that of the ply, the
        // work of which is that of the strain along them
        const auto   along = cord_direction(p.angle);
        const auto   here  = relaxed_cords(strains, ply, z);
        const double added =
          here.factor * p.laws.cords->response(cord_strain(E, ply, z)).stress +
          here.stress;
        for (unsigned int ab = 0; ab < 3; ++ab)
          stress[Resultants::tangential_pairs[ab][0]]
                [Resultants::tangential_pairs[ab][1]] += added * along[ab];
      }
    return stress;
  }


  Tensor<1, 2>
  Laminate::shear_force(const Resultants::Vector &E) const
  {
    return transverse_shear.shear_force(transverse_strains(E));
  }


  Tensor<1, 2>
  Laminate::interlaminar_stress(const Resultants::Vector &E,
                                const unsigned int        ply,
                                const double              z) const
  {
    return transverse_shear.equilibrium_stress(transverse_strains(E), ply, z);
  }
} // namespace Biface
