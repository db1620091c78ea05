// SPDX-License-Identifier: LGPL-2.1-or-later

// On springs with a given stiffness matrix, the stiffness against each motion
// of the ground is a column of this matrix, with moments about the given
// point. There is none if the ground rests or moves in two ways at once.

#include <deal.II/base/numbers.h>

#include <cmath>

#include <biface/stepping/stiffness_against_ground.h>

#include "../tests.h"

using namespace dealii;
using namespace Biface;

namespace
{
  /** Without round-off. */
  double
  rounded(const double value)
  {
    return std::round(1e9 * value) / 1e9 + 0.;
  }

  Tensor<1, 3>
  rounded(Tensor<1, 3> vector)
  {
    for (unsigned int i = 0; i < 3; ++i)
      vector[i] = rounded(vector[i]);
    return vector;
  }


  const Tensor<1, 3> outward({0., 0.6, 0.8});
  const Point<3>     center(1, -2, 3);

  /** The forces and moments, about the center, of springs that couple all
   * motions of the ground, of which they resist those along the axes. */
  GroundReaction
  reaction(const LoadLevel &level)
  {
    const Tensor<1, 3> moved = level.slide - level.travel * outward;
    GroundReaction     result;
    result.level = level;
    Tensor<1, 3> moment;
    for (unsigned int i = 0; i < 3; ++i)
      {
        result.force[i] = 7 + (i + 2) * moved[i] + 0.5 * level.turn * (i + 1);
        moment[i] = 3 + (i + 1) * moved[(i + 1) % 3] + 4. * i * level.turn;
      }
    result.moment =
      moment + cross_product_3d(Tensor<1, 3>(center), result.force);
    return result;
  }


  void
  check(const std::string &name, const LoadLevel &from, const LoadLevel &to)
  {
    const auto found =
      stiffness_against_ground(reaction(from), reaction(to), outward, center);
    std::cout << name << ": ";
    if (found)
      std::cout << "amount " << found->amount << " along "
                << rounded(found->direction) << ", force "
                << rounded(found->force) << ", moment "
                << rounded(found->moment) << ", along the motion "
                << rounded(found->along()) << std::endl;
    else
      std::cout << "none" << std::endl;
  }
} // namespace


int
main()
{
  LoadLevel from;
  from.travel  = 2;
  from.slide   = Tensor<1, 3>({1., 0.8, -0.6});
  from.turn    = 5;
  LoadLevel to = from;
  check("at rest", from, to);
  to.pressure = 1;
  to.travel   = 2.5;
  check("approach", from, to);
  to.travel = 1.5;
  check("moving away", from, to);
  to.slide[0] = 0;
  check("approach and slide", from, to);
  to.travel = from.travel;
  check("slide", from, to);
  to.slide = from.slide;
  to.turn  = 3;
  check("turn", from, to);
}
