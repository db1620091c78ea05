// SPDX-License-Identifier: LGPL-2.1-or-later

// Patch tests on the distorted cells of MacNeal and Harder, with plies at
// oblique angles: constant membrane strains, constant curvatures, constant
// transverse shear and a constant thickness strain are exact in every cell and
// in equilibrium at the inner nodes, at any thickness and in large homogeneous
// deformations.

#include <deal.II/physics/transformations.h>

#include <functional>

#include <biface/laminate/layup.h>

#include "one_cell.h"
#include <cord_ply.h>
#include <tests.h>

using namespace dealii;
using namespace Biface;

namespace
{
  // MacNeal, Harder, Finite Elem. Anal. Des. 1 (1985) 3; the last four are
  // inside
  const std::array<Point<3>, 8> nodes{{Point<3>(0, 0, 0),
                                       Point<3>(0.24, 0, 0),
                                       Point<3>(0.24, 0.12, 0),
                                       Point<3>(0, 0.12, 0),
                                       Point<3>(0.04, 0.02, 0),
                                       Point<3>(0.18, 0.03, 0),
                                       Point<3>(0.16, 0.08, 0),
                                       Point<3>(0.08, 0.08, 0)}};
  // in the order of deal.II
  const std::array<std::array<unsigned int, 4>, 5> cells{{{{0, 1, 4, 5}},
                                                          {{1, 2, 5, 6}},
                                                          {{7, 6, 3, 2}},
                                                          {{0, 4, 3, 7}},
                                                          {{4, 5, 7, 6}}}};

  /** The displacements of the inner and the outer face at (x, y). */
  using Field =
    std::function<std::array<Tensor<1, 3>, 2>(const Point<3> &position)>;

  Laminate
  plies(const double thickness)
  {
    Layup::Parameters parameters;
    const std::string t = std::to_string(thickness / 4);
    parameters.plies =
      parse_plies("plies",
                  "cord: " + t + " @ 30, cord: " + t + " @ -50, cord: " + t +
                    " @ 10, cord: " + t + " @ -80");
    return Layup(parameters, cord_ply()).laminate(0);
  }


  struct Patch
  {
    const Laminate                 laminate;
    const Formulation              formulation;
    const double                   h;
    std::array<ElementGeometry, 5> geometries;

    Patch(const double thickness, const Formulation formulation)
      : laminate(plies(thickness))
      , formulation(formulation)
      , h(laminate.face_heights()[1] - laminate.face_heights()[0])
    {
      for (unsigned int c = 0; c < cells.size(); ++c)
        {
          ElementGeometry     &geometry = geometries[c];
          Quadrilateral::Shape shape;
          for (unsigned int q = 0; q < 4; ++q)
            {
              shape.positions[q]             = nodes[cells[c][q]];
              shape.normals[q]               = Point<3>(0, 0, 1);
              shape.heights[q]               = laminate.face_heights();
              geometry.vertices[q].axes      = unit_symmetric_tensor<3>();
              geometry.vertices[q].thickness = h;
            }
          shape.direction = Point<3>(0.8, 0.6, 0);
          Quadrilateral::Options options;
          options.means        = (formulation == Formulation::standard);
          geometry.formulation = formulation;
          geometry.quadrilateral =
            std::make_shared<const Quadrilateral>(shape, options);
          geometry.weight = geometry.quadrilateral->area();
        }
    }

    /** The strains of a homogeneous change of the metric of a face in the axes
     * of the material, from those in x, y. */
    Resultants::Vector
    strains(const std::array<Tensor<2, 2>, 2> &faces,
            const Tensor<1, 2>                &shear,
            const double                       thickness) const
    {
      const Tensor<2, 3> &frame = geometries[0].quadrilateral->material_frame();
      Resultants::Vector  E;
      const auto          along = [&](const unsigned int i) {
        return Tensor<1, 2>({frame[i][0], frame[i][1]});
      };
      for (unsigned int face = 0; face < 2; ++face)
        {
          for (unsigned int i = 0; i < 2; ++i)
            {
              E[Resultants::tangential(i, face)] =
                along(i) * (faces[face] * along(i));
              E[Resultants::transverse(i, face)] = shear * along(i);
            }
          E[Resultants::tangential(2, face)] =
            2 * (along(0) * (faces[face] * along(1)));
        }
      E[Resultants::thickness] = thickness;
      return E;
    }

    /** The thickness strain with which there is no thickness stress. */
    double
    free_thickness_strain(const Resultants::Vector &tangential) const
    {
      const Resultants::Matrix D = laminate.stiffness();
      return -(D[Resultants::thickness] * tangential) /
             D[Resultants::thickness][Resultants::thickness];
    }

    /**
     * @param exact the strains.
     * @param pressure on both faces, with which a thickness stress is in
     * equilibrium.
     * @param held_directors whether only the mean displacements are free.
     */
    void
    test(const std::string        &name,
         const bool                linear,
         const Field              &displacement,
         const Resultants::Vector &exact,
         const double              pressure       = 0,
         const bool                held_directors = false) const
    {
      std::array<MixedElement::NodalVector, 8> forces;
      double                                   strains_off = 0, energy = 0;
      std::array<double, 6>                    size{};
      for (unsigned int c = 0; c < cells.size(); ++c)
        {
          const ElementGeometry    &geometry = geometries[c];
          MixedElement::NodalVector V;
          for (unsigned int q = 0; q < 4; ++q)
            {
              const auto faces = displacement(nodes[cells[c][q]]);
              for (unsigned int face = 0; face < 2; ++face)
                add_face_displacement(faces[face], q, face, V);
            }
          const ModeStiffness stiffness(
            laminate.stiffness(), formulation, geometry.tangents());
          const MixedElement at_rest(geometry, MixedElement::NodalVector()),
            deformed(geometry, V);
          const Modes::Vector E =
            (linear ? at_rest.strain_variation(V) : deformed.strain());
          strains_off =
            std::max(strains_off, (E - Modes::constant(exact)).norm());
          const auto force =
            (linear ? at_rest : deformed)
              .internal_force(stiffness.resultants(E), Modes::Vector());
          energy += force * V;
          for (unsigned int i = 0; i < MixedElement::n_dofs; ++i)
            size[i % 6] = std::max(size[i % 6], std::abs(V[i]));
          for (unsigned int q = 0; q < 4; ++q)
            for (unsigned int i = 0; i < 6; ++i)
              forces[cells[c][q]][i] += force[6 * q + i];

          // the mean of the bilinear area over the cell, by the shape function
          const auto &x = geometry.quadrilateral->undeformed();
          for (unsigned int q = 0; q < 4; ++q)
            {
              const Tensor<1, 3> g_1 = x[Quadrilateral::tangent(0, 0)],
                                 g_2 = x[Quadrilateral::tangent(0, 1)],
                                 c_0 = x[Quadrilateral::hourglass(0)];
              const Tensor<1, 3> area =
                cross_product_3d(g_1, g_2) +
                (q & 1 ? 1. : -1.) / 3 * cross_product_3d(g_1, c_0) +
                (q & 2 ? 1. : -1.) / 3 * cross_product_3d(c_0, g_2);
              forces[cells[c][q]][5] += 2 * pressure * area[2];
            }
        }

      // the work on displacements like the exact ones, since half the
      // differences are much smaller in a thin plate; with held directors, a
      // constant shear needs no moments
      double work = 0;
      for (unsigned int n = 4; n < nodes.size(); ++n)
        for (unsigned int i = 0; i < 3; ++i)
          for (const auto part :
               {MixedElement::mean, MixedElement::half_difference})
            if (!held_directors || part == MixedElement::mean)
              {
                const unsigned int dof = MixedElement::dof(0, i, part);
                work += std::abs(forces[n][dof]) * size[dof];
              }
      check_small(name + ": strains", strains_off, 1e-11, exact.norm());
      check_small(name + ": forces at inner nodes", work, 1e-10, energy);
    }
  };


  void
  test_all(const double thickness, const Formulation formulation)
  {
    std::cout << "thickness " << thickness
              << ", formulation: " << name_of(formulation) << std::endl;
    const Patch  patch(thickness, formulation);
    const double h = patch.h;

    {
      Tensor<2, 2> e;
      e[0][0] = 1e-3;
      e[1][1] = -0.6e-3;
      e[0][1] = e[1][0]            = 0.4e-3;
      Resultants::Vector exact     = patch.strains({{e, e}}, {}, 0);
      exact[Resultants::thickness] = patch.free_thickness_strain(exact);
      const double thicken         = exact[Resultants::thickness];
      patch.test(
        "membrane",
        true,
        [&](const Point<3> &x) {
          std::array<Tensor<1, 3>, 2> v;
          for (unsigned int face = 0; face < 2; ++face)
            v[face] = Point<3>(e[0][0] * x[0] + e[0][1] * x[1],
                               e[1][0] * x[0] + e[1][1] * x[1],
                               (face ? 1 : -1) * thicken * h / 2);
          return v;
        },
        exact);
    }
    {
      // w = (k_xx x^2 + 2 k_xy x y + k_yy y^2)/2 of the middle surface
      Tensor<2, 2> k;
      k[0][0] = 1e-3;
      k[1][1] = -0.7e-3;
      k[0][1] = k[1][0] = 0.5e-3;
      Resultants::Vector exact =
        patch.strains({{h / 2 * k, -h / 2 * k}}, {}, 0);
      exact[Resultants::thickness] = patch.free_thickness_strain(exact);
      const double thicken         = exact[Resultants::thickness];
      patch.test(
        "bending",
        true,
        [&](const Point<3> &x) {
          const Tensor<1, 2>          y({x[0], x[1]}), slope = k * y;
          std::array<Tensor<1, 3>, 2> v;
          for (unsigned int face = 0; face < 2; ++face)
            {
              const double z = (face ? 1 : -1) * h / 2;
              v[face]        = Point<3>(
                -z * slope[0], -z * slope[1], slope * y / 2 + z * thicken);
            }
          return v;
        },
        exact);
    }
    {
      const Tensor<1, 2> gamma({1e-3, -0.4e-3});
      patch.test(
        "shear",
        true,
        [&](const Point<3> &x) {
          std::array<Tensor<1, 3>, 2> v;
          for (unsigned int face = 0; face < 2; ++face)
            v[face] = Point<3>(0, 0, gamma[0] * x[0] + gamma[1] * x[1]);
          return v;
        },
        patch.strains({}, gamma, 0),
        0,
        true);
    }
    {
      // no tangential resultants
      const double             thicken = -1e-3;
      const Resultants::Matrix D       = patch.laminate.stiffness();
      Resultants::Vector       exact;
      exact[Resultants::thickness] = thicken;
      // the resultant of the thickness on the area is p times the thickness
      const double p =
        -D[Resultants::thickness][Resultants::thickness] * thicken / h;
      patch.test(
        "thickness",
        true,
        [&](const Point<3> &) {
          std::array<Tensor<1, 3>, 2> v;
          for (unsigned int face = 0; face < 2; ++face)
            v[face] = Point<3>(0, 0, (face ? 1 : -1) * thicken * h / 2);
          return v;
        },
        exact,
        p);
    }
    {
      // a stretch and a shear in the plane, turned in space
      const Tensor<2, 3> turn =
        Physics::Transformations::Rotations::rotation_matrix_3d(
          Point<3>(Point<3>(1, 2, -1) / Point<3>(1, 2, -1).norm()), 1.9);
      const Tensor<2, 2> F({{1.3, 0.2}, {-0.1, 0.9}});
      const Tensor<2, 2> e =
        (transpose(F) * F - Tensor<2, 2>(unit_symmetric_tensor<2>())) / 2;
      Resultants::Vector exact     = patch.strains({{e, e}}, {}, 0);
      exact[Resultants::thickness] = patch.free_thickness_strain(exact);
      const double stretch = std::sqrt(1 + 2 * exact[Resultants::thickness]);
      patch.test(
        "large deformation",
        false,
        [&](const Point<3> &x) {
          std::array<Tensor<1, 3>, 2> v;
          for (unsigned int face = 0; face < 2; ++face)
            {
              const double   z = (face ? 1 : -1) * h / 2;
              const Point<3> y(F[0][0] * x[0] + F[0][1] * x[1],
                               F[1][0] * x[0] + F[1][1] * x[1],
                               stretch * z);
              v[face] = turn * y - (x + Point<3>(0, 0, z));
            }
          return v;
        },
        exact);
    }
  }
} // namespace


int
main()
{
  for (const auto formulation : {Formulation::standard, Formulation::vertices})
    for (const double thickness : {0.001, 0.05})
      test_all(thickness, formulation);
}
