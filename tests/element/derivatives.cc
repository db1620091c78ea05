// SPDX-License-Identifier: LGPL-2.1-or-later

// The variation of the strains, the internal force and the tangent of an
// element are the derivatives of its strains, energy and internal force.

#include <biface/laminate/layup.h>

#include "one_cell.h"
#include "some_vector.h"
#include <cord_ply.h>
#include <tests.h>

using namespace dealii;
using namespace Biface;

namespace
{
  using NodalVector = MixedElement::NodalVector;

  void
  test_strain(const ElementGeometry &geometry)
  {
    const NodalVector V = some_vector<24>(0.3, 1), dV = some_vector<24>(0.3, 2);
    const auto variation = MixedElement(geometry, V).strain_variation(dV);
    // exact, since the strains are quadratic
    const auto difference = (MixedElement(geometry, V + dV).strain() -
                             MixedElement(geometry, V - dV).strain()) /
                            2;
    check_small("variation of the strains",
                (variation - difference).norm(),
                1e-13,
                variation.norm());
    check_range(
      "far from that at rest",
      (variation - MixedElement(geometry, NodalVector()).strain_variation(dV))
          .norm() /
        variation.norm(),
      0.01,
      10);
  }


  void
  test_law(const ElementGeometry &geometry,
           const ThicknessLaw     law,
           const bool             with_initial_resultants)
  {
    Layup::Parameters parameters;
    parameters.law = law;
    const ModeStiffness stiffness(
      Layup(parameters, cord_ply()).laminate(0).stiffness(),
      geometry.formulation);

    const double      step = 1e-4;
    const NodalVector V = some_vector<24>(0.3, 1), dV = some_vector<24>(1, 2);
    // initial resultants as large as those of the strains
    Modes::Vector H_0;
    if (with_initial_resultants)
      H_0 = some_vector<Modes::n>(
        stiffness.resultants(MixedElement(geometry, V).strain()).norm(), 3);

    const ElasticElement elastic{geometry, stiffness, H_0};
    const auto           force_at = [&](const NodalVector &V) {
      return elastic.force(V);
    };

    if (law != ThicknessLaw::asymmetric)
      {
        const double difference =
          (elastic.energy(V + step * dV) - elastic.energy(V - step * dV)) /
          (2 * step);
        check_small("  internal force",
                    force_at(V) * dV - difference,
                    1e-8,
                    force_at(V).norm() * dV.norm());
      }

    const MixedElement        element(geometry, V);
    MixedElement::NodalMatrix K{};
    element.add_tangent(
      stiffness, stiffness.resultants(element.strain()) + H_0, K);
    const double scale = maximum_entry(K);
    check_small(
      "  tangent", deviation_of_tangent(K, force_at, V, step), 1e-8, scale);

    NodalVector product = element.tangent_product(
      stiffness, stiffness.resultants(element.strain()) + H_0, dV);
    const double size = product.norm();
    for (unsigned int i = 0; i < 24; ++i)
      for (unsigned int j = 0; j < 24; ++j)
        product[i] -= K[i][j] * dV[j];
    check_small("  product with the tangent", product.norm(), 1e-12, size);

    if (law != ThicknessLaw::asymmetric)
      {
        double asymmetry = 0;
        for (unsigned int i = 0; i < 24; ++i)
          for (unsigned int j = 0; j < i; ++j)
            asymmetry = std::hypot(asymmetry, std::abs(K[i][j] - K[j][i]));
        check_small("  symmetry of the tangent", asymmetry, 1e-13, scale);
      }
  }
} // namespace


int
main()
{
  const Laminate laminate = Layup(Layup::Parameters(), cord_ply()).laminate(0);
  const std::array<std::string, 2> cell{{"40:45:1", "10:15:1"}};
  for (const auto formulation : all_elements())
    {
      std::cout << "formulation: " << name_of(formulation) << std::endl;
      const ElementGeometry geometry =
        make_cells(torus(), cell, laminate.face_heights(), formulation)[0]
          .geometry;
      // faces that rise over the reference surface, both
      const ElementGeometry tapered =
        make_cells(
          torus(),
          cell,
          FaceHeights([](const double alpha_1) {
            return std::array<double, 2>{{-3 * alpha_1, 2 + 4 * alpha_1}};
          }),
          formulation)[0]
          .geometry;

      test_strain(geometry);
      const std::string names[] = {"symmetric", "asymmetric"};
      for (const auto law : {ThicknessLaw::symmetric, ThicknessLaw::asymmetric})
        for (const bool with_initial_resultants : {false, true})
          {
            std::cout << names[static_cast<unsigned int>(law)] << " law"
                      << (with_initial_resultants ? ", initial resultants" : "")
                      << std::endl;
            test_law(geometry, law, with_initial_resultants);
          }

      std::cout << "tapered" << std::endl;
      test_strain(tapered);
      test_law(tapered, ThicknessLaw::symmetric, true);
    }
}
