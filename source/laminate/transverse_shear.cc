// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/quadrature_lib.h>

#include <algorithm>
#include <cmath>

#include <biface/base/errors.h>
#include <biface/input/formula.h>
#include <biface/laminate/resultants.h>
#include <biface/laminate/thickness_functions.h>
#include <biface/laminate/transverse_shear.h>

namespace Biface
{
  using namespace dealii;

  namespace
  {
    /** A number or a formula without variables. Throws @p error if it is
     * neither. */
    double
    number(const std::string &entry,
           const std::string &text,
           const InputError  &error)
    {
      try
        {
          return Formula(entry, text, {})({});
        }
      catch (const InputError &)
        {
          throw error;
        }
    }
  } // namespace


  std::optional<TransverseShearLaw>
  parse_transverse_shear(const std::string &entry, const std::string &text)
  {
    using Kind = TransverseShearLaw::Kind;
    if (text == "automatic")
      return {};
    if (text == "constant strain")
      return TransverseShearLaw{Kind::constant_strain, 1};
    if (text == "equilibrium")
      return TransverseShearLaw{Kind::equilibrium, 1};

    const InputError error(
      entry,
      text,
      "it must be 'automatic', 'constant strain', "
      "'equilibrium' or a factor above 0 and at most 1, such as 5/6");
    const double factor = number(entry, text, error);
    if (!(factor > 0 && factor <= 1))
      throw error;
    return TransverseShearLaw{Kind::factor, factor};
  }


  std::optional<double>
  parse_gradient_factor(const std::string &entry, const std::string &text)
  {
    if (text == "by layers")
      return {};
    const InputError error(
      entry, text, "it must be 'by layers' or a number from 1 to 1000");
    const double factor = number(entry, text, error);
    if (!(factor >= 1 && factor <= 1000))
      throw error;
    return factor;
  }


  namespace
  {
    /** The solution of a system with a symmetric positive definite matrix,
     * scaled to a unit diagonal. Finite even if the matrix is singular to
     * working precision, as for plies whose moduli differ by 16 orders of
     * magnitude. */
    Tensor<1, 4>
    solve(Tensor<2, 4> A, Tensor<1, 4> b)
    {
      Tensor<1, 4> scale;
      for (unsigned int i = 0; i < 4; ++i)
        scale[i] = 1 / std::sqrt(A[i][i]);
      for (unsigned int i = 0; i < 4; ++i)
        {
          b[i] *= scale[i];
          for (unsigned int j = 0; j < 4; ++j)
            A[i][j] *= scale[i] * scale[j];
        }
      // relative to the unit diagonal, so that it has no unit
      constexpr double least_pivot = 1e-15;
      for (unsigned int i = 0; i < 4; ++i)
        {
          A[i][i] = std::max(A[i][i], least_pivot);
          for (unsigned int k = i + 1; k < 4; ++k)
            {
              const double factor = A[k][i] / A[i][i];
              b[k] -= factor * b[i];
              for (unsigned int j = i; j < 4; ++j)
                A[k][j] -= factor * A[i][j];
            }
        }
      for (unsigned int i = 4; i-- > 0;)
        {
          for (unsigned int j = i + 1; j < 4; ++j)
            b[i] -= A[i][j] * b[j];
          b[i] /= A[i][i];
        }
      for (unsigned int i = 0; i < 4; ++i)
        b[i] *= scale[i];
      return b;
    }


    /** The inverse, also where the determinant would overflow. */
    Tensor<2, 2>
    inverse(const Tensor<2, 2> &matrix)
    {
      const double size = trace(matrix);
      return invert(matrix / size) / size;
    }
  } // namespace


  TransverseShear::TransverseShear(
    const TransverseShearLaw                 &law,
    const std::vector<double>                &thicknesses,
    const std::vector<SymmetricTensor<4, 3>> &stiffnesses,
    const WallOfLayer                        &wall)
    : law(law), wall(wall), thickness(0)
  {
    for (unsigned int k = 0; k < thicknesses.size(); ++k)
      {
        const SymmetricTensor<4, 3> &b = stiffnesses[k];
        Ply                          ply;
        ply.begin = thickness;
        thickness += thicknesses[k];
        ply.end = thickness;
        for (unsigned int i = 0; i < 3; ++i)
          for (unsigned int j = 0; j < 3; ++j)
            {
              const auto &ab = Resultants::tangential_pairs[i];
              const auto &cd = Resultants::tangential_pairs[j];
              // without thickness stress
              ply.plane_stress[i][j] =
                b[ab[0]][ab[1]][cd[0]][cd[1]] -
                b[ab[0]][ab[1]][2][2] * b[2][2][cd[0]][cd[1]] / b[2][2][2][2];
            }
        for (unsigned int a = 0; a < 2; ++a)
          for (unsigned int c = 0; c < 2; ++c)
            ply.shear[a][c] = b[a][2][c][2];
        plies.push_back(ply);
      }

    for (const Ply &ply : plies)
      {
        const FaceMoments N(ply.begin, ply.end, thickness);
        for (unsigned int p = 0; p < 2; ++p)
          for (unsigned int q = 0; q < 2; ++q)
            D[p][q] += law.factor * N.second[p][q] * ply.shear;
      }
    // a layer has the distribution of its wall
    if (!wall.shear)
      set_distribution();
    if (law.kind == TransverseShearLaw::Kind::equilibrium)
      set_equilibrium_stiffness();
    else if (law.gradient_factor != 1)
      {
        // a gradient of the thickness strain matters only where a face
        // wrinkles, section 4 of doc/theory.md
        const Tensor<2, 2> R = law.factor * set_residual();
        for (unsigned int p = 0; p < 2; ++p)
          for (unsigned int q = 0; q < 2; ++q)
            D[p][q] += (p == q ? 0.25 : -0.25) * (law.gradient_factor - 1) * R;
      }
  }


  Tensor<2, 2>
  TransverseShear::set_residual()
  {
    // the integrals of b_a3c3, s b_a3c3 and s^2 b_a3c3
    std::array<Tensor<2, 2>, 3> b;
    for (const Ply &ply : plies)
      {
        // the shape functions are (1 - s)/2 and (1 + s)/2
        const auto N = FaceMoments(ply.begin, ply.end, thickness).second;
        b[0] += (N[0][0] + 2 * N[0][1] + N[1][1]) * ply.shear;
        b[1] += (N[1][1] - N[0][0]) * ply.shear;
        b[2] += (N[0][0] - 2 * N[0][1] + N[1][1]) * ply.shear;
      }
    s_0 = inverse(b[0]) * b[1];
    // R of section 4 of doc/theory.md: opposite shear strains of the faces with
    // the constant one that makes their shear force vanish
    return b[2] - b[1] * s_0;
  }


  void
  TransverseShear::set_distribution()
  {
    for (unsigned int c = 0; c < 2; ++c)
      {
        // Only the strains cc and 12 of the two faces have gradients along
        // alpha_c. The gradients of the membrane forces vanish, that of the
        // bending moment cc is the shear force, that of the twisting moment is
        // zero.
        const std::array<unsigned int, 2> strains{{c, 2}};
        Tensor<2, 4>                      matrix;
        for (const Ply &ply : plies)
          {
            const FaceMoments N(ply.begin, ply.end, thickness);
            for (unsigned int i = 0; i < 2; ++i)
              for (unsigned int j = 0; j < 2; ++j)
                for (unsigned int p = 0; p < 2; ++p)
                  for (unsigned int q = 0; q < 2; ++q)
                    matrix[2 * i + p][2 * j + q] +=
                      ply.plane_stress[strains[i]][strains[j]] * N.second[p][q];
          }
        // the shear force 1 is the gradient of a bending moment, a couple of
        // forces on both faces
        const Tensor<1, 4> solution =
          solve(matrix, Tensor<1, 4>({-1 / thickness, 1 / thickness, 0, 0}));
        for (unsigned int p = 0; p < 2; ++p)
          for (unsigned int i = 0; i < 2; ++i)
            gradient[c][p][strains[i]] = solution[2 * i + p];
      }

    // stresses are continuous between plies: the integral goes on from one to
    // the next
    Tensor<2, 2> F;
    for (Ply &ply : plies)
      {
        ply.F = F;
        F     = distribution(&ply - plies.data(), ply.end);
      }
  }


  Tensor<2, 2>
  TransverseShear::distribution(const unsigned int ply, const double z) const
  {
    if (wall.shear)
      return wall.shear->distribution(wall.n_below + ply,
                                      wall.height_below + z);
    const Ply        &at = plies[ply];
    const FaceMoments N(at.begin, z, thickness);
    Tensor<2, 2>      F = at.F;
    for (unsigned int c = 0; c < 2; ++c)
      for (unsigned int p = 0; p < 2; ++p)
        {
          const Tensor<1, 3> stresses =
            N.first[p] * (at.plane_stress * gradient[c][p]);
          // the stresses whose gradients along alpha_c enter the equilibrium
          // along alpha_1 and alpha_2
          F[c][c] -= stresses[c];
          F[1 - c][c] -= stresses[2];
        }
    return F;
  }


  void
  TransverseShear::set_equilibrium_stiffness()
  {
    // G^p, and the compliance of the shear forces
    std::array<Tensor<2, 2>, 2> G;
    Tensor<2, 2>                compliance;

    static const QGauss<1> quadrature(3);
    for (unsigned int k = 0; k < plies.size(); ++k)
      for (unsigned int i = 0; i < quadrature.size(); ++i)
        {
          const Ply   &ply    = plies[k];
          const double weight = quadrature.weight(i) * (ply.end - ply.begin);
          const double z =
            ply.begin + quadrature.point(i)[0] * (ply.end - ply.begin);
          const double       s = 2 * z / thickness - 1;
          const Tensor<2, 2> F = distribution(k, z);
          for (unsigned int p = 0; p < 2; ++p)
            G[p] += weight * (p == 0 ? 1 - s : 1 + s) / 2 * F;
          compliance += weight * transpose(F) * inverse(ply.shear) * F;
        }

    // Equilibrium says nothing about a gradient of the thickness strain, for
    // which the law of constant strain is kept.
    const Tensor<2, 2> residual = law.gradient_factor * set_residual();
    const Tensor<2, 2> K        = inverse(compliance);
    for (unsigned int p = 0; p < 2; ++p)
      // K is the stiffness whose energy is that of the stresses F Q in
      // equilibrium
      to_amplitude[p] = K * transpose(G[p]);
    for (unsigned int p = 0; p < 2; ++p)
      for (unsigned int q = 0; q < 2; ++q)
        D[p][q] =
          G[p] * K * transpose(G[q]) + (p == q ? 0.25 : -0.25) * residual;
  }


  Tensor<1, 2>
  TransverseShear::shear_force(const FaceStrains &strains) const
  {
    Tensor<1, 2> Q;
    for (unsigned int p = 0; p < 2; ++p)
      for (unsigned int q = 0; q < 2; ++q)
        Q += D[p][q] * strains[q];
    return Q;
  }


  Tensor<1, 2>
  TransverseShear::amplitude(const FaceStrains &strains) const
  {
    // in a whole wall, F integrates to 1
    return wall.shear
             ? to_amplitude[0] * strains[0] + to_amplitude[1] * strains[1]
             : shear_force(strains);
  }


  Tensor<1, 2>
  TransverseShear::stress(const FaceStrains &strains,
                          const unsigned int ply,
                          const double       z) const
  {
    // the residual part has no shear force; it is that of opposite strains of
    // the faces, which equilibrium leaves open
    const Tensor<2, 2> &b          = plies[ply].shear;
    const double        s          = 2 * z / thickness - 1;
    const Tensor<1, 2>  difference = (strains[1] - strains[0]) / 2;
    const Tensor<1, 2>  residual   = s * difference - s_0 * difference;
    if (law.kind != TransverseShearLaw::Kind::equilibrium)
      {
        Tensor<1, 2> strain =
          (1 - s) / 2 * strains[0] + (1 + s) / 2 * strains[1];
        if (law.gradient_factor != 1)
          strain += (law.gradient_factor - 1) * residual;
        return law.factor * b * strain;
      }
    return distribution(ply, z) * amplitude(strains) +
           law.gradient_factor * b * residual;
  }


  Tensor<1, 2>
  TransverseShear::strain(const FaceStrains &strains,
                          const unsigned int ply,
                          const double       z) const
  {
    if (law.kind == TransverseShearLaw::Kind::equilibrium)
      // those of the stresses in equilibrium, of whose distribution the strains
      // of the faces know nothing
      return inverse(plies[ply].shear) * stress(strains, ply, z);
    const double s = 2 * z / thickness - 1;
    return (1 - s) / 2 * strains[0] + (1 + s) / 2 * strains[1];
  }
} // namespace Biface
