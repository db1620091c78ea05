// SPDX-License-Identifier: LGPL-2.1-or-later

// With transverse shear from equilibrium, the layers of a wall have the
// stiffness kappa_k int G with kappa_k = Q_k^2/(int G int F^2/G), F and its
// integrals Q_k over the layers being those of the wall; all their energy under
// the shear forces Q_k is that of the wall.

#include <biface/laminate/layup.h>
#include <biface/laminate/material_parameters.h>

#include <cord_ply.h>
#include <tests.h>

using namespace dealii;
using namespace Biface;

int
main()
{
  MaterialParameters material;
  material.name  = "m";
  material.type  = MaterialParameters::Type::isotropic;
  material.E     = 5;
  material.nu    = 0.25;
  const double G = 2, h = 3;

  Layup::Parameters parameters;
  parameters.plies     = parse_plies("plies", "m: 3 @ 0");
  parameters.shear_law = parse_transverse_shear("shear", "equilibrium");
  parameters.layers    = parse_layers("layers", "1/2, 1/6, 1/3");
  const auto layers    = Layup(parameters, {material}).layers(0, 0);

  // F = 3/(2h) (1 - s^2), s = -1 ... 1
  const auto first  = [](const double s) { return 0.75 * (s - s * s * s / 3); };
  const auto square = [&](const double s) {
    return 9 / (8 * h) * (s - 2 * std::pow(s, 3) / 3 + std::pow(s, 5) / 5);
  };
  Resultants::Vector unit;
  for (const auto face : {Resultants::inner, Resultants::outer})
    unit[Resultants::transverse(0, face)] = 1;

  double begin = -1, energy = 0;
  for (unsigned int k = 0; k < 3; ++k)
    {
      const double end       = begin + 2 * layers[k]->thickness() / h;
      const double Q         = first(end) - first(begin);
      const double stiffness = Q * Q / ((square(end) - square(begin)) / G);
      check_small("stiffness of layer " + std::to_string(k + 1),
                  layers[k]->shear_force(unit)[0] - stiffness,
                  1e-12,
                  stiffness);
      energy += Q * Q / (2 * layers[k]->shear_force(unit)[0]);
      begin = end;
    }
  const double of_wall = 1 / (2 * 5. / 6 * G * h);
  check_small("energy", energy - of_wall, 1e-12, of_wall);
}
