// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/physics/transformations.h>

#include <cmath>
#include <utility>
#include <vector>

#include <biface/base/errors.h>
#include <biface/input/parameter_tools.h>
#include <biface/laminate/material.h>
#include <biface/laminate/principal_axes.h>

namespace Biface
{
  using namespace dealii;

  Material
  Material::transversely_isotropic(const double E_L,
                                   const double E_T,
                                   const double G_LT,
                                   const double G_TT,
                                   const double nu_LT,
                                   const double nu_TT)
  {
    return {E_L, E_T, E_T, G_LT, G_LT, G_TT, nu_LT, nu_LT, nu_TT};
  }


  Material
  Material::isotropic(const double E, const double nu)
  {
    const double G = E / (2 * (1 + nu));
    return {E, E, E, G, G, G, nu, nu, nu};
  }


  SymmetricTensor<4, 3>
  Material::stiffness(const std::string &name) const
  {
    const std::vector<std::pair<std::string, double>> moduli{{"E_1", E_1},
                                                             {"E_2", E_2},
                                                             {"E_3", E_3},
                                                             {"G_12", G_12},
                                                             {"G_13", G_13},
                                                             {"G_23", G_23}};
    for (const auto &modulus : moduli)
      check_positive(name + "/" + modulus.first, modulus.second);

    // the part of the normal components is inverted on its own: in the axes of
    // the material it is not coupled with shear
    SymmetricTensor<2, 3> compliance;
    compliance[0][0] = 1 / E_1;
    compliance[1][1] = 1 / E_2;
    compliance[2][2] = 1 / E_3;
    compliance[0][1] = -nu_12 / E_1;
    compliance[0][2] = -nu_13 / E_1;
    compliance[1][2] = -nu_23 / E_2;

    // scaled to a unit diagonal, so that the bound has no unit
    SymmetricTensor<2, 3> scaled;
    for (unsigned int i = 0; i < 3; ++i)
      for (unsigned int j = i; j < 3; ++j)
        scaled[i][j] =
          compliance[i][j] / std::sqrt(compliance[i][i] * compliance[j][j]);
    if (!(eigenvalues(scaled)[2] > 1e-10))
      throw InputError("the Poisson ratios of '" + name + "' are " +
                       number_to_string(nu_12) + " (12), " +
                       number_to_string(nu_13) + " (13), " +
                       number_to_string(nu_23) +
                       " (23), but with its moduli they must give a positive "
                       "definite stiffness.");

    // a product with strains counts the entries 12 and 21, so that the entry G
    // gives the stress 2 G e_12
    const SymmetricTensor<2, 3> normal = invert(compliance);
    SymmetricTensor<4, 3>       b;
    for (unsigned int i = 0; i < 3; ++i)
      for (unsigned int j = 0; j < 3; ++j)
        b[i][i][j][j] = normal[i][j];
    b[0][1][0][1] = G_12;
    b[0][2][0][2] = G_13;
    b[1][2][1][2] = G_23;
    return b;
  }


  namespace
  {
    Tensor<2, 3>
    rotation(const double angle)
    {
      return Physics::Transformations::Rotations::rotation_matrix_3d(
        Point<3>(0, 0, 1), angle);
    }
  } // namespace


  SymmetricTensor<4, 3>
  rotate_about_normal(const SymmetricTensor<4, 3> &stiffness,
                      const double                 angle)
  {
    return Physics::Transformations::Contravariant::push_forward(
      stiffness, rotation(angle));
  }


  SymmetricTensor<2, 3>
  rotate_about_normal(const SymmetricTensor<2, 3> &stress, const double angle)
  {
    return Physics::Transformations::Contravariant::push_forward(
      stress, rotation(angle));
  }


  SymmetricTensor<2, 3>
  cauchy_stress(const SymmetricTensor<2, 3> &stress,
                const SymmetricTensor<2, 3> &strain)
  {
    // F S F^T/J with F = U, that is, without the rotation: components in axes
    // that turn with the material
    Tensor<2, 3> U;
    double       det = 1;
    for (const auto &[value, axis] : principal_axes(strain))
      {
        const double stretch = std::sqrt(1 + 2 * value);
        U += stretch * outer_product(axis, axis);
        det *= stretch;
      }
    return symmetrize(U * Tensor<2, 3>(stress) * U) / det;
  }
} // namespace Biface
