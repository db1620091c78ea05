// SPDX-License-Identifier: LGPL-2.1-or-later

// A ply of cords in rubber: without cords it is the rubber; its constants are
// those of the formulas, worked out by hand; rubber that keeps its volume makes
// it rigid against a change of area across inextensible cords; and the number
// of cords is the same at every radius, whatever the thickness does.

#include <deal.II/base/numbers.h>

#include <biface/laminate/layup.h>
#include <biface/laminate/material.h>
#include <biface/laminate/material_parameters.h>

#include <tests.h>

using namespace dealii;
using namespace Biface;

namespace
{
  MaterialParameters
  nylon()
  {
    MaterialParameters material;
    material.name                   = "nylon";
    material.type                   = MaterialParameters::Type::cord_and_rubber;
    material.cord_and_rubber.E_cord = 2400;
    material.cord_and_rubber.E_rubber      = 6;
    material.cord_and_rubber.cord_diameter = 0.6;
    material.cord_and_rubber.cord_pitch    = 1;
    return material;
  }


  void
  check_plies(const CordAndRubber::Thickness law)
  {
    MaterialParameters material        = nylon();
    material.cord_and_rubber.thickness = law;
    Layup::Parameters parameters;
    parameters.plies = parse_plies("plies", "nylon: 1.1 @ +-lift(beta_c)");
    parameters.angle_reference = AngleReference::circumference;
    SurfaceOfPlies surface;
    surface.radius = [](const double alpha_1) { return 100 - alpha_1; };
    surface.crown_cord_angle = 38;
    const Layup layup(parameters, {material}, surface);

    const double degree = numbers::PI / 180;
    double       number = 0, stiffness = 0, thickness = 0, modulus = 0;
    for (const double alpha_1 : {0., 10., 40.})
      {
        const Laminate laminate = layup.laminate(alpha_1);
        for (const Ply &ply : laminate.get_plies())
          {
            const double r    = 100 - alpha_1;
            const double beta = std::acos(std::cos(38 * degree) * r / 100);
            // cords that a parallel circle meets, relative to the crown
            number = std::max(number,
                              std::abs(r * std::sin(beta) / ply.cord_pitch -
                                       100 * std::sin(38 * degree)));
            // the cords' share in the stiffness of the ply
            const double v =
              numbers::PI / 4 * 0.36 / (ply.cord_pitch * ply.thickness);
            stiffness = std::max(
              stiffness,
              (material.laws(v).stiffness - ply.laws.stiffness).norm());
            thickness = std::max(
              thickness, std::abs(ply.thickness * ply.cord_pitch - 1.1));
            modulus = std::max(modulus, std::abs(ply.thickness - 1.1));
          }
      }
    check_small("  number of cords", number, 1e-12, 100);
    check_small("  stiffness", stiffness, 1e-12, 600);
    check_small(
      law == CordAndRubber::Thickness::constant_volume ? "  constant volume"
                                                       : "  constant thickness",
      law == CordAndRubber::Thickness::constant_volume ? thickness : modulus,
      1e-14);
  }
} // namespace


int
main()
{
  MaterialParameters material = nylon();
  CordAndRubber     &cords    = material.cord_and_rubber;

  check_small("no cords",
              (material.laws(0).stiffness -
               Material::isotropic(6, 0.49).stiffness("rubber"))
                .norm(),
              1e-12,
              100);

  // v = pi 0.36/4/1.1, eta = 399/402, eta_G = 1 - 2/(1 + G_c/G_r)
  const double   v           = numbers::PI * 0.09 / 1.1;
  const Material halpin_tsai = cords.ply_material(v);
  check_small("E_L", halpin_tsai.E_1 - (v * 2400 + (1 - v) * 6), 1e-12);
  check_small("E_T by Halpin-Tsai",
              halpin_tsai.E_2 -
                6 * (1 + 2 * v * 399 / 402) / (1 - v * 399 / 402),
              1e-12);
  const double ratio = 400 * 1.49 / 1.3, eta = 1 - 2 / (1 + ratio);
  check_small("G_LT by Halpin-Tsai",
              halpin_tsai.G_12 - 6 / 2.98 * (1 + eta * v) / (1 - eta * v),
              1e-12);
  check_small("nu_LT", halpin_tsai.nu_12 - (0.3 * v + 0.49 * (1 - v)), 1e-15);

  cords.homogenization          = CordAndRubber::Homogenization::akasaka_hirano;
  const Material akasaka_hirano = cords.ply_material(v);
  check_small("E_T by Akasaka-Hirano", akasaka_hirano.E_2 - 8 / (1 - v), 1e-12);
  check_small(
    "G_LT by Akasaka-Hirano", akasaka_hirano.G_12 - 2 / (1 - v), 1e-12);
  check_small("nu_LT by Akasaka-Hirano", akasaka_hirano.nu_12 - 0.5, 0);

  // across inextensible cords, an incompressible ply only shears
  for (const auto homogenization :
       {CordAndRubber::Homogenization::halpin_tsai,
        CordAndRubber::Homogenization::akasaka_hirano})
    {
      cords.homogenization = homogenization;
      cords.E_cord         = 6e9;
      cords.nu_rubber      = 0.5 - 1e-7;
      const Material rigid = cords.ply_material(v);
      check_small("nu_TT of incompressible rubber", rigid.nu_23 - 1, 1e-5);
      check_small(
        "G_TT is a quarter of E_T", 4 * rigid.G_23 / rigid.E_2 - 1, 1e-5);
      material.laws(v); // positive definite
    }

  std::cout << "constant volume" << std::endl;
  check_plies(CordAndRubber::Thickness::constant_volume);
  std::cout << "thickness as given" << std::endl;
  check_plies(CordAndRubber::Thickness::as_given);
}
