// SPDX-License-Identifier: LGPL-2.1-or-later

// The angle by which two directors turn against each other about a line is zero
// in rigid motions of any size and in stretches, that of a relative rotation of
// any size about the line, and exact also if it is tiny; its derivatives are
// exact.

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
  using Vectors = JointAngle::Vectors;

  double rigid = 0, large = 0, tiny = 0, stretch = 0, first = 0, second = 0;
  for (unsigned int n = 0; n < 20; ++n)
    {
      // directors that need not be normal to the line
      Vectors x;
      x[2]               = 3 * random_vector();
      const double gamma = 0.1 + 3 * (n + 0.5) / 20;
      x[0]               = random_vector();
      x[1]               = 0.3 * turned(x[0], x[2], gamma) + 0.1 * x[2];

      Vectors            change;
      const Tensor<1, 3> axis = random_vector();
      for (unsigned int k = 0; k < 3; ++k)
        change[k] = turned(x[k], axis, 2.8) - x[k];
      rigid = std::max(rigid, std::abs(JointAngle(x, change).angle));

      for (const double angle : {-2.9, -1., 0.3, 1.7, 3.1})
        {
          change = {{Tensor<1, 3>(), turned(x[1], x[2], angle) - x[1], {}}};
          large =
            std::max(large, std::abs(JointAngle(x, change).angle - angle));
        }
      change = {{{}, 1e-20 * cross_product_3d(x[2], x[1]), {}}};
      tiny   = std::max(
        tiny,
        std::abs(JointAngle(x, change).angle / (1e-20 * x[2].norm()) - 1));
      change  = {{0.4 * x[0], -0.2 * x[1], 0.7 * x[2]}};
      stretch = std::max(stretch, std::abs(JointAngle(x, change).angle));

      for (unsigned int k = 0; k < 3; ++k)
        change[k] = 0.3 * x[k].norm() * random_vector();
      const JointAngle joint(x, change);
      for (unsigned int k = 0; k < 3; ++k)
        {
          constexpr double   step = 1e-5;
          const Tensor<1, 3> d    = step * x[k].norm() * random_vector();
          Vectors            up = change, down = change;
          up[k] += d / 2;
          down[k] -= d / 2;
          const JointAngle above(x, up), below(x, down);
          first = std::max(
            first,
            std::abs(above.angle - below.angle - joint.gradient[k] * d) / step);
          for (unsigned int l = 0; l < 3; ++l)
            second = std::max(second,
                              (above.gradient[l] - below.gradient[l] -
                               joint.curvature[l][k] * d)
                                  .norm() *
                                x[l].norm() / step);
        }
    }
  check_small("rigid motion", rigid, 1e-13);
  check_small("turn of any size", large, 1e-13);
  check_small("tiny turn", tiny, 1e-12);
  check_small("stretch", stretch, 1e-13);
  check_small("first derivatives", first, 1e-6);
  check_small("second derivatives", second, 1e-5);
}
