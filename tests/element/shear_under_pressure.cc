// SPDX-License-Identifier: LGPL-2.1-or-later

// Under a pressure p the tangent shear modulus of a wall with a linear law is G
// if its thickness strain is that of the distance along the normal, and G - p,
// from the pressure on the deformed face, with the other ones. That of
// neo-Hookean rubber is G with any of them.

#include <biface/element/nonlinear_plies.h>
#include <biface/laminate/layup.h>
#include <biface/laminate/material_parameters.h>

#include "one_cell.h"
#include <tests.h>

using namespace dealii;
using namespace Biface;

namespace
{
  constexpr double G = 2, nu = 0.49; // MPa

  Laminate
  rubber(const MaterialParameters::Type type, const ThicknessStrain strain)
  {
    MaterialParameters material;
    material.name = "rubber";
    material.type = type;
    if (type == MaterialParameters::Type::isotropic)
      material.E = 2 * (1 + nu) * G;
    else
      material.mu = G;
    material.nu = nu;
    Layup::Parameters parameters;
    parameters.plies = parse_plies("Laminate/Plies", "rubber: 1 @ 0");
    Layup layup(parameters, {material});
    layup.set_thickness_strain_along_normal(strain == ThicknessStrain::normal);
    return layup.laminate(0);
  }


  /** The second derivative of the energy of a cube of rubber by the
   * displacement of its outer face along itself.
   * @param closer by which that face is closer to the inner one. */
  double
  tangent_modulus(ElementGeometry                geometry,
                  const MaterialParameters::Type type,
                  const ThicknessStrain          thickness_strain,
                  const double                   closer,
                  double                        &pressure)
  {
    geometry.thickness_strain = thickness_strain;
    MixedElement::NodalVector V, shear, across;
    for (unsigned int v = 0; v < 4; ++v)
      {
        add_face_displacement(Tensor<1, 3>({0, 0, -closer}), v, 1, V);
        add_face_displacement(Tensor<1, 3>({1, 0, 0}), v, 1, shear);
        add_face_displacement(Tensor<1, 3>({0, 0, -1}), v, 1, across);
      }
    const MixedElement        element(geometry, V);
    const Modes::Vector       E        = element.strain();
    const Laminate            laminate = rubber(type, thickness_strain);
    const NonlinearPlies      plies(laminate);
    const ModeStiffness       linear(plies.is_whole_law() ? Resultants::Matrix()
                                                    : laminate.stiffness());
    NonlinearPlies::Stiffness added;
    plies.stiffness(E, added);
    const Modes::Vector H = linear.resultants(E) + plies.resultants(E);
    pressure              = element.internal_force(H, Modes::Vector()) * across;

    MixedElement::NodalMatrix K{};
    element.add_tangent(linear, H, K, &added);
    double result = 0;
    for (unsigned int i = 0; i < 24; ++i)
      for (unsigned int j = 0; j < 24; ++j)
        result += shear[i] * K[i][j] * shear[j];
    return result;
  }
} // namespace


int
main()
{
  const ElementGeometry geometry =
    make_cells(Plane(),
               {{"0:1:1", "0:1:1"}},
               [](const double) {
                 return std::array<double, 2>{{0, 1}};
               })[0]
      .geometry;
  using Type = MaterialParameters::Type;
  for (const double closer : {0., 0.003, 0.01, 0.018})
    {
      double p = 0;
      check_small(
        "normal",
        tangent_modulus(
          geometry, Type::isotropic, ThicknessStrain::normal, closer, p) -
          G,
        1e-12,
        G);
      for (const auto thickness_strain :
           {ThicknessStrain::vertices, ThicknessStrain::mean_director})
        {
          const double modulus = tangent_modulus(
            geometry, Type::isotropic, thickness_strain, closer, p);
          check_small("others", modulus - (G - p / (1 - closer)), 1e-12, G);
        }
      check_range("pressure, MPa", p, 0, 2);
      for (const auto thickness_strain : {ThicknessStrain::vertices,
                                          ThicknessStrain::mean_director,
                                          ThicknessStrain::normal})
        check_small("neo-Hooke",
                    tangent_modulus(
                      geometry, Type::neo_Hooke, thickness_strain, closer, p) -
                      G,
                    1e-12,
                    G);
      check_range("pressure, MPa", p, 0, 2);
    }
}
