// SPDX-License-Identifier: LGPL-2.1-or-later

// An element of the bias tire has the stiffness, strains, resultants, internal
// force, tangent and energy of the independent program of doc/bias_tire.md.

#include <biface/element/mixed_element.h>
#include <biface/laminate/layup.h>

#include "one_cell.h"
#include "reference_values.h"
#include <cord_ply.h>
#include <tests.h>

using namespace dealii;
using namespace Biface;

namespace
{
  // the reference lists nodes with alpha_2 running fastest
  constexpr unsigned int reference_node[4] = {0, 2, 1, 3};

  // and has the displacements v_1^-, v_1^+, v_2^-, ... of the faces
  double
  in_reference(const MixedElement::NodalVector &forces,
               const unsigned int               vertex,
               const unsigned int               i)
  {
    return MixedElement::face_force(forces, vertex, i % 2)[i / 2];
  }

  std::vector<double>
  in_order_of_reference(const MixedElement::NodalVector &forces)
  {
    std::vector<double> result(24);
    for (unsigned int v = 0; v < 4; ++v)
      for (unsigned int i = 0; i < 6; ++i)
        result[6 * reference_node[v] + i] = in_reference(forces, v, i);
    return result;
  }

  void
  add_from_reference(const double               displacement,
                     const unsigned int         vertex,
                     const unsigned int         i,
                     MixedElement::NodalVector &V)
  {
    Tensor<1, 3> u;
    u[i / 2] = displacement;
    add_face_displacement(u, vertex, i % 2, V);
  }
} // namespace


int
main()
{
  const ReferenceValues values("bias_tire_element.json");

  Layup::Parameters parameters;
  const Laminate    laminate = Layup(parameters, cord_ply()).laminate(0);
  const auto        D        = laminate.stiffness();
  parameters.law             = ThicknessLaw::asymmetric;
  const auto D_asymmetric =
    Layup(parameters, cord_ply()).laminate(0).stiffness();

  std::vector<double> entries, entries_asymmetric;
  for (unsigned int i = 0; i < Resultants::n; ++i)
    for (unsigned int j = 0; j < Resultants::n; ++j)
      {
        entries.push_back(D[i][j]);
        entries_asymmetric.push_back(D_asymmetric[i][j]);
      }
  compare("D, symmetric law", entries, values("D_symmetric"));
  compare("D, asymmetric law", entries_asymmetric, values("D_asymmetric"));

  const SurfaceOfRevolution surface = torus();
  const ElementGeometry     geometry =
    make_cells(surface, {{"40:45:1", "10:15:1"}}, laminate.face_heights())
      .front()
      .geometry;
  compare("element weight",
          std::vector<double>{geometry.weight},
          values("element_weight"));

  MixedElement::NodalVector V, ones;
  for (unsigned int n = 0; n < 4; ++n)
    for (unsigned int i = 0; i < 6; ++i)
      {
        add_from_reference(
          0.1 * std::sin(1 + 0.7 * (6 * reference_node[n] + i)), n, i, V);
        add_from_reference(1, n, i, ones);
      }

  const MixedElement  element(geometry, V);
  const Modes::Vector E         = element.strain();
  const char         *groups[4] = {"E_00", "E_xi2", "E_xi1", "E_xi1xi2"};
  for (unsigned int m = 0; m < 4; ++m)
    {
      std::vector<double> modes(Resultants::n, 0.);
      const auto         &group = Modes::groups[m];
      for (unsigned int i = 0; i < group.size; ++i)
        modes[group.strains[i]] = E[group.first_mode + i];
      compare(groups[m], modes, values(groups[m]));
    }

  const ModeStiffness stiffness(D, Formulation::paper);
  const Modes::Vector H = stiffness.resultants(E);
  compare("H_00", H, values("H_00"));
  compare("internal force",
          in_order_of_reference(element.internal_force(H, Modes::Vector())),
          values("internal_force"));

  MixedElement::NodalMatrix K{};
  element.add_tangent(stiffness, H, K);
  const auto K_times = [&](const MixedElement::NodalVector &v) {
    MixedElement::NodalVector result;
    for (unsigned int i = 0; i < 24; ++i)
      for (unsigned int j = 0; j < 24; ++j)
        result[i] += K[i][j] * v[j];
    return result;
  };
  double trace = 0;
  for (unsigned int n = 0; n < 4; ++n)
    for (unsigned int i = 0; i < 6; ++i)
      {
        MixedElement::NodalVector unit;
        add_from_reference(1, n, i, unit);
        trace += in_reference(K_times(unit), n, i);
      }
  compare("tangent times ones",
          in_order_of_reference(K_times(ones)),
          values("tangent_times_ones"));
  compare("tangent times V",
          in_order_of_reference(K_times(V)),
          values("tangent_times_V"));
  compare("trace of the tangent",
          std::vector<double>{trace},
          values("tangent_trace"));
  compare("strain energy",
          std::vector<double>{geometry.weight * Modes::mean_product(H, E) / 2},
          values("strain_energy"));
}
