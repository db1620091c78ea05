// SPDX-License-Identifier: LGPL-2.1-or-later

// The shear stresses between the plies of a wall do not depend on the layers
// into which it is divided, if these have the shear forces of one layer.

#include <deal.II/base/quadrature_lib.h>

#include <biface/laminate/interlaminar_shear.h>

#include "random_laminate.h"
#include <tests.h>

using namespace dealii;
using namespace Biface;

namespace
{
  /** A part of the plies of a wall, as a layer. */
  TransverseShear
  layer(const std::vector<Ply> &plies)
  {
    return Laminate(plies, ThicknessLaw::symmetric, 0).get_transverse_shear();
  }


  /** The integral of the stresses of a wall over one of its plies. */
  Tensor<1, 2>
  shear_force(const Laminate           &wall,
              const Resultants::Vector &E,
              const unsigned int        ply,
              const double              begin)
  {
    const QGauss<1> quadrature(4);
    Tensor<1, 2>    sum;
    const double    t = wall.get_plies()[ply].thickness;
    for (unsigned int q = 0; q < quadrature.size(); ++q)
      sum +=
        t * quadrature.weight(q) *
        wall.interlaminar_stress(E, ply, begin + t * quadrature.point(q)[0]);
    return sum;
  }


  void
  test(const std::string &name, const std::vector<Ply> &plies)
  {
    const Laminate     wall(plies, ThicknessLaw::symmetric, 0);
    Resultants::Vector E;
    for (unsigned int i = 6; i < 10; ++i)
      E[i] = 0.1 * i - 0.5;

    std::vector<TransverseShear> layers;
    std::vector<Tensor<1, 2>>    shear_forces;
    double                       z = 0, largest = 0;
    for (unsigned int k = 0; k < plies.size(); ++k)
      {
        layers.push_back(layer({plies[k]}));
        shear_forces.push_back(shear_force(wall, E, k, z));
        largest = std::max(
          largest,
          wall.interlaminar_stress(E, k, z + plies[k].thickness / 2).norm());
        z += plies[k].thickness;
      }
    const TransverseShear  &of_wall = wall.get_transverse_shear();
    const InterlaminarShear one({layer(plies)}, of_wall),
      stack(layers, of_wall);

    double of_one = 0, of_stack = 0;
    z = 0;
    for (unsigned int k = 0; k < plies.size(); ++k)
      {
        for (const double fraction : {0., 0.3, 1.})
          {
            const double       above = fraction * plies[k].thickness;
            const Tensor<1, 2> expected =
              wall.interlaminar_stress(E, k, z + above);
            of_one = std::max(
              of_one,
              (one.stress({wall.shear_force(E)}, 0, k, z + above) - expected)
                .norm());
            of_stack = std::max(
              of_stack,
              (stack.stress(shear_forces, k, 0, above) - expected).norm());
          }
        z += plies[k].thickness;
      }
    check_small(name + ", one layer", of_one, 1e-11, largest);
    check_small(name + ", a layer per ply", of_stack, 1e-9, largest);
    check_small(
      "  at the outer face",
      stack.stress(shear_forces, plies.size() - 1, 0, plies.back().thickness)
        .norm(),
      1e-9,
      largest);
  }
} // namespace


int
main()
{
  std::mt19937 generator(1);
  for (unsigned int n = 0; n < 3; ++n)
    test("plies at random", random_plies(generator));

  const auto stiff = Material::isotropic(1e6, 0.3).stiffness("facing");
  const auto soft  = Material::isotropic(1, 0.3).stiffness("core");
  test("sandwich",
       {{{stiff}, 0.1, 0, {}, 0},
        {{soft}, 10, 0, {}, 1},
        {{stiff}, 0.1, 0, {}, 2}});
}
