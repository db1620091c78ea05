// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>

#include <biface/laminate/laminate.h>
#include <biface/laminate/stiffness_along.h>

namespace Biface
{
  using namespace dealii;

  StiffnessOfFaces
  stiffness_along(const Laminate &laminate, const Tensor<1, 2> &direction)
  {
    const Resultants::Matrix &D = laminate.stiffness();
    // by strains along the direction, with no thickness stress; unsymmetric
    // laws have none anyway
    std::array<Resultants::Vector, 2> strains;
    for (unsigned int face = 0; face < 2; ++face)
      {
        for (unsigned int i = 0; i < 2; ++i)
          strains[face][Resultants::tangential(i, face)] =
            direction[i] * direction[i];
        strains[face][Resultants::tangential(2, face)] =
          2 * direction[0] * direction[1];
      }
    constexpr unsigned int thickness = Resultants::thickness;
    StiffnessOfFaces       stiffness{};
    for (unsigned int q = 0; q < 2; ++q)
      {
        Resultants::Vector H = D * strains[q];
        if (laminate.is_symmetric())
          {
            Resultants::Vector E = strains[q];
            E[thickness]         = -H[thickness] / D[thickness][thickness];
            H                    = D * E;
          }
        for (unsigned int p = 0; p < 2; ++p)
          for (unsigned int i = 0; i < 3; ++i)
            stiffness[p][q] += H[Resultants::tangential(i, p)] *
                               strains[p][Resultants::tangential(i, p)];
      }
    return stiffness;
  }


  bool
  is_isotropic(const Laminate &laminate)
  {
    // the tensor of fourth order is isotropic if these directions are the same
    const StiffnessOfFaces first =
      stiffness_along(laminate, Tensor<1, 2>({1, 0}));
    double scale = 0, difference = 0;
    for (const double angle : {30., 60., 90., 120., 150.})
      {
        const double           phi   = angle * numbers::PI / 180;
        const StiffnessOfFaces other = stiffness_along(
          laminate, Tensor<1, 2>({std::cos(phi), std::sin(phi)}));
        for (unsigned int p = 0; p < 2; ++p)
          for (unsigned int q = 0; q < 2; ++q)
            {
              scale = std::max(scale, std::abs(first[p][q]));
              difference =
                std::max(difference, std::abs(other[p][q] - first[p][q]));
            }
      }
    return difference < 1e-6 * scale;
  }


  double
  bending_stiffness_along(const Laminate     &laminate,
                          const Tensor<1, 2> &direction)
  {
    const StiffnessOfFaces      k   = stiffness_along(laminate, direction);
    const std::array<double, 2> z   = laminate.face_heights();
    const double                sum = k[0][0] + k[0][1] + k[1][0] + k[1][1],
                 first_moment =
                   (k[0][0] + k[1][0]) * z[0] + (k[0][1] + k[1][1]) * z[1],
                 neutral = first_moment / sum;

    double result = 0;
    for (unsigned int p = 0; p < 2; ++p)
      for (unsigned int q = 0; q < 2; ++q)
        result += (z[p] - neutral) * k[p][q] * (z[q] - neutral);
    return result;
  }
} // namespace Biface
