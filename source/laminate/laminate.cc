// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/numbers.h>
#include <deal.II/base/quadrature_lib.h>

#include <biface/laminate/laminate.h>
#include <biface/laminate/material.h>

namespace Biface
{
  using namespace dealii;

  Laminate::Laminate(std::vector<Ply>   plies,
                     const ThicknessLaw law,
                     const double       reference_height)
    : plies(std::move(plies)), law(law), reference_height(reference_height)
  {
    for (const Ply &ply : this->plies)
      rotated.push_back(rotate_about_normal(ply.stiffness, ply.angle));
    thickness_row = stiffness()[Resultants::thickness];
  }


  double
  Laminate::thickness() const
  {
    double h = 0;
    for (const Ply &ply : plies)
      h += ply.thickness;
    return h;
  }


  std::array<double, 2>
  Laminate::face_heights() const
  {
    return {{-reference_height, thickness() - reference_height}};
  }


  bool
  Laminate::is_symmetric() const
  {
    return law != ThicknessLaw::asymmetric;
  }


  namespace
  {
    /** @f$\int_{z_0}^{z_1} N^p N^q\,dz@f$ and @f$\int N^p\,dz@f$ over a ply of
     * a shell whose thickness runs from 0 to h. */
    struct FaceMoments
    {
      std::array<double, 2>                first{};
      std::array<std::array<double, 2>, 2> second{};

      FaceMoments(const double z_0, const double z_1, const double h)
      {
        const QGauss<1> quadrature(2);
        for (unsigned int i = 0; i < quadrature.size(); ++i)
          {
            const double z = z_0 + (z_1 - z_0) * quadrature.point(i)[0];
            const std::array<double, 2> N{{1 - z / h, z / h}};
            for (unsigned int p = 0; p < 2; ++p)
              {
                first[p] += quadrature.weight(i) * (z_1 - z_0) * N[p];
                for (unsigned int q = 0; q < 2; ++q)
                  second[p][q] +=
                    quadrature.weight(i) * (z_1 - z_0) * N[p] * N[q];
              }
          }
      }
    };

    // indices of the tensor components 11, 22, 12
    constexpr unsigned int tangential_pairs[3][2] = {{0, 0}, {1, 1}, {0, 1}};
  } // namespace


  Resultants::Matrix
  Laminate::stiffness() const
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
        const FaceMoments            N(z, z + ply.thickness, h);
        z += ply.thickness;

        const double b_3333 = b[2][2][2][2];
        A += ply.thickness / b_3333;

        for (unsigned int ab = 0; ab < 3; ++ab)
          {
            const auto  &i      = tangential_pairs[ab];
            const double b_ab33 = b[i[0]][i[1]][2][2];
            for (unsigned int p = 0; p < 2; ++p)
              {
                f[ab][p] += b_ab33 / b_3333 * N.first[p];
                if (law != ThicknessLaw::symmetric)
                  D[Resultants::thickness][tangential(ab, p)] +=
                    b_ab33 * N.first[p];
                if (law == ThicknessLaw::full)
                  D[tangential(ab, p)][Resultants::thickness] +=
                    b_ab33 * N.first[p];
              }
            for (unsigned int cd = 0; cd < 3; ++cd)
              {
                const auto  &j      = tangential_pairs[cd];
                const double b_abcd = b[i[0]][i[1]][j[0]][j[1]];
                const double q_abcd =
                  b_abcd - b_ab33 * b[2][2][j[0]][j[1]] / b_3333;
                for (unsigned int p = 0; p < 2; ++p)
                  for (unsigned int q = 0; q < 2; ++q)
                    D[tangential(ab, p)][tangential(cd, q)] +=
                      (law == ThicknessLaw::full ? b_abcd : q_abcd) *
                      N.second[p][q];
              }
          }

        for (unsigned int a = 0; a < 2; ++a)
          for (unsigned int c = 0; c < 2; ++c)
            for (unsigned int p = 0; p < 2; ++p)
              for (unsigned int q = 0; q < 2; ++q)
                D[transverse(a, p)][transverse(c, q)] +=
                  b[a][2][c][2] * N.second[p][q];

        if (law != ThicknessLaw::symmetric)
          D[Resultants::thickness][Resultants::thickness] +=
            b_3333 * ply.thickness;
      }

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


  Resultants::Vector
  Laminate::initial_resultants() const
  {
    using namespace Resultants;

    const double h = thickness();
    Vector       H;
    double       z = 0;
    for (const Ply &ply : plies)
      {
        const SymmetricTensor<2, 3> stress =
          rotate_about_normal(ply.initial_stress, ply.angle);
        const FaceMoments N(z, z + ply.thickness, h);
        z += ply.thickness;

        for (unsigned int p = 0; p < 2; ++p)
          {
            for (unsigned int ab = 0; ab < 3; ++ab)
              H[tangential(ab, p)] +=
                stress[tangential_pairs[ab][0]][tangential_pairs[ab][1]] *
                N.first[p];
            for (unsigned int a = 0; a < 2; ++a)
              H[transverse(a, p)] += stress[a][2] * N.first[p];
          }
        H[Resultants::thickness] += stress[2][2] * ply.thickness;
      }
    return H;
  }


  SymmetricTensor<2, 3>
  Laminate::strain(const Resultants::Vector &E,
                   const unsigned int        ply,
                   const double              z) const
  {
    using namespace Resultants;

    const double                h = this->thickness();
    const std::array<double, 2> N{{1 - z / h, z / h}};
    SymmetricTensor<2, 3>       strain;
    for (unsigned int p = 0; p < 2; ++p)
      {
        strain[0][0] += N[p] * E[tangential(0, p)];
        strain[1][1] += N[p] * E[tangential(1, p)];
        strain[0][1] += N[p] * E[tangential(2, p)] / 2;
        strain[0][2] += N[p] * E[transverse(0, p)] / 2;
        strain[1][2] += N[p] * E[transverse(1, p)] / 2;
      }
    if (law == ThicknessLaw::symmetric)
      {
        const SymmetricTensor<4, 3> &b = rotated[ply];
        strain[2][2] =
          (thickness_row * E / h - (b * strain)[2][2]) / b[2][2][2][2];
      }
    else
      strain[2][2] = E[Resultants::thickness];
    return strain;
  }


  SymmetricTensor<2, 3>
  Laminate::stress(const Resultants::Vector &E,
                   const unsigned int        ply,
                   const double              z) const
  {
    const SymmetricTensor<4, 3> &b      = rotated[ply];
    SymmetricTensor<2, 3>        e      = strain(E, ply, z);
    const SymmetricTensor<2, 3>  stress = b * e;
    if (law != ThicknessLaw::asymmetric)
      return stress;

    // tangential stresses of plane stress, the others of the full law
    e[2][2] -= stress[2][2] / b[2][2][2][2];
    SymmetricTensor<2, 3> plane_stress = b * e;
    plane_stress[2][2]                 = stress[2][2];
    return plane_stress;
  }
} // namespace Biface
