// SPDX-License-Identifier: LGPL-2.1-or-later

// With cords that go slack, the internal force of an element is the derivative
// of its energy and the tangent that of the force; resultants are continuous
// and proportional to the strains.

#include <algorithm>

#include <biface/element/nonlinear_plies.h>
#include <biface/laminate/layup.h>

#include "one_cell.h"
#include <cord_ply.h>
#include <tests.h>

using namespace dealii;
using namespace Biface;

namespace
{
  template <int n>
  Tensor<1, n>
  some_vector(const double size, const unsigned int seed)
  {
    Tensor<1, n> vector;
    for (unsigned int i = 0; i < n; ++i)
      vector[i] = size * some_number(100 * seed + i);
    return vector;
  }


  Laminate
  laminate(const ThicknessLaw law, const bool prestressed)
  {
    Layup::Parameters parameters;
    parameters.law = law;
    if (prestressed)
      parameters.initial_stresses =
        parse_ply_stresses("stresses", "20 1 0, -30 0 1, 0 0 0, 10 0 0");
    auto materials               = cord_ply();
    materials[0].E_L_compression = "E_L/100";
    return Layup(parameters, materials).laminate(0);
  }


  using NodalVector = MixedElement::NodalVector;

  void
  test(const ElementGeometry &geometry,
       const ThicknessLaw     law,
       const bool             prestressed)
  {
    const Laminate       plies = laminate(law, prestressed);
    const ModeStiffness  taut(plies.stiffness(), geometry.formulation);
    const NonlinearPlies cords(plies, geometry.formulation);

    const auto resultants = [&](const Modes::Vector &E) {
      return taut.resultants(E) + cords.resultants(E);
    };
    const auto force_at = [&](const NodalVector &V) {
      const MixedElement element(geometry, V);
      return element.internal_force(resultants(element.strain()),
                                    Modes::Vector());
    };
    const auto energy_at = [&](const NodalVector &V) {
      const Modes::Vector E = MixedElement(geometry, V).strain();
      return geometry.weight *
             (Modes::mean_product(taut.resultants(E), E) / 2 + cords.energy(E));
    };

    const double      step = 1e-5;
    const NodalVector V = some_vector<24>(-0.05, 1), dV = some_vector<24>(1, 2);
    const MixedElement element(geometry, V);

    // each Gauss point has cords of its own that are slack
    const auto   slack = cords.slack_thickness(element.strain());
    const double most  = *std::max_element(slack.begin(), slack.end());
    const double least = *std::min_element(slack.begin(), slack.end());
    check_range("  slack cords", most / cords.thickness_of_cords(), 0.3, 0.99);
    if (!prestressed)
      check_true("  not the same everywhere", least < most);

    if (law != ThicknessLaw::asymmetric)
      {
        const double difference =
          (energy_at(V + step * dV) - energy_at(V - step * dV)) / (2 * step);
        check_small("  internal force",
                    force_at(V) * dV - difference,
                    1e-8,
                    force_at(V).norm() * dV.norm());
      }

    NonlinearPlies::Stiffness lacking;
    check_true("  any", cords.stiffness(element.strain(), lacking));
    MixedElement::NodalMatrix K{}, K_taut{};
    element.add_tangent(taut, resultants(element.strain()), K, &lacking);
    element.add_tangent(taut, resultants(element.strain()), K_taut);
    const double scale = maximum_entry(K_taut);
    double       lack  = 0;
    for (unsigned int j = 0; j < 24; ++j)
      for (unsigned int i = 0; i < 24; ++i)
        lack = std::max(lack, std::abs(K[i][j] - K_taut[i][j]));
    check_small(
      "  tangent", deviation_of_tangent(K, force_at, V, step), 1e-8, scale);
    check_range("  what it lacks", lack / scale, 0.01, 1);

    const Modes::Vector E = element.strain();
    if (!prestressed)
      check_small("  proportional to the strains",
                  (resultants(7 * E) - 7 * resultants(E)).norm(),
                  1e-14,
                  resultants(7 * E).norm());

    // through zero strain: as small as the strains themselves
    const double scale_H = resultants(E).norm();
    check_small("  continuous",
                (resultants(1e-9 * E) - resultants(-1e-9 * E)).norm(),
                1e-8,
                scale_H);

    // constant strains have the resultants of the laminate with these cords
    const Resultants::Vector constant = some_vector<Resultants::n>(0.1, 5);
    Resultants::Vector       expected = plies.stiffness() * constant;
    for (const CordPoint &cord : plies.cord_points())
      {
        double e = 0;
        for (unsigned int s = 0; s < Resultants::n_tangential; ++s)
          e += cord.direction[s] * constant[s];
        for (unsigned int s = 0; s < Resultants::n_tangential; ++s)
          expected[s] +=
            cord.law->response(e).stress * cord.thickness * cord.direction[s];
      }
    check_small(
      "  constant strains",
      (resultants(Modes::constant(constant)) - Modes::constant(expected))
        .norm(),
      1e-14,
      expected.norm());
  }
} // namespace


int
main()
{
  const std::array<std::string, 2> cell{{"40:45:1", "10:15:1"}};
  for (const auto formulation : {Formulation::paper, Formulation::standard})
    {
      const auto geometry =
        make_cells(torus(),
                   cell,
                   laminate(ThicknessLaw::symmetric, false).face_heights(),
                   formulation)[0]
          .geometry;
      const auto run = [&](const std::string &name,
                           const ThicknessLaw law,
                           const bool         prestressed) {
        std::cout << name << ", " << name_of(formulation) << std::endl;
        test(geometry, law, prestressed);
      };
      run("symmetric law", ThicknessLaw::symmetric, false);
      run("asymmetric law", ThicknessLaw::asymmetric, false);
      run("prestressed plies", ThicknessLaw::symmetric, true);
    }
}
