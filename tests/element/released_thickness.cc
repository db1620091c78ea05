// SPDX-License-Identifier: LGPL-2.1-or-later

// ModeStiffness::release_thickness_strain(): a thickness strain that varies has
// the resultants of the laminate where the tangential strains that its group
// lacks follow so that theirs are zero; constant strains, and others where the
// thickness strain has no resultant, have the law of the laminate. With any
// cords slack the law remains positive definite, and the tangent is the
// derivative of the force.

#include <deal.II/lac/lapack_full_matrix.h>

#include <algorithm>

#include <biface/element/nonlinear_plies.h>
#include <biface/laminate/layup.h>
#include <biface/laminate/material_parameters.h>

#include "one_cell.h"
#include "some_vector.h"
#include <cord_ply.h>
#include <tests.h>

using namespace dealii;
using namespace Biface;

namespace
{
  Laminate
  laminate(const double compression)
  {
    auto materials               = cord_ply();
    materials[0].E_L_compression = std::to_string(compression) + "*E_L";
    MaterialParameters rubber;
    rubber.name = "rubber";
    rubber.type = MaterialParameters::Type::isotropic;
    rubber.E    = 1.8;
    rubber.nu   = 0.499;
    materials.push_back(rubber);
    Layup::Parameters parameters;
    parameters.plies =
      parse_plies("plies", "cord: 1.2 @ 30, cord: 1.2 @ -50, rubber: 3 @ 0");
    return Layup(parameters, materials).laminate(0);
  }


  void
  test_law(const Formulation formulation)
  {
    using Resultants::thickness;
    const Laminate      plies = laminate(1);
    const ModeStiffness without(plies.stiffness(), formulation);
    ModeStiffness       stiffness = without;
    stiffness.release_thickness_strain(plies.stiffness_of_slack_cords());

    // strains in which the thickness strain that varies has no resultant
    const auto free = [](const ModeStiffness &law) {
      Modes::Vector E = some_vector<Modes::n>(0.1, 1);
      for (unsigned int m = 1; m < 4; ++m)
        {
          const unsigned int i = Modes::mode_of[m][thickness];
          Modes::Vector      unit;
          unit[i] = 1;
          E[i]    = 0;
          E[i]    = -law.resultants(E)[i] / law.resultants(unit)[i];
        }
      return law.resultants(E);
    };
    check_small("constant strains, and others without H_33",
                (free(stiffness) - free(without)).norm(),
                1e-12,
                free(without).norm());

    // the softest choice of the missing strains, by a search along each
    for (unsigned int m = 1; m < 4; ++m)
      {
        Modes::Vector unit;
        unit[Modes::mode_of[m][thickness]] = 1;
        const Modes::Vector H              = stiffness.resultants(unit);

        Resultants::Vector strain;
        strain[thickness] = 1;
        const auto &D     = plies.stiffness();
        const bool  twist = formulation == Formulation::standard &&
                           Modes::mode_of[m][Modes::twist] != Modes::n;
        for (unsigned int sweep = 0; sweep < 20000; ++sweep)
          for (unsigned int s = 0; s < Resultants::n_tangential; ++s)
            if (Modes::mode_of[m][s] == Modes::n)
              {
                Resultants::Vector direction;
                direction[s] = 1;
                if (twist && s >= 4)
                  direction[4] = direction[5] = 1;
                strain -= (direction * (D * strain)) /
                          (direction * (D * direction)) * direction;
              }
        const Resultants::Vector expected  = D * strain;
        double                   deviation = 0;
        for (unsigned int s = 0; s < Resultants::n; ++s)
          if (Modes::mode_of[m][s] != Modes::n)
            deviation =
              std::hypot(deviation, H[Modes::mode_of[m][s]] - expected[s]);
        check_small("resultants of group " + std::to_string(m),
                    deviation,
                    1e-8,
                    H.norm());
        check_range("  softer by the factor",
                    H[Modes::mode_of[m][thickness]] / D[thickness][thickness],
                    1e-4,
                    0.7);
      }
  }


  void
  test_slack(const Formulation formulation)
  {
    // cords that vanish in compression
    const Laminate plies = laminate(1e-6);
    ModeStiffness  stiffness(plies.stiffness(), formulation);
    stiffness.release_thickness_strain(plies.stiffness_of_slack_cords());
    const NonlinearPlies cords(plies, formulation);
    const TestCell       cell = make_cells(
      torus(), {{"10:20:1", "5:12:1"}}, plies.face_heights(), formulation)[0];

    const auto force_at = [&](const MixedElement::NodalVector &V) {
      const MixedElement  element(cell.geometry, V);
      const Modes::Vector E = element.strain();
      return element.internal_force(
        stiffness.resultants(E) + cords.resultants(E), Modes::Vector());
    };
    const auto V = some_vector<24>(-0.05, 1), dV = some_vector<24>(1e-5, 2);
    const MixedElement        element(cell.geometry, V);
    const Modes::Vector       E = element.strain();
    NonlinearPlies::Stiffness lacking;
    cords.stiffness(E, lacking);
    MixedElement::NodalMatrix K{};
    element.add_tangent(
      stiffness, stiffness.resultants(E) + cords.resultants(E), K, &lacking);
    MixedElement::NodalVector product;
    for (unsigned int i = 0; i < 24; ++i)
      for (unsigned int j = 0; j < 24; ++j)
        product[i] += K[i][j] * dV[j];
    check_small("tangent",
                (product - (force_at(V + dV) - force_at(V - dV)) / 2).norm(),
                1e-8,
                product.norm());

    // the energy of strains that make any of the cords slack
    double lowest = 1;
    for (unsigned int i = 0; i < 2000; ++i)
      {
        Modes::Vector E = some_vector<Modes::n>(1, 10 + i);
        if (formulation != Formulation::standard)
          for (const auto &modes : Modes::mode_of)
            if (modes[Modes::twist] != Modes::n)
              E[modes[Modes::twist]] = 0;
        const double taut = Modes::mean_product(stiffness.resultants(E), E) / 2;
        lowest            = std::min(lowest, 1 + cords.energy(E) / taut);
      }
    check_range(
      "energy with slack cords over that with taut ones", lowest, 1e-3, 1);

    // all of them, against all strains
    const unsigned int       n = Modes::n;
    LAPACKFullMatrix<double> matrix(n);
    for (unsigned int j = 0; j < n; ++j)
      {
        Modes::Vector unit;
        unit[j]                    = 1;
        const Modes::Vector column = stiffness.resultants(unit);
        for (unsigned int i = 0; i < n; ++i)
          matrix(i, j) = column[i];
      }
    Modes::Vector compressed;
    for (unsigned int s = 0; s < 4; ++s)
      compressed[s] = -1;
    NonlinearPlies::Stiffness all;
    cords.stiffness(compressed, all);
    for (const Modes::Group &group : Modes::groups)
      for (unsigned int i = 0; i < group.size; ++i)
        for (unsigned int j = 0; j < n; ++j)
          matrix(group.first_mode + i, j) +=
            all[group.first_mode + i][j] / group.weight(i);
    matrix.compute_eigenvalues();
    std::vector<double> values;
    for (unsigned int i = 0; i < n; ++i)
      values.push_back(matrix.eigenvalue(i).real());
    std::sort(values.begin(), values.end());
    // without the twist its two modes have no stiffness
    const unsigned int first = formulation == Formulation::standard ? 0 : 2;
    check_range("lowest eigenvalue over the highest",
                values[first] / values.back(),
                1e-5,
                1);
  }
} // namespace


int
main()
{
  for (const auto formulation : all_elements())
    {
      std::cout << "formulation: " << name_of(formulation) << std::endl;
      test_law(formulation);
      test_slack(formulation);
    }
}
