// SPDX-License-Identifier: LGPL-2.1-or-later

// The angle by which two directors turn against each other is zero in rigid
// motions of any size, in a small relative rotation its angle, and of second
// order in stretches; its derivatives are exact.

#include <deal.II/physics/transformations.h>

#include <random>

#include <biface/model/forces/joints.h>

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
  const auto turned =
    [](const Tensor<1, 3> &x, const Tensor<1, 3> &axis, const double angle) {
      return Physics::Transformations::Rotations::rotation_matrix_3d(
               Point<3>(axis / axis.norm()), angle) *
             x;
    };
  using Pair = std::array<Tensor<1, 3>, 2>;

  double rigid = 0, relative = 0, stretch = 0, first = 0, second = 0;
  for (unsigned int n = 0; n < 20; ++n)
    {
      const double       gamma = 0.4 + 2.3 * (n + 0.5) / 20;
      const Tensor<1, 3> axis = random_vector(), e = random_vector();
      Pair               W;
      W[0] = cross_product_3d(axis, e);
      W[0] /= W[0].norm();
      W[1] = 0.3 * turned(W[0], axis, gamma);

      Pair               change;
      const Tensor<1, 3> any_axis = random_vector();
      for (unsigned int k = 0; k < 2; ++k)
        change[k] = turned(W[k], any_axis, 2.8) - W[k];
      rigid = std::max(rigid, std::abs(JointAngle(W, change).angle));

      // the angle between them becomes smaller
      constexpr double small = 1e-4;
      change = {{turned(W[0], axis, small) - W[0], Tensor<1, 3>()}};
      relative =
        std::max(relative, std::abs(JointAngle(W, change).angle / small - 1));
      change  = {{small * W[0], -2 * small * W[1]}};
      stretch = std::max(stretch, std::abs(JointAngle(W, change).angle));

      for (Tensor<1, 3> &d : change)
        d = 0.3 * random_vector();
      const JointAngle joint(W, change);
      for (unsigned int k = 0; k < 2; ++k)
        {
          constexpr double   step = 1e-4;
          const Tensor<1, 3> d    = step * random_vector();
          Pair               up = change, down = change;
          up[k] += d / 2;
          down[k] -= d / 2;
          const JointAngle above(W, up), below(W, down);
          first = std::max(
            first,
            std::abs(above.angle - below.angle - joint.gradient[k] * d) / step);
          for (unsigned int l = 0; l < 2; ++l)
            second = std::max(second,
                              (above.gradient[l] - below.gradient[l] -
                               joint.curvature[k][l] * d)
                                  .norm() /
                                step);
        }
    }
  check_small("rigid motion", rigid, 1e-13);
  check_small("relative rotation", relative, 5e-4);
  check_small("stretch", stretch, 1e-6);
  check_small("first derivative", first, 1e-9);
  check_small("second derivative", second, 1e-9);
}
