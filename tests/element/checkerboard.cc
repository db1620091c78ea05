// SPDX-License-Identifier: LGPL-2.1-or-later

// In a plate compressed along its fibers, displacements that alternate from
// node to node across the fibers release energy if all strains come from the
// vertices, but not with the standard formulation.

#include <deal.II/lac/lapack_full_matrix.h>

#include <algorithm>
#include <map>

#include <biface/laminate/layup.h>
#include <biface/laminate/material_parameters.h>

#include "one_cell.h"
#include <tests.h>

using namespace dealii;
using namespace Biface;

namespace
{
  constexpr unsigned int n = 6;

  /** The fibers along alpha_2. */
  Laminate
  laminate()
  {
    MaterialParameters material;
    material.name  = "ply";
    material.type  = MaterialParameters::Type::transversely_isotropic;
    material.E_L   = 2068.5;
    material.E_T   = 517.125;
    material.G_LT  = 795.6;
    material.G_TT  = 198.9;
    material.nu_LT = material.nu_TT = 0.3;
    Layup::Parameters parameters;
    parameters.plies = parse_plies("plies", "ply: 1 @ 90");
    return Layup(parameters, {material}).laminate(0);
  }


  /** The unknown of an inner node, without those of the edges and of the mean
   * deflection, with which the plate as a whole might buckle. */
  struct Unknowns
  {
    std::map<std::pair<unsigned int, unsigned int>, unsigned int> index;

    void
    add(const TestCell &cell)
    {
      for (unsigned int v = 0; v < 4; ++v)
        {
          const Point<3> &x = cell.points[v].position;
          if (std::min(x[0], x[1]) > 0.1 && std::max(x[0], x[1]) < n - 0.1)
            for (unsigned int i = 0; i < 6; ++i)
              if (i != MixedElement::dof(0, 2, MixedElement::mean))
                {
                  const unsigned int next = index.size();
                  index.insert({{cell.vertices[v], i}, next});
                }
        }
    }

    /** All if it is none. */
    unsigned int
    of(const TestCell &cell, const unsigned int i) const
    {
      const auto found = index.find({cell.vertices[i / 6], i % 6});
      return found == index.end() ? index.size() : found->second;
    }
  };


  void
  test(const Formulation formulation, const double compression)
  {
    const Laminate plies = laminate();
    const auto     cells =
      make_cells(Plane(),
                 {{"0:6:" + std::to_string(n), "0:6:" + std::to_string(n)}},
                 plies.face_heights(),
                 formulation);
    const ModeStiffness stiffness(plies.stiffness(), formulation);

    Unknowns unknowns;
    for (const TestCell &cell : cells)
      unknowns.add(cell);
    const unsigned int       size = unknowns.index.size();
    LAPACKFullMatrix<double> K(size);
    K = 0;
    Vector<double> checkerboard(size);
    for (const TestCell &cell : cells)
      {
        MixedElement::NodalVector V;
        for (unsigned int v = 0; v < 4; ++v)
          {
            const Point<3> &x = cell.points[v].position;
            // free of stress across the fibers
            const double wider = std::sqrt(1 + 2 * 0.3 * compression) - 1;
            V[MixedElement::dof(v, 0, MixedElement::mean)] = wider * x[0];
            V[MixedElement::dof(v, 1, MixedElement::mean)] =
              (std::sqrt(1 - 2 * compression) - 1) * x[1];
            V[MixedElement::dof(v, 2, MixedElement::half_difference)] =
              wider * 1 / 2;
          }
        const MixedElement        element(cell.geometry, V);
        MixedElement::NodalMatrix tangent{};
        element.add_tangent(
          stiffness, stiffness.resultants(element.strain()), tangent);
        for (unsigned int i = 0; i < MixedElement::n_dofs; ++i)
          {
            const unsigned int row = unknowns.of(cell, i);
            if (row == size)
              continue;
            for (unsigned int j = 0; j < MixedElement::n_dofs; ++j)
              {
                const unsigned int column = unknowns.of(cell, j);
                if (column < size)
                  K(row, column) += tangent[i][j];
              }
            // v_1 alternates: 1 on the inner face, -0.5 on the outer one
            const Point<3> &x    = cell.points[i / 6].position;
            const double    sign = std::cos(numbers::PI * (x[0] + x[1]));
            if (i % 6 == 0)
              checkerboard[row] = 0.25 * sign;
            else if (i % 6 == 1)
              checkerboard[row] = -0.75 * sign;
          }
      }

    Vector<double> force(size);
    K.vmult(force, checkerboard);
    std::cout << name_of(formulation) << ", compression " << compression
              << std::endl;
    std::cout << "  checkerboard "
              << (checkerboard * force > 0 ? "resisted" : "not resisted")
              << std::endl;

    K.compute_eigenvalues();
    unsigned int n_negative = 0;
    for (unsigned int i = 0; i < size; ++i)
      n_negative += (K.eigenvalue(i).real() < 0);
    std::cout << "  negative eigenvalues: "
              << (n_negative > 0 ? "some" : "none") << std::endl;
  }
} // namespace


int
main()
{
  for (const auto formulation : all_elements())
    for (const double compression : {0.02, 0.15})
      test(formulation, compression);
}
