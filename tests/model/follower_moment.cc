// SPDX-License-Identifier: LGPL-2.1-or-later

// The couple of a follower moment does the work M times the change of the angle
// of the director, whatever its length; its derivative is correct and
// symmetric, and it has no force along the axis.

#include <random>

#include <biface/model/forces/edge_moments.h>

#include <tests.h>

using namespace dealii;
using namespace Biface;

int
main()
{
  std::mt19937                           generator(1);
  std::uniform_real_distribution<double> random(-1, 1);
  const auto                             random_vector = [&]() {
    return Tensor<1, 3>(
      {random(generator), random(generator), random(generator)});
  };

  const double M    = 3;
  double       work = 0, derivative = 0, asymmetry = 0, along = 0, radial = 0;
  for (unsigned int n = 0; n < 20; ++n)
    {
      // a right-handed system of the axis and two directions across it
      Tensor<1, 3> axis = random_vector(), e = random_vector();
      axis /= axis.norm();
      e -= (e * axis) * axis;
      e /= e.norm();
      const Tensor<1, 3> f     = cross_product_3d(axis, e);
      const auto         angle = [&](const Tensor<1, 3> &d) {
        return std::atan2(d * f, d * e);
      };

      // about as long as 1, and not along the cut of the angle
      const Tensor<1, 3>   d = e + 0.7 * random_vector();
      const FollowerCouple couple(M, axis, d);

      const double       step   = 1e-5;
      const Tensor<1, 3> dd     = step * random_vector();
      work                      = std::max(work,
                      std::abs(couple.force * dd -
                               M * (angle(d + dd / 2) - angle(d - dd / 2))) /
                        step);
      const Tensor<1, 3> change = FollowerCouple(M, axis, d + dd / 2).force -
                                  FollowerCouple(M, axis, d - dd / 2).force;
      derivative =
        std::max(derivative, (couple.derivative * dd - change).norm() / step);
      asymmetry = std::max(
        asymmetry, (couple.derivative - transpose(couple.derivative)).norm());
      along  = std::max(along, std::abs(couple.force * axis));
      radial = std::max(radial, std::abs(couple.force * d));
    }
  check_small("force and angle", work, 1e-8);
  check_small("derivative of the force", derivative, 1e-7);
  check_small("its symmetry", asymmetry, 1e-13);
  check_small("no force along the axis", along, 1e-14);
  check_small("nor along the director", radial, 1e-14);

  // M / |d| across a director that is at right angles to the axis
  const FollowerCouple couple(
    M, Tensor<1, 3>({0, 1, 0}), Tensor<1, 3>({0, 0, 0.5}));
  check_small("force of a moment about y, director along z",
              (couple.force - Tensor<1, 3>({6, 0, 0})).norm(),
              1e-14);
}
