// SPDX-License-Identifier: LGPL-2.1-or-later

// The angle of a ply rotates its axes from e_1 toward e_2: a quarter turn swaps
// them, and the opposite angle changes the sign of the coupling terms.

#include <deal.II/base/numbers.h>

#include <biface/laminate/laminate.h>
#include <biface/laminate/material.h>

#include <tests.h>

using namespace dealii;
using namespace Biface;

namespace
{
  const SymmetricTensor<4, 3> ply_stiffness =
    Material{500, 20, 7, 5, 4, 3, 0.4, 0.3, 0.2}.stiffness("ply");

  Resultants::Matrix
  stiffness(const double degrees, const ThicknessLaw law)
  {
    return Laminate(
             {{{ply_stiffness}, 1.2, degrees * numbers::PI / 180, {}}}, law, 0)
      .stiffness();
  }


  /** The strain (or resultant) that takes its place when the axes swap. */
  unsigned int
  swapped(const unsigned int strain)
  {
    const unsigned int swap[11] = {2, 3, 0, 1, 4, 5, 8, 9, 6, 7, 10};
    return swap[strain];
  }


  /** How often the index 2 occurs in the strain: its sign under a reflection
   * of e_2. */
  double
  sign(const unsigned int strain)
  {
    const double signs[11] = {1, 1, 1, 1, -1, -1, 1, 1, -1, -1, 1};
    return signs[strain];
  }
} // namespace


int
main()
{
  for (const auto law : {ThicknessLaw::symmetric, ThicknessLaw::asymmetric})
    {
      const auto along = stiffness(0, law), across = stiffness(90, law),
                 right = stiffness(52, law), left = stiffness(-52, law);

      double swap = 0, reflection = 0;
      for (unsigned int i = 0; i < Resultants::n; ++i)
        for (unsigned int j = 0; j < Resultants::n; ++j)
          {
            swap = std::hypot(
              swap, std::abs(across[i][j] - along[swapped(i)][swapped(j)]));
            reflection = std::hypot(
              reflection,
              std::abs(left[i][j] - sign(i) * sign(j) * right[i][j]));
          }
      check_small("a quarter turn swaps the axes", swap, 1e-10);
      check_small("the opposite angle reflects", reflection, 1e-10);
      using namespace Resultants;
      check_true("and the coupling terms are there",
                 std::abs(right[tangential(0, 0)][tangential(2, 0)]) > 1 &&
                   std::abs(right[transverse(0, 0)][transverse(1, 0)]) > 0.1);
    }

  // along the turned axis the ply has the stiffness of its own axis 1
  const double       angle = 0.6;
  const Tensor<1, 3> f({std::cos(angle), std::sin(angle), 0});
  const auto         ff = symmetrize(outer_product(f, f));
  check_small("stiffness along the cords",
              ff * (rotate_about_normal(ply_stiffness, angle) * ff) -
                ply_stiffness[0][0][0][0],
              1e-10);
  SymmetricTensor<2, 3> stress;
  stress[0][0] = 1;
  check_small("stress along the cords",
              (rotate_about_normal(stress, angle) - ff).norm(),
              1e-14);
}
