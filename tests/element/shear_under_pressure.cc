// SPDX-License-Identifier: LGPL-2.1-or-later

// Under a pressure p the tangent shear modulus of a wall with a linear law is G
// if its thickness strain is that of the distance along the normal, and G - p,
// from the pressure on the deformed face, if it is that of the director. That
// of neo-Hookean rubber is G with both.

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
  rubber(const MaterialParameters::Type type, const bool normal_thickness)
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
    layup.set_thickness_strain_along_normal(normal_thickness);
    return layup.laminate(0);
  }


  /** The second derivative of the energy of a cube of rubber by the
   * displacement of its outer face along itself.
   * @param closer by which that face is closer to the inner one. */
  double
  tangent_modulus(const Formulation              formulation,
                  const MaterialParameters::Type type,
                  const bool                     normal_thickness,
                  const double                   closer,
                  double                        &pressure)
  {
    const ElementGeometry geometry = make_cells(Plane(),
                                                {{"0:1:1", "0:1:1"}},
                                                {{0, 1}},
                                                formulation,
                                                normal_thickness)[0]
                                       .geometry;
    MixedElement::NodalVector V, shear, across;
    for (unsigned int v = 0; v < 4; ++v)
      {
        add_face_displacement(Tensor<1, 3>({0, 0, -closer}), v, 1, V);
        add_face_displacement(Tensor<1, 3>({1, 0, 0}), v, 1, shear);
        add_face_displacement(Tensor<1, 3>({0, 0, -1}), v, 1, across);
      }
    const MixedElement   element(geometry, V);
    const Modes::Vector  E        = element.strain();
    const Laminate       laminate = rubber(type, normal_thickness);
    const NonlinearPlies plies(laminate, formulation);
    const ModeStiffness  linear(plies.is_whole_law() ? Resultants::Matrix()
                                                    : laminate.stiffness(),
                               formulation);
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
  using Type = MaterialParameters::Type;
  for (const double closer : {0., 0.003, 0.01, 0.018})
    {
      double p = 0;
      for (const auto formulation :
           {Formulation::vertices, Formulation::standard})
        check_small(
          "normal",
          tangent_modulus(formulation, Type::isotropic, true, closer, p) - G,
          1e-12,
          G);
      for (const auto formulation : all_elements())
        {
          const double modulus =
            tangent_modulus(formulation, Type::isotropic, false, closer, p);
          check_small("director", modulus - (G - p / (1 - closer)), 1e-12, G);
        }
      check_range("pressure, MPa", p, 0, 2);
      for (const auto formulation : all_elements())
        for (const bool normal_thickness : {false, true})
          if (formulation != Formulation::paper || !normal_thickness)
            check_small(
              "neo-Hooke",
              tangent_modulus(
                formulation, Type::neo_Hooke, normal_thickness, closer, p) -
                G,
              1e-12,
              G);
      check_range("pressure, MPa", p, 0, 2);
    }
}
