// SPDX-License-Identifier: LGPL-2.1-or-later

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
