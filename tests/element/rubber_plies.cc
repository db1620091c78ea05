// SPDX-License-Identifier: LGPL-2.1-or-later

// With plies that are not linear, the internal force of an element is the
// derivative of its energy, and the tangent is that of the force, for every
// law, with other plies, every element and every law of the transverse shear.
// At small strains they have the resultants of the linear law. So they do in a
// step in which stresses relax, where they are constant without a change of
// strains and time. On a skewed cell they do not depend on the direction from
// which angles count.

#include <biface/element/nonlinear_plies.h>
#include <biface/element/quadrilateral_geometry.h>
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
  using Type        = MaterialParameters::Type;
  using NodalVector = MixedElement::NodalVector;

  std::vector<MaterialParameters>
  materials(const bool relaxing)
  {
    auto all                 = cord_ply();
    all[0].E_L_compression   = "E_L/50";
    all[0].compression_onset = "0.01";
    const auto add           = [&](const std::string &name, const Type type) {
      all.emplace_back();
      all.back().name = name;
      all.back().type = type;
      return &all.back();
    };
    {
      auto *rubber = add("neo-Hooke", Type::neo_Hooke);
      rubber->mu   = 1;
      rubber->K    = 50;
    }
    {
      auto *rubber = add("Mooney", Type::Mooney_Rivlin);
      rubber->c10  = 0.4;
      rubber->c01  = 0.1;
      rubber->nu   = 0.49;
    }
    {
      auto *rubber = add("Yeoh", Type::Yeoh);
      rubber->c10  = 0.4;
      rubber->c20  = -0.02;
      rubber->c30  = 0.01;
      rubber->nu   = 0.49;
    }
    {
      auto *rubber    = add("Ogden", Type::Ogden);
      rubber->mu_i    = {0.63, 0.0012, -0.01};
      rubber->alpha_i = {1.3, 5, -2};
      rubber->K       = 50;
    }
    auto *cords            = add("cords", Type::transversely_isotropic);
    cords->E_L             = 510.45;
    cords->G_LT            = 2.33;
    cords->matrix          = MaterialParameters::Matrix::neo_Hooke;
    cords->K               = 100;
    cords->E_L_compression = "E_L/20";
    for (MaterialParameters &material : all)
      {
        material.relaxation_times  = {1, 5};
        material.relaxation_moduli = {0.3, 0.2};
      }
    if (!relaxing)
      for (MaterialParameters &material : all)
        material.relaxation_times = material.relaxation_moduli = {};
    return all;
  }


  Layup
  layup(const std::string       &plies,
        const std::string       &shear,
        const ThicknessIntegrals integrals,
        const bool               along_normal,
        const bool               relaxing)
  {
    Layup::Parameters parameters;
    parameters.plies           = parse_plies("plies", plies);
    parameters.shear_law       = parse_transverse_shear("shear", shear);
    parameters.gradient_factor = 3;
    parameters.integrals       = integrals;
    SurfaceOfPlies surface;
    surface.curvature = [](const double) {
      return std::array<double, 2>{{0.01, 0.003}};
    };
    Layup result(parameters, materials(relaxing), surface);
    result.set_thickness_strain_along_normal(along_normal);
    return result;
  }


  /** What NonlinearPlies::Changes says of how the elastic stresses follow the
   * strains and what is added to the stresses, and the resultants the latter.
   */
  void
  check_changes(const NonlinearPlies &law,
                const Modes::Vector  &E,
                const HistoryOfPlies &history)
  {
    const Modes::Vector           dE   = some_vector<Modes::n>(1, 11);
    constexpr double              step = 1e-6;
    const NonlinearPlies::Changes changes(law, E, history);
    std::vector<double>           below, above, strains_below, strains_above;
    const auto                    check = [&](const std::string   &name,
                           const Modes::Vector &by_strain,
                           const double         by_internal) {
      const auto at = [&](const double         by,
                          std::vector<double> &stresses,
                          std::vector<double> &strains) {
        std::vector<double> internal(law.n_internal());
        for (unsigned int i = 0; i < internal.size(); ++i)
          internal[i] =
            history.internal[i] + by * by_internal * std::sin(2. + i);
        HistoryOfPlies changed = history;
        changed.internal       = internal.data();
        law.elastic_stresses(E + by * by_strain, changed, stresses, &strains);
        return law.added_stresses(changed);
      };
      std::vector<double>       added = at(step, above, strains_above);
      const std::vector<double> added_below = at(-step, below, strains_below);
      for (unsigned int i = 0; i < added.size(); ++i)
        added[i] = (added[i] - added_below[i]) / (2 * step);
      std::vector<double> change(below.size());
      changes.elastic_stresses(by_strain, added, change);
      double error = 0, size = 0;
      for (unsigned int i = 0; i < change.size(); ++i)
        {
          error = std::max(
            error, std::abs(change[i] - (above[i] - below[i]) / (2 * step)));
          size = std::max(size, std::abs(change[i]));
        }
      check_small(name, error, 1e-6, size);
    };
    check("  elastic stresses by what is added", Modes::Vector(), 1);
    check("  elastic stresses", dE, 0);

    // their work on the change of the strains
    std::vector<double> added;
    double              work = 0;
    unsigned int        i    = 0;
    for (unsigned int g = 0; g < Modes::n_gauss_points; ++g)
      for (const RelaxingStress &stress : law.relaxing_stresses())
        for (unsigned int c = 0; c < stress.n_components; ++c, ++i)
          {
            added.push_back(std::sin(1. + 3 * i));
            work += stress.thickness / Modes::n_gauss_points * added[i] *
                    (strains_above[i] - strains_below[i]) / (2 * step);
          }
    check_small("  added stresses",
                Modes::mean_product(changes.resultants(added), dE) - work,
                1e-6,
                std::abs(work));
  }


  /** A warped cell, the direction of whose material is turned by an angle. */
  ElementGeometry
  skewed_cell(const Laminate &laminate,
              const bool      normal_thickness,
              const double    angle = 0)
  {
    QuadrilateralPoints               points;
    const std::array<Tensor<1, 3>, 4> positions{{Tensor<1, 3>({0, 0, 0}),
                                                 Tensor<1, 3>({9, 2, 1}),
                                                 Tensor<1, 3>({-2, 7, 0.5}),
                                                 Tensor<1, 3>({11, 10, 0})}};
    for (unsigned int q = 0; q < 4; ++q)
      {
        SurfacePoint &point = points.vertices[q];
        point.position      = Point<3>(positions[q]);
        Tensor<1, 3> normal({0.1 * some_number(q), -0.05 * q, 1});
        point.frame[2] = normal / normal.norm();
        point.frame[0] = cross_product_3d(Tensor<1, 3>({0, 1, 0}), normal);
        point.frame[0] /= point.frame[0].norm();
        point.frame[1]    = cross_product_3d(point.frame[2], point.frame[0]);
        points.heights[q] = laminate.face_heights();
      }
    points.direction = Tensor<1, 3>({-0.4, 1, 0});
    // in the plane of the cell
    const auto frame =
      make_quadrilateral(points, Formulation::standard, normal_thickness)
        ->material_frame();
    points.direction = std::cos(angle) * frame[0] + std::sin(angle) * frame[1];
    return quadrilateral_geometry(points, normal_thickness);
  }


  /** The force and the tangent of a cell do not depend on the direction from
   * which the angles of plies count. */
  void
  test_direction(const bool normal_thickness)
  {
    MixedElement::NodalMatrix K[2]{};
    NodalVector               force[2];
    const NodalVector         V = some_vector<24>(-0.2, 1);
    for (unsigned int k = 0; k < 2; ++k)
      {
        const Laminate laminate =
          layup(k == 0 ? "cord: 1 @ 30, cords: 1 @ -30, Yeoh: 1 @ 0"
                       : "cord: 1 @ -5, cords: 1 @ -65, Yeoh: 1 @ 10",
                "5/6",
                ThicknessIntegrals::plate,
                normal_thickness,
                false)
            .laminate(0);
        const ElementGeometry geometry = skewed_cell(
          laminate, normal_thickness, k == 0 ? 0 : 35 * numbers::PI / 180);
        const NonlinearPlies law(
          laminate, Formulation::standard, geometry.tangents());
        const MixedElement        element(geometry, V);
        NonlinearPlies::Stiffness stiffness;
        law.stiffness(element.strain(), stiffness);
        const Modes::Vector H = law.resultants(element.strain());
        force[k]              = element.internal_force(H, Modes::Vector());
        element.add_tangent(
          ModeStiffness(Resultants::Matrix(), Formulation::standard),
          H,
          K[k],
          &stiffness);
      }
    check_small(
      "  forces", (force[0] - force[1]).norm(), 1e-12, force[0].norm());
    double error = 0;
    for (unsigned int i = 0; i < 24; ++i)
      for (unsigned int j = 0; j < 24; ++j)
        error = std::max(error, std::abs(K[0][i][j] - K[1][i][j]));
    check_small("  tangents", error, 1e-12, maximum_entry(K[0]));
  }


  void
  test(const std::string       &plies,
       const std::string       &shear,
       const ThicknessIntegrals integrals,
       const Formulation        formulation,
       const bool               normal_thickness,
       const bool               relaxing = false,
       const bool               skewed   = false)
  {
    const Laminate laminate =
      layup(plies, shear, integrals, normal_thickness, relaxing).laminate(0);
    const ElementGeometry geometry = skewed
                                       ? skewed_cell(laminate, normal_thickness)
                                       : make_cells(torus(),
                                                    {{"40:45:1", "10:15:1"}},
                                                    laminate.face_heights(),
                                                    formulation,
                                                    normal_thickness)[0]
                                           .geometry;
    const NonlinearPlies  law(laminate, formulation, geometry.tangents());
    ModeStiffness         linear(
      laminate.stiffness(), formulation, geometry.tangents());
    linear.release_thickness_strain(laminate.stiffness_of_slack_cords(),
                                    geometry.tangents());
    const ModeStiffness none(Resultants::Matrix(), formulation);
    check_true("  whole law", law.is_whole_law());

    std::vector<double> internal(law.n_internal());
    HistoryOfPlies      history;
    if (relaxing)
      {
        const Modes::Vector last = 0.2 * some_vector<Modes::n>(0.3, 7);
        history.internal         = internal.data();
        history.steps.fill({0.5, 0});
        law.commit(last, history, internal.data());
        history.steps.fill({});
        const Modes::Vector H = law.resultants(last, history);
        // the stress of a step is that at its end
        std::vector<double> zero(law.n_internal());
        HistoryOfPlies      before;
        before.internal = zero.data();
        before.steps.fill({0.5, 0});
        check_small("  no change",
                    (law.resultants(last, before) - H).norm(),
                    1e-13,
                    H.norm());
        history.steps.fill({2, 0});
      }
    const auto resultants = [&](const Modes::Vector &E) {
      return law.resultants(E, history);
    };
    const auto force_at = [&](const NodalVector &V) {
      const MixedElement element(geometry, V);
      return element.internal_force(resultants(element.strain()),
                                    Modes::Vector());
    };
    const auto energy_at = [&](const NodalVector &V) {
      const Modes::Vector E = MixedElement(geometry, V).strain();
      return geometry.weight * law.energy(E, history);
    };

    const double       step = 1e-5;
    const NodalVector  V = some_vector<24>(-0.2, 1), dV = some_vector<24>(1, 2);
    const MixedElement element(geometry, V);
    check_range("  strains", element.strain().norm(), 0.1, 1);
    const double difference =
      (energy_at(V + step * dV) - energy_at(V - step * dV)) / (2 * step);
    check_small("  internal force",
                force_at(V) * dV - difference,
                1e-7,
                force_at(V).norm() * dV.norm());

    if (relaxing)
      check_changes(law, element.strain(), history);

    NonlinearPlies::Stiffness stiffness;
    check_true("  any", law.stiffness(element.strain(), stiffness, history));
    MixedElement::NodalMatrix K{};
    element.add_tangent(none, resultants(element.strain()), K, &stiffness);
    const double scale     = maximum_entry(K);
    double       asymmetry = 0;
    for (unsigned int j = 0; j < 24; ++j)
      for (unsigned int i = 0; i < 24; ++i)
        asymmetry = std::max(asymmetry, std::abs(K[i][j] - K[j][i]));
    check_small(
      "  tangent", deviation_of_tangent(K, force_at, V, step), 1e-7, scale);
    check_small("  symmetry", asymmetry, 1e-13, scale);

    if (relaxing)
      return;
    const Modes::Vector small = 1e-6 * element.strain();
    check_small("  linear at small strains",
                (resultants(small) - linear.resultants(small)).norm(),
                1e-4,
                linear.resultants(small).norm());
  }


  std::string
  in_words(const bool normal_thickness)
  {
    return normal_thickness ? ", normal thickness" : "";
  }
} // namespace


int
main()
{
  using Integrals = ThicknessIntegrals;
  for (const char *name : {"neo-Hooke", "Mooney", "Yeoh", "Ogden", "cords"})
    {
      std::cout << name << std::endl;
      test(std::string(name) + ": 3 @ 20",
           "constant strain",
           Integrals::plate,
           Formulation::paper,
           false);
    }
  const std::string mixed =
    "cord: 1 @ 30, neo-Hooke: 0.5 @ 0, cords: 1 @ -30, Yeoh: 1 @ 0";
  for (const std::string shear : {"constant strain", "5/6", "equilibrium"})
    for (const auto integrals : {Integrals::plate, Integrals::shell})
      for (const bool normal_thickness : {false, true})
        {
          std::cout << "mixed, shear " << shear << ", integrals "
                    << (integrals == Integrals::plate ? "plate" : "shell")
                    << in_words(normal_thickness) << std::endl;
          test(
            mixed, shear, integrals, Formulation::standard, normal_thickness);
        }
  for (const bool normal_thickness : {false, true})
    {
      std::cout << "mixed, formulation: vertices" << in_words(normal_thickness)
                << std::endl;
      test(mixed,
           "equilibrium",
           Integrals::shell,
           Formulation::vertices,
           normal_thickness);
    }
  for (const bool normal_thickness : {false, true})
    {
      std::cout << "mixed, relaxing" << in_words(normal_thickness) << std::endl;
      test(mixed,
           "equilibrium",
           Integrals::shell,
           Formulation::standard,
           normal_thickness,
           true);
    }
  for (const bool normal_thickness : {false, true})
    for (const bool relaxing : {false, true})
      {
        std::cout << "skewed cell, mixed" << (relaxing ? ", relaxing" : "")
                  << in_words(normal_thickness) << std::endl;
        test(mixed,
             "equilibrium",
             Integrals::plate,
             Formulation::standard,
             normal_thickness,
             relaxing,
             true);
      }
  for (const bool normal_thickness : {false, true})
    {
      std::cout << "skewed cell, other direction" << in_words(normal_thickness)
                << std::endl;
      test_direction(normal_thickness);
    }
}
