// SPDX-License-Identifier: LGPL-2.1-or-later

// A free flat element has exactly six zero-energy modes, the rigid motions; a
// curved one, too, where vectors are interpolated.

#include <deal.II/lac/lapack_full_matrix.h>

#include <algorithm>

#include <biface/laminate/laminate.h>
#include <biface/laminate/material.h>
#include <biface/surface/reference_surface.h>

#include "one_cell.h"
#include <tests.h>

using namespace dealii;
using namespace Biface;

namespace
{
  void
  test(const std::string                &name,
       const ReferenceSurface           &surface,
       const std::array<std::string, 2> &intervals,
       const Formulation                 formulation)
  {
    std::cout << name << ", formulation: " << name_of(formulation) << std::endl;
    const double   h = 2;
    const Laminate laminate(
      {{{Material::isotropic(1000, 0.3).stiffness("material")}, h, 0, {}}},
      ThicknessLaw::symmetric,
      0);
    const TestCell cell =
      make_cells(surface, intervals, laminate.face_heights(), formulation)[0];

    MixedElement::NodalMatrix K{};
    MixedElement(cell.geometry, MixedElement::NodalVector())
      .add_tangent(
        ModeStiffness(laminate.stiffness(), formulation), Modes::Vector(), K);

    const unsigned int       n = MixedElement::n_dofs;
    LAPACKFullMatrix<double> matrix(n);
    for (unsigned int i = 0; i < n; ++i)
      for (unsigned int j = 0; j < n; ++j)
        matrix(i, j) = K[i][j];
    matrix.compute_eigenvalues();
    std::vector<double> eigenvalues;
    for (unsigned int i = 0; i < n; ++i)
      eigenvalues.push_back(matrix.eigenvalue(i).real());
    std::sort(eigenvalues.begin(), eigenvalues.end());

    const double largest = eigenvalues.back();
    check_small("the lowest eigenvalue", eigenvalues[0], 1e-13, largest);
    check_small("the sixth eigenvalue", eigenvalues[5], 1e-13, largest);
    check_range("the seventh one", eigenvalues[6] / largest, 1e-3, 1);

    // the first six are rotations and translations
    double energy = 0;
    for (unsigned int mode = 0; mode < 6; ++mode)
      {
        Tensor<1, 3> translation, rotation;
        (mode < 3 ? translation : rotation)[mode % 3] = 1;
        MixedElement::NodalVector V;
        for (unsigned int v = 0; v < 4; ++v)
          for (unsigned int face = 0; face < 2; ++face)
            {
              const SurfacePoint &point = cell.points[v];
              const Tensor<1, 3>  x =
                point.position + laminate.face_heights()[face] * point.frame[2];
              const Tensor<1, 3> u =
                translation + cross_product_3d(rotation, x);
              add_face_displacement(point.to_frame(u), v, face, V);
            }
        double mode_energy = 0;
        for (unsigned int i = 0; i < n; ++i)
          for (unsigned int j = 0; j < n; ++j)
            mode_energy += V[i] * K[i][j] * V[j];
        energy = std::hypot(energy, std::abs(mode_energy) / V.norm_square());
      }
    check_small("energy of the rigid modes", energy, 1e-13, largest);
  }
} // namespace


int
main()
{
  for (const auto formulation : all_elements())
    {
      test("plate", Plane(), {{"0:3:1", "0:4:1"}}, formulation);
      if (formulation != Formulation::paper)
        test("torus", torus(), {{"40:45:1", "10:12:1"}}, formulation);
    }
}
