// SPDX-License-Identifier: LGPL-2.1-or-later

#include <biface/element/quadrilateral.h>

namespace Biface
{
  using namespace dealii;

  namespace
  {
    /** The value of @f$1,\xi_1,\xi_2,\xi_1\xi_2@f$ (i = 0 to 3) at a vertex,
     * ±1. */
    constexpr double
    sign(const unsigned int i, const unsigned int vertex)
    {
      return ((i & 1) && !(vertex & 1) ? -1. : 1.) *
             ((i & 2) && !(vertex & 2) ? -1. : 1.);
    }


    /** The sign of half the difference in the displacement of a face. */
    constexpr std::array<double, 2> face_sign{{-1, 1}};


    /** The number of the mode of the strain @p s that varies along
     * @f$\xi_{3-a}@f$ (a from 0 or 1): that of the tangent a. */
    constexpr unsigned int
    varying(const unsigned int a, const unsigned int s)
    {
      return Modes::mode_of[1 + a][s];
    }


    /** The products of the directors 1, 2, 12 with 0 and among each other, in
     * the order 00, 11, 22, 33, 01, 02, 03, 12, 13, 23. */
    constexpr std::array<std::array<unsigned int, 2>, 10> pairs_of_directors{
      {{{0, 0}},
       {{1, 1}},
       {{2, 2}},
       {{3, 3}},
       {{0, 1}},
       {{0, 2}},
       {{0, 3}},
       {{1, 2}},
       {{1, 3}},
       {{2, 3}}}};
  } // namespace


  Quadrilateral::Quadrilateral(const Shape &shape, const Options &options)
  {
    std::array<double, 4> thickness;
    double                mean_thickness = 0;
    NodalVectors          nodal;
    for (unsigned int q = 0; q < 4; ++q)
      {
        const auto &heights = shape.heights[q];
        thickness[q]        = heights[1] - heights[0];
        mean_thickness += thickness[q] / 4;
        // the vectors do not depend on the origin
        nodal[q] = shape.positions[q] - shape.positions[0] +
                   (heights[0] + heights[1]) / 2 * shape.normals[q];
        nodal[4 + q] = thickness[q] / 2 * shape.normals[q];
      }

    // the tangents and c of the faces, without slopes and components
    std::array<std::array<Tensor<1, 3>, 2>, 2> g;
    std::array<Tensor<1, 3>, 2>                c;
    for (unsigned int q = 0; q < 4; ++q)
      for (unsigned int face = 0; face < 2; ++face)
        {
          const Tensor<1, 3> p = nodal[q] + face_sign[face] * nodal[4 + q];
          for (unsigned int a = 0; a < 2; ++a)
            g[face][a] += sign(1 << a, q) / 4 * p;
          c[face] += sign(3, q) / 4 * p;
        }

    std::array<std::array<double, 2>, 2> slope{};
    for (unsigned int face = 0; face < 2; ++face)
      {
        for (unsigned int a = 0; a < 2; ++a)
          for (unsigned int q = 0; q < 4; ++q)
            slope[face][a] += sign(1 << a, q) / 4 * shape.heights[q][face];
        const double g_11 = g[face][0] * g[face][0],
                     g_12 = g[face][0] * g[face][1],
                     g_22 = g[face][1] * g[face][1], c_1 = g[face][0] * c[face],
                     c_2         = g[face][1] * c[face],
                     determinant = g_11 * g_22 - g_12 * g_12;
        components[face]         = {{(g_22 * c_1 - g_12 * c_2) / determinant,
                                     (g_11 * c_2 - g_12 * c_1) / determinant}};
      }

    for (unsigned int q = 0; q < 4; ++q)
      for (const unsigned int r : {q, 4 + q})
        {
          const bool is_half = (r >= 4);
          for (unsigned int i = 0; i < 4; ++i)
            factors[director(i)][r] =
              (is_half ? sign(i, q) / (2 * thickness[q]) : 0.);
          for (unsigned int face = 0; face < 2; ++face)
            {
              const double of_face = (is_half ? face_sign[face] : 1.) / 4;
              const double of_c    = of_face * sign(3, q);
              factors[hourglass(face)][r] = of_c;
              factors[warp(face)][r]      = of_c;
              for (unsigned int a = 0; a < 2; ++a)
                {
                  const double of_g = of_face * sign(1 << a, q);
                  factors[warp(face)][r] -= components[face][a] * of_g;
                  factors[tangent(face, a)][r] =
                    of_g - slope[face][a] * factors[director(0)][r];
                }
            }
        }
    reference = vectors(nodal);

    // the middle surface
    std::array<Tensor<1, 3>, 2> g_middle;
    for (unsigned int a = 0; a < 2; ++a)
      g_middle[a] = (g[0][a] + g[1][a]) / 2;
    const Tensor<1, 3> c_middle = (c[0] + c[1]) / 2;
    Tensor<1, 3>       normal   = cross_product_3d(g_middle[0], g_middle[1]);
    const double       area     = normal.norm();
    normal /= area;
    weight = 4 * area;
    const std::array<double, 2> gradient_of_area{
      {cross_product_3d(g_middle[0], c_middle) * normal / area,
       cross_product_3d(c_middle, g_middle[1]) * normal / area}};

    frame[0] = shape.direction - (shape.direction * normal) * normal;
    frame[0] /= frame[0].norm();
    frame[2] = normal;
    frame[1] = cross_product_3d(frame[2], frame[0]);

    // about 1 in cells shorter than the wall is thick, about 0 in thin shells,
    // which would lock with 1
    const double wall =
      (options.wall_thickness > 0 ? options.wall_thickness : mean_thickness);
    std::array<double, 2> phi, phi_director;
    for (unsigned int a = 0; a < 2; ++a)
      {
        const auto factor_of = [](const double length, const double thickness) {
          const double ratio = length / thickness;
          return 1 / (1 + ratio * ratio / 12);
        };
        phi[a] =
          (options.means ? factor_of(2 * g_middle[1 - a].norm(), mean_thickness)
                         : 0.);
        phi_director[a] =
          (options.mean_director ? factor_of(2 * g_middle[a].norm(), wall)
                                 : 0.);
        shear_of_warp[a] = 2. / 3 * phi[a];
      }
    for (unsigned int face = 0; face < 2; ++face)
      for (unsigned int a = 0; a < 2; ++a)
        of_warp[face][a] = (1 - 2. / 3 * phi[a]) /
                           (1 - components[face][0] * components[face][0] -
                            components[face][1] * components[face][1]);

    // with the interpolated director; the constant mode is the mean over the
    // area
    const double phi_1 = phi_director[0], phi_2 = phi_director[1];
    const double j_1 = gradient_of_area[0] / 3, j_2 = gradient_of_area[1] / 3;
    const double along_1 = 1 - 2. / 3 * phi_1 * phi_2;
    of_directors         = {};
    of_directors[0]      = {{0.5,
                             0.5 - phi_1 / 3,
                             0.5 - phi_2 / 3,
                             0.5 - 4. / 9 * phi_1 * phi_2,
                             j_1,
                             j_2,
                             0,
                             0,
                             j_2 * along_1,
                             j_1 * along_1}};
    of_directors[1][5] = of_directors[2][4] = 1;
    of_directors[1][8] = of_directors[2][9] = along_1;
    of_directors[3][6] = of_directors[3][7] = 1;

    // the constant modes in the frame of the material, and the others along
    // the tangents
    const auto in_plane = [this](const Tensor<1, 3> &x) {
      Tensor<1, 2> y;
      for (unsigned int i = 0; i < 2; ++i)
        y[i] = frame[i] * x;
      return y;
    };
    std::array<std::array<Tensor<1, 2>, 2>, 2> J;
    for (unsigned int face = 0; face < 2; ++face)
      {
        for (unsigned int a = 0; a < 2; ++a)
          {
            J[face][a]              = in_plane(reference[tangent(face, a)]);
            tangents.faces[face][a] = J[face][a] / J[face][a].norm();
          }
        Tensor<2, 2> K;
        K[0] = J[face][0];
        K[1] = J[face][1];
        // K[i][a], the derivative of the coordinate a along axis i
        K       = invert(K);
        auto &T = constant_tangential[face];
        for (unsigned int i = 0; i < 2; ++i)
          {
            T[i][0] = K[i][0] * K[i][0];
            T[i][1] = K[i][1] * K[i][1];
            T[i][2] = K[i][0] * K[i][1];
          }
        T[2][0] = 2 * K[0][0] * K[1][0];
        T[2][1] = 2 * K[0][1] * K[1][1];
        T[2][2] = K[0][0] * K[1][1] + K[0][1] * K[1][0];
      }
    Tensor<2, 2> J_middle;
    for (unsigned int a = 0; a < 2; ++a)
      {
        J_middle[a]        = in_plane(g_middle[a]);
        const double norm  = J_middle[a].norm();
        varying_shear[a]   = 1 / norm;
        tangents.middle[a] = J_middle[a] / norm;
      }
    constant_shear = invert(J_middle);

    const double height = c_middle * normal / mean_thickness;
    const double soft =
      (options.soft_warp ? 1 / std::sqrt(1 + 12 * height * height) : 1.);
    for (unsigned int a = 0; a < 2; ++a)
      {
        // T_H^T T_E for the tangential strains of the faces and the twist
        Tensor<2, 3> product;
        for (unsigned int face = 0; face < 2; ++face)
          {
            const auto  &of_face = J[face];
            const auto  &t       = tangents.faces[face];
            const double along   = of_face[a] * t[a];
            product[face][face]  = along * along;
            if (!options.means)
              continue;
            product[face][2] =
              face_sign[face] * (of_face[a] * t[0]) * (of_face[a] * t[1]);
            product[2][face] =
              face_sign[face] * (of_face[0] * t[a]) * (of_face[1] * t[a]);
            product[2][2] += ((of_face[0] * t[0]) * (of_face[1] * t[1]) +
                              (of_face[0] * t[1]) * (of_face[1] * t[0])) /
                             2;
          }
        if (!options.means)
          product[2][2] = 1;
        varying_tangential[a] = invert(product);
        for (unsigned int i = 0; i < 3; ++i)
          for (unsigned int face = 0; face < 2; ++face)
            varying_tangential[a][i][face] *= soft;
        if (!options.means)
          varying_tangential[a][2] = 0;
      }
  }


  template <typename Function>
  inline void
  Quadrilateral::for_products(const Function &function) const
  {
    using namespace Resultants;
    for (unsigned int face = 0; face < 2; ++face)
      {
        const unsigned int c = hourglass(face), w = warp(face);
        const auto        &C = components[face];
        function(tangential(2, face), tangent(face, 0), tangent(face, 1), 1.);
        for (unsigned int a = 0; a < 2; ++a)
          {
            const unsigned int g = tangent(face, a), along = director(2 - a);
            const double       of_square = of_warp[face][a];

            function(tangential(a, face), g, g, 0.5);
            function(tangential(a, face), w, w, of_square / 2);

            const unsigned int bending = varying(a, tangential(a, face));
            function(bending, g, w, 1.);
            function(bending, w, w, -C[a] * of_square);
            // the twist that varies along the other coordinate
            const unsigned int twist = varying(1 - a, Modes::twist);
            function(twist, g, w, face_sign[face] / 2);
            function(twist, w, w, -face_sign[face] / 2 * C[a] * of_square);

            function(transverse(a, face), g, director(0), 1.);
            function(transverse(a, face), c, along, 1.);
            function(transverse(a, face), w, along, -shear_of_warp[a]);
            const unsigned int shear = varying(a, transverse(a, face));
            function(shear, g, along, 1.);
            function(shear, c, director(0), 1.);
            for (unsigned int b = 0; b < 2; ++b)
              {
                function(shear, tangent(face, b), director(0), -C[b]);
                function(shear, c, director(2 - b), -C[b]);
              }
          }
      }
    for (unsigned int m = 0; m < 4; ++m)
      for (unsigned int i = 0; i < pairs_of_directors.size(); ++i)
        if (of_directors[m][i] != 0)
          function(Modes::mode_of[m][thickness],
                   director(pairs_of_directors[i][0]),
                   director(pairs_of_directors[i][1]),
                   of_directors[m][i]);
  }


  Quadrilateral::Vectors
  Quadrilateral::vectors(const NodalVectors &nodal) const
  {
    Vectors x;
    for (unsigned int k = 0; k < n_vectors; ++k)
      for (unsigned int r = 0; r < n_nodal; ++r)
        x[k] += factors[k][r] * nodal[r];
    return x;
  }


  Quadrilateral::NodalVectors
  Quadrilateral::conjugate_at_nodes(const Vectors &conjugate) const
  {
    NodalVectors nodal;
    for (unsigned int k = 0; k < n_vectors; ++k)
      for (unsigned int r = 0; r < n_nodal; ++r)
        nodal[r] += factors[k][r] * conjugate[k];
    return nodal;
  }


  Modes::Vector
  Quadrilateral::products(const Vectors &x, const Vectors &y) const
  {
    Modes::Vector sum;
    for_products([&](const unsigned int mode,
                     const unsigned int k,
                     const unsigned int l,
                     const double       factor) {
      sum[mode] += factor * (x[k] * y[l] + x[l] * y[k]);
    });
    return sum;
  }


  template <typename Function>
  inline void
  Quadrilateral::for_blocks(const Function &function) const
  {
    using namespace Resultants;
    for (unsigned int face = 0; face < 2; ++face)
      {
        function(
          std::array<unsigned int, 3>{
            {tangential(0, face), tangential(1, face), tangential(2, face)}},
          constant_tangential[face]);
        function(std::array<unsigned int, 2>{{transverse(0, face),
                                              transverse(1, face)}},
                 constant_shear);
        for (unsigned int a = 0; a < 2; ++a)
          function(
            std::array<unsigned int, 1>{{varying(a, transverse(a, face))}},
            Tensor<2, 1>({{varying_shear[a]}}));
      }
    for (unsigned int a = 0; a < 2; ++a)
      function(std::array<unsigned int, 3>{{varying(a, tangential(a, inner)),
                                            varying(a, tangential(a, outer)),
                                            varying(a, Modes::twist)}},
               varying_tangential[a]);
  }


  Modes::Vector
  Quadrilateral::physical(const Modes::Vector &covariant) const
  {
    Modes::Vector E = covariant;
    for_blocks([&](const auto &modes, const auto &T) {
      for (unsigned int i = 0; i < modes.size(); ++i)
        {
          E[modes[i]] = 0;
          for (unsigned int j = 0; j < modes.size(); ++j)
            E[modes[i]] += T[i][j] * covariant[modes[j]];
        }
    });
    return E;
  }


  Modes::Vector
  Quadrilateral::covariant_resultants(const Modes::Vector &H) const
  {
    Modes::Vector result = H;
    for_blocks([&](const auto &modes, const auto &T) {
      for (unsigned int j = 0; j < modes.size(); ++j)
        {
          result[modes[j]] = 0;
          for (unsigned int i = 0; i < modes.size(); ++i)
            result[modes[j]] += T[i][j] * H[modes[i]];
        }
    });
    return result;
  }


  Modes::Vector
  Quadrilateral::hourglass_strain(const Vectors &change) const
  {
    Modes::Vector covariant;
    for (unsigned int face = 0; face < 2; ++face)
      for (unsigned int a = 0; a < 2; ++a)
        covariant[Resultants::tangential(a, face)] =
          of_warp[face][a] / 2 * change[warp(face)].norm_square();
    return physical(covariant);
  }


  Quadrilateral::Form
  Quadrilateral::form(const Modes::Vector &H) const
  {
    Form result{};
    for_products([&](const unsigned int mode,
                     const unsigned int k,
                     const unsigned int l,
                     const double       factor) {
      result[k][l] += factor * H[mode];
      result[l][k] += factor * H[mode];
    });
    return result;
  }


  Quadrilateral::Vectors
  Quadrilateral::apply(const Form &form, const Vectors &x)
  {
    Vectors y;
    for (unsigned int k = 0; k < n_vectors; ++k)
      for (unsigned int l = 0; l < n_vectors; ++l)
        if (form[k][l] != 0)
          y[k] += form[k][l] * x[l];
    return y;
  }


  Quadrilateral::NodalForm
  Quadrilateral::at_nodes(const Form &form) const
  {
    NodalForm result{};
    for (unsigned int k = 0; k < n_vectors; ++k)
      {
        std::array<double, n_nodal> row{};
        for (unsigned int l = 0; l < n_vectors; ++l)
          if (form[k][l] != 0)
            for (unsigned int s = 0; s < n_nodal; ++s)
              row[s] += form[k][l] * factors[l][s];
        for (unsigned int r = 0; r < n_nodal; ++r)
          for (unsigned int s = 0; s < n_nodal; ++s)
            result[r][s] += factors[k][r] * row[s];
      }
    return result;
  }


  void
  Quadrilateral::variation(const Vectors &x, Rows &rows) const
  {
    for (auto &row : rows)
      row.fill(0);
    for_products([&](const unsigned int mode,
                     const unsigned int k,
                     const unsigned int l,
                     const double       factor) {
      auto       &row  = rows[mode];
      const auto &of_k = factors[k], &of_l = factors[l];
      for (unsigned int i = 0; i < 3; ++i)
        {
          const double by_k = factor * x[l][i], by_l = factor * x[k][i];
          for (unsigned int r = 0; r < n_nodal; ++r)
            row[n_nodal * i + r] += by_k * of_k[r] + by_l * of_l[r];
        }
    });

    for_blocks([&](const auto &modes, const auto &T) {
      constexpr unsigned int n =
        std::tuple_size_v<std::decay_t<decltype(modes)>>;
      std::array<std::array<double, 3 * n_nodal>, n> result{};
      for (unsigned int i = 0; i < n; ++i)
        for (unsigned int j = 0; j < n; ++j)
          for (unsigned int k = 0; k < 3 * n_nodal; ++k)
            result[i][k] += T[i][j] * rows[modes[j]][k];
      for (unsigned int i = 0; i < n; ++i)
        rows[modes[i]] = result[i];
    });
  }
} // namespace Biface
