// SPDX-License-Identifier: LGPL-2.1-or-later

// A warped cell of any shape and varying thickness, with plies at any angle,
// has the strains, energy, forces and tangent of an independent program; they
// do not depend on which of its vertices is the first one, nor on which face is
// the inner one; and a rigid motion of any size does not strain it.

#include <deal.II/lac/lapack_full_matrix.h>
#include <deal.II/physics/transformations.h>

#include <biface/element/mixed_element.h>

#include "one_cell.h"
#include "reference_values.h"

using namespace dealii;
using namespace Biface;

namespace
{
  const ReferenceValues reference("quadrilateral.json");

  Tensor<1, 3>
  vector_at(const std::vector<double> &numbers, const unsigned int i)
  {
    Tensor<1, 3> x;
    for (unsigned int d = 0; d < 3; ++d)
      x[d] = numbers[3 * i + d];
    return x;
  }


  /** The cell, with one of the vertices of the reference as the first. */
  struct Cell
  {
    std::array<unsigned int, 4> vertices;
    ElementGeometry             geometry;

    Cell(const Formulation formulation, const unsigned int first)
    {
      // the reference lists nodes counterclockwise
      vertices = {{first, (first + 1) % 4, (first + 3) % 4, (first + 2) % 4}};

      Quadrilateral::Shape shape;
      const auto           X = reference("X"), n = reference("normals"),
                 inner = reference("delta_minus"),
                 outer = reference("delta_plus");
      for (unsigned int q = 0; q < 4; ++q)
        {
          const unsigned int v = vertices[q];
          shape.positions[q]   = vector_at(X, v);
          shape.normals[q]     = vector_at(n, v);
          shape.heights[q]     = {{inner[v], outer[v]}};

          // any frame of the node
          Tensor<1, 3> axis;
          for (unsigned int d = 0; d < 3; ++d)
            axis[d] = some_number(3 * v + d);
          geometry.vertices[q].axes =
            Physics::Transformations::Rotations::rotation_matrix_3d(
              Point<3>(axis / axis.norm()), 0.5 + v);
          geometry.vertices[q].thickness = outer[v] - inner[v];
        }
      shape.direction = vector_at(reference("reference_direction"), 0);

      Quadrilateral::Options options;
      options.means        = (formulation == Formulation::standard);
      options.soft_warp    = options.means;
      geometry.formulation = formulation;
      geometry.along_lines = false;
      geometry.quadrilateral =
        std::make_shared<const Quadrilateral>(shape, options);
      geometry.weight = geometry.quadrilateral->area();
    }

    ModeStiffness
    stiffness() const
    {
      const auto         numbers = reference("D");
      Resultants::Matrix D;
      for (unsigned int i = 0; i < Resultants::n; ++i)
        for (unsigned int j = 0; j < Resultants::n; ++j)
          D[i][j] = numbers[Resultants::n * i + j];
      return ModeStiffness(D, geometry.formulation, geometry.tangents());
    }

    /** The nodal displacements of the reference. */
    MixedElement::NodalVector
    displacements(const std::string &name) const
    {
      const auto                numbers = reference(name);
      MixedElement::NodalVector V;
      for (unsigned int q = 0; q < 4; ++q)
        for (const auto part :
             {MixedElement::mean, MixedElement::half_difference})
          {
            const Tensor<1, 3> v = vector_at(numbers, 2 * vertices[q] + part) *
                                   geometry.vertices[q].axes;
            for (unsigned int i = 0; i < 3; ++i)
              V[MixedElement::dof(q, i, part)] = v[i];
          }
      return V;
    }

    /** Forces in the order of the reference. */
    std::vector<double>
    in_order_of_reference(const MixedElement::NodalVector &forces) const
    {
      std::vector<double> result(MixedElement::n_dofs);
      for (unsigned int q = 0; q < 4; ++q)
        for (const auto part :
             {MixedElement::mean, MixedElement::half_difference})
          {
            Tensor<1, 3> f;
            for (unsigned int i = 0; i < 3; ++i)
              f[i] = forces[MixedElement::dof(q, i, part)];
            f = geometry.vertices[q].axes * f;
            for (unsigned int i = 0; i < 3; ++i)
              result[6 * vertices[q] + 3 * part + i] = f[i];
          }
      return result;
    }
  };


  MixedElement::NodalVector
  product(const MixedElement::NodalMatrix &K,
          const MixedElement::NodalVector &V)
  {
    MixedElement::NodalVector result;
    for (unsigned int i = 0; i < MixedElement::n_dofs; ++i)
      for (unsigned int j = 0; j < MixedElement::n_dofs; ++j)
        result[i] += K[i][j] * V[j];
    return result;
  }


  /** The eigenvalues of a tangent, in ascending order. */
  std::vector<double>
  eigenvalues_of(const MixedElement::NodalMatrix &K)
  {
    LAPACKFullMatrix<double> matrix(MixedElement::n_dofs);
    for (unsigned int i = 0; i < MixedElement::n_dofs; ++i)
      for (unsigned int j = 0; j < MixedElement::n_dofs; ++j)
        matrix(i, j) = (K[i][j] + K[j][i]) / 2;
    matrix.compute_eigenvalues();
    std::vector<double> eigenvalues;
    for (unsigned int i = 0; i < MixedElement::n_dofs; ++i)
      eigenvalues.push_back(matrix.eigenvalue(i).real());
    std::sort(eigenvalues.begin(), eigenvalues.end());
    return eigenvalues;
  }


  void
  test(const Formulation formulation, const unsigned int first)
  {
    const Cell        cell(formulation, first);
    const std::string what =
      name_of(formulation) + ", vertex " + std::to_string(first) + " first, ";
    const auto values = [&](const std::string &entry) {
      return reference(
        (formulation == Formulation::standard ? "means." : "vertices.") +
        entry);
    };
    const Quadrilateral &quadrilateral = *cell.geometry.quadrilateral;
    compare(what + "weight",
            std::vector<double>{cell.geometry.weight},
            values("weight"),
            1e-14);

    const auto          V = cell.displacements("V");
    const MixedElement  element(cell.geometry, V);
    const ModeStiffness stiffness = cell.stiffness();
    if (first == 0)
      {
        Quadrilateral::NodalVectors nodal;
        for (unsigned int q = 0; q < 4; ++q)
          for (unsigned int part = 0; part < 2; ++part)
            nodal[4 * part + q] =
              vector_at(reference("V"), 2 * cell.vertices[q] + part);
        const auto change = quadrilateral.vectors(nodal);
        auto       mean   = quadrilateral.undeformed();
        for (unsigned int k = 0; k < mean.size(); ++k)
          mean[k] += change[k] / 2;
        const Modes::Vector strains = quadrilateral.products(change, mean);
        // the reference lists the twists last
        std::vector<double> ours;
        for (unsigned int m = 0; m < 4; ++m)
          for (unsigned int i = 0; i < Modes::groups[m].sampled; ++i)
            ours.push_back(strains[Modes::groups[m].first_mode + i]);
        for (unsigned int m = 1; m < 3; ++m)
          ours.push_back(strains[Modes::mode_of[m][Modes::twist]]);
        auto expected = values("strains_of_V");
        if (formulation == Formulation::vertices)
          {
            ours.resize(22);
            expected.resize(22);
          }
        compare(what + "covariant strains", ours, expected, 1e-12);
      }

    const Modes::Vector E = element.strain();
    const Modes::Vector H = stiffness.resultants(E);
    compare(
      what + "energy",
      std::vector<double>{cell.geometry.weight * Modes::mean_product(H, E) / 2},
      values("energy_of_V"),
      1e-12);
    compare(
      what + "force",
      cell.in_order_of_reference(element.internal_force(H, Modes::Vector())),
      values("force_of_V"),
      // of central differences
      1e-8);

    const auto dV = cell.displacements("V2");
    for (const bool at_rest : {true, false})
      {
        const MixedElement        at(cell.geometry,
                              at_rest ? MixedElement::NodalVector() : V);
        const Modes::Vector       resultants = (at_rest ? Modes::Vector() : H);
        MixedElement::NodalMatrix K{};
        at.add_tangent(stiffness, resultants, K);
        const auto expected     = values(at_rest ? "K0_V2" : "K_of_V_times_V2");
        const std::string where = (at_rest ? "at rest" : "deformed");
        compare(what + "tangent " + where,
                cell.in_order_of_reference(product(K, dV)),
                expected,
                1e-12);
        compare(what + "product with the tangent " + where,
                cell.in_order_of_reference(
                  at.tangent_product(stiffness, resultants, dV)),
                expected,
                1e-12);
        if (!at_rest)
          check_small(what + "tangent and differences of forces",
                      deviation_of_tangent(
                        K,
                        [&](const MixedElement::NodalVector &x) {
                          const MixedElement e(cell.geometry, x);
                          return e.internal_force(
                            stiffness.resultants(e.strain()), Modes::Vector());
                        },
                        V,
                        1e-6),
                      1e-7,
                      maximum_entry(K));
        else
          {
            const auto eigenvalues = eigenvalues_of(K);
            double     zero        = 0;
            for (unsigned int i = 0; i < 6; ++i)
              zero = std::max(zero, std::abs(eigenvalues[i]));
            check_small(
              what + "six zero eigenvalues", zero, 1e-14, eigenvalues.back());
            compare(
              what + "the other eigenvalues",
              std::vector<double>(eigenvalues.begin() + 6, eigenvalues.end()),
              values("eig_K0"),
              1e-12);
          }
      }
  }


  /** A turn by 163 degrees and a translation. */
  void
  test_rigid_motion(const Formulation formulation)
  {
    const Cell         cell(formulation, 0);
    const Tensor<1, 3> axis({2. / 7, -3. / 7, 6. / 7});
    const Tensor<2, 3> turn =
      Physics::Transformations::Rotations::rotation_matrix_3d(
        Point<3>(axis), 163 * numbers::PI / 180);
    const auto X = reference("X"), n = reference("normals"),
               inner = reference("delta_minus"),
               outer = reference("delta_plus");
    MixedElement::NodalVector V;
    for (unsigned int q = 0; q < 4; ++q)
      for (unsigned int face = 0; face < 2; ++face)
        {
          const unsigned int v = cell.vertices[q];
          const Tensor<1, 3> P =
            vector_at(X, v) + (face ? outer[v] : inner[v]) * vector_at(n, v);
          const Tensor<1, 3> u = turn * P - P + Tensor<1, 3>({5, -2, 3});
          add_face_displacement(u * cell.geometry.vertices[q].axes, q, face, V);
        }
    const MixedElement        element(cell.geometry, V);
    const ModeStiffness       stiffness = cell.stiffness();
    const Modes::Vector       E         = element.strain();
    MixedElement::NodalMatrix K{};
    element.add_tangent(stiffness, Modes::Vector(), K);
    const std::string what = name_of(formulation) + ", after a turn, ";
    check_small(what + "energy",
                cell.geometry.weight *
                  Modes::mean_product(stiffness.resultants(E), E) / 2,
                1e-25,
                maximum_entry(K));
    const auto eigenvalues = eigenvalues_of(K);
    check_small(what + "six zero eigenvalues",
                std::max(std::abs(eigenvalues[0]), std::abs(eigenvalues[5])),
                1e-14,
                eigenvalues.back());
    check_range(what + "the seventh over the last",
                eigenvalues[6] / eigenvalues.back(),
                1e-6,
                1);
  }


  /** The energy of the cell with a symmetric law, seen from either side. */
  double
  energy_with_inner_face(const Formulation formulation, const bool swapped)
  {
    Cell cell(formulation, 0);
    // the same faces with the opposite normal are those of a cell whose
    // vertices are numbered the other way
    const auto X = reference("X"), n = reference("normals"),
               inner = reference("delta_minus"),
               outer = reference("delta_plus");
    if (swapped)
      std::swap(cell.vertices[1], cell.vertices[2]);
    Quadrilateral::Shape shape;
    for (unsigned int q = 0; q < 4; ++q)
      {
        const unsigned int v = cell.vertices[q];
        const double       s = (swapped ? -1 : 1);
        shape.positions[q]   = vector_at(X, v);
        shape.normals[q]     = s * vector_at(n, v);
        shape.heights[q]     = {
              {swapped ? -outer[v] : inner[v], swapped ? -inner[v] : outer[v]}};
        cell.geometry.vertices[q].axes      = unit_symmetric_tensor<3>();
        cell.geometry.vertices[q].thickness = outer[v] - inner[v];
      }
    shape.direction = vector_at(reference("reference_direction"), 0);
    Quadrilateral::Options options;
    options.means = (formulation == Formulation::standard);
    cell.geometry.quadrilateral =
      std::make_shared<const Quadrilateral>(shape, options);

    const auto                numbers = reference("V");
    MixedElement::NodalVector V;
    for (unsigned int q = 0; q < 4; ++q)
      {
        const Tensor<1, 3> mean = vector_at(numbers, 2 * cell.vertices[q]),
                           half = vector_at(numbers, 2 * cell.vertices[q] + 1);
        for (unsigned int i = 0; i < 3; ++i)
          {
            V[MixedElement::dof(q, i, MixedElement::mean)] = mean[i];
            V[MixedElement::dof(q, i, MixedElement::half_difference)] =
              (swapped ? -1 : 1) * half[i];
          }
      }

    // an isotropic plate
    Resultants::Matrix D;
    const double       E = 3, nu = 0.3, G = E / (2 + 2 * nu);
    for (unsigned int p = 0; p < 2; ++p)
      for (unsigned int r = 0; r < 2; ++r)
        {
          using namespace Resultants;
          const double of_faces = (p == r ? 1. / 3 : 1. / 6);
          for (unsigned int a = 0; a < 2; ++a)
            {
              for (unsigned int b = 0; b < 2; ++b)
                D[tangential(a, p)][tangential(b, r)] =
                  of_faces * E / (1 - nu * nu) * (a == b ? 1 : nu);
              D[transverse(a, p)][transverse(a, r)] = of_faces * G;
            }
          D[tangential(2, p)][tangential(2, r)] = of_faces * G;
        }
    D[Resultants::thickness][Resultants::thickness] = E;
    const ModeStiffness stiffness(D, formulation, cell.geometry.tangents());
    const Modes::Vector strain = MixedElement(cell.geometry, V).strain();
    return cell.geometry.quadrilateral->area() *
           Modes::mean_product(stiffness.resultants(strain), strain) / 2;
  }
} // namespace


int
main()
{
  for (const auto formulation : {Formulation::standard, Formulation::vertices})
    for (unsigned int first = 0; first < 4; ++first)
      test(formulation, first);
  for (const auto formulation : {Formulation::standard, Formulation::vertices})
    {
      test_rigid_motion(formulation);
      const double energy = energy_with_inner_face(formulation, false);
      check_small(name_of(formulation) +
                    ", the other face is the inner one, energy",
                  energy_with_inner_face(formulation, true) - energy,
                  1e-13,
                  energy);
    }
}
