// SPDX-License-Identifier: LGPL-2.1-or-later

#include <biface/element/follower_pressure.h>

namespace Biface
{
  using namespace dealii;

  namespace
  {
    /** A point on @f$(-1,1)@f$. */
    struct GaussPoint
    {
      double x, weight;
    };

    constexpr std::array<GaussPoint, 3> along_1{
      {{-0.77459666924148337704, 5. / 9},
       {0, 8. / 9},
       {0.77459666924148337704, 5. / 9}}};

    constexpr std::array<GaussPoint, 2> along_2{
      {{-0.57735026918962576451, 1}, {0.57735026918962576451, 1}}};

    /** Quadratic shape functions of the stations, and their derivatives. */
    constexpr std::array<double, 3>
    of_stations(const double x)
    {
      return {{x * (x - 1) / 2, 1 - x * x, x * (x + 1) / 2}};
    }

    constexpr std::array<double, 3>
    slopes_of_stations(const double x)
    {
      return {{x - 0.5, -2 * x, x + 0.5}};
    }

    /** The linear shape functions of the sides of a cell. */
    constexpr std::array<double, 2>
    of_sides(const double x)
    {
      return {{(1 - x) / 2, (1 + x) / 2}};
    }

    constexpr std::array<double, 2> slope_of_side{{-0.5, 0.5}};

    /** The matrix of @f$\mathbf a\times@f$. */
    Tensor<2, 3>
    cross_product_matrix(const Tensor<1, 3> &a)
    {
      Tensor<2, 3> A;
      A[0][1] = -a[2];
      A[0][2] = a[1];
      A[1][0] = a[2];
      A[1][2] = -a[0];
      A[2][0] = -a[1];
      A[2][1] = a[0];
      return A;
    }
  } // namespace


  FollowerPressure::FollowerPressure(const ElementGeometry           &geometry,
                                     const MixedElement::NodalVector &V,
                                     const Resultants::Face           face,
                                     const std::array<double, 4> &at_vertices)
    : geometry(geometry), face(face)
  {
    const auto                 &undeformed = geometry.stations.positions[face];
    std::array<Tensor<1, 3>, 4> v;
    for (unsigned int q = 0; q < 4; ++q)
      v[q] = MixedElement::face_displacement(V, q, face);

    for (unsigned int i = 0; i < n_points[0]; ++i)
      {
        // on the two sides of the cell
        std::array<Tensor<1, 3>, 2> x, slope;
        const auto                  N = of_stations(along_1[i].x),
                   dN                 = slopes_of_stations(along_1[i].x);
        const auto of_node            = shapes(i);
        for (unsigned int side = 0; side < 2; ++side)
          {
            for (unsigned int s = 0; s < ElementGeometry::Stations::n; ++s)
              {
                x[side] += N[s] * undeformed[s][side];
                slope[side] += dN[s] * undeformed[s][side];
              }
            for (const unsigned int q : {2 * side, 2 * side + 1})
              {
                x[side] += of_node[q].value * v[q];
                slope[side] += of_node[q].slope * v[q];
              }
          }

        std::array<Tensor<1, 3>, 2> force;
        for (unsigned int j = 0; j < n_points[1]; ++j)
          {
            const auto M     = of_sides(along_2[j].x),
                       along = of_sides(along_1[i].x);
            pressure[i][j]   = 0;
            auto &t          = tangents[i][j];
            for (unsigned int side = 0; side < 2; ++side)
              {
                positions[i][j] += M[side] * x[side];
                t[0] += M[side] * slope[side];
                t[1] += slope_of_side[side] * x[side] +
                        M[side] * (geometry.stations.spin * x[side]);
                pressure[i][j] +=
                  M[side] * (along[0] * at_vertices[2 * side] +
                             along[1] * at_vertices[2 * side + 1]);
              }
            pressure[i][j] *= (face == Resultants::inner ? 1 : -1) *
                              along_1[i].weight * along_2[j].weight;
            for (unsigned int side = 0; side < 2; ++side)
              force[side] +=
                M[side] * pressure[i][j] * cross_product_3d(t[0], t[1]);
          }
        for (unsigned int q = 0; q < 4; ++q)
          MixedElement::add_face_force(
            force[q >> 1] * of_node[q].value, q, face, nodal_force);
      }
  }


  std::array<FollowerPressure::Shape, 4>
  FollowerPressure::shapes(const unsigned int point) const
  {
    const auto N  = of_stations(along_1[point].x),
               dN = slopes_of_stations(along_1[point].x);
    const ElementGeometry::Stations &stations = geometry.stations;

    std::array<Shape, 4> result;
    for (unsigned int q = 0; q < 4; ++q)
      {
        const unsigned int side = (q & 1 ? 2 : 0);
        result[q].value =
          N[side] * stations.at_side[q] + N[1] / 2 * stations.at_middle[q];
        result[q].slope =
          dN[side] * stations.at_side[q] + dN[1] / 2 * stations.at_middle[q];
      }
    return result;
  }


  double
  FollowerPressure::flux(const Tensor<2, 3>        &A,
                         MixedElement::NodalVector *gradient,
                         const Tensor<1, 3>        &from) const
  {
    const ElementGeometry::Stations &stations = geometry.stations;
    const Tensor<2, 3>               A_in_frame =
      transpose(stations.axes) * A * stations.axes;
    const Tensor<1, 3> at_origin =
      (A * (stations.origin - from)) * stations.axes;

    double sum = 0;
    for (unsigned int i = 0; i < n_points[0]; ++i)
      {
        const auto of_node = shapes(i);
        for (unsigned int j = 0; j < n_points[1]; ++j)
          {
            const auto        &t    = tangents[i][j];
            const Tensor<1, 3> area = cross_product_3d(t[0], t[1]);
            const Tensor<1, 3> F    = A_in_frame * positions[i][j] + at_origin;
            sum += pressure[i][j] * (F * area);
            if (!gradient)
              continue;
            const auto         M       = of_sides(along_2[j].x);
            const Tensor<1, 3> per_x   = area * A_in_frame,
                               per_t_0 = cross_product_3d(t[1], F),
                               per_t_1 = cross_product_3d(F, t[0]);
            for (unsigned int q = 0; q < 4; ++q)
              {
                const unsigned int side = q >> 1;
                const Tensor<1, 3> per_value =
                  M[side] * (per_x + per_t_1 * stations.spin) +
                  slope_of_side[side] * per_t_1;
                MixedElement::add_face_force(
                  pressure[i][j] * (per_value * of_node[q].value +
                                    M[side] * per_t_0 * of_node[q].slope),
                  q,
                  face,
                  *gradient);
              }
          }
      }
    return sum;
  }


  void
  FollowerPressure::add_derivative(const double               factor,
                                   MixedElement::NodalMatrix &K) const
  {
    std::array<std::array<Tensor<2, 3>, 4>, 4> stiffness;
    for (unsigned int i = 0; i < n_points[0]; ++i)
      {
        const auto                  of_node = shapes(i);
        std::array<Tensor<2, 3>, 4> turned;
        for (unsigned int q = 0; q < 4; ++q)
          turned[q] = geometry.stations.spin * of_node[q].value;
        for (unsigned int j = 0; j < n_points[1]; ++j)
          {
            const auto         M = of_sides(along_2[j].x);
            const Tensor<2, 3> t_1 =
              factor * pressure[i][j] * cross_product_matrix(tangents[i][j][0]);
            const Tensor<2, 3> t_2 =
              factor * pressure[i][j] * cross_product_matrix(tangents[i][j][1]);
            for (unsigned int s = 0; s < 4; ++s)
              {
                const unsigned int side = s >> 1;
                // of the area vector
                const Tensor<2, 3> derivative =
                  t_1 * (slope_of_side[side] * of_node[s].value +
                         M[side] * turned[s]) -
                  t_2 * (M[side] * of_node[s].slope);
                for (unsigned int r = 0; r < 4; ++r)
                  stiffness[r][s] +=
                    M[r >> 1] * (transpose(of_node[r].value) * derivative);
              }
          }
      }
    for (unsigned int r = 0; r < 4; ++r)
      for (unsigned int s = 0; s < 4; ++s)
        MixedElement::add_stiffness(stiffness[r][s],
                                    r,
                                    MixedElement::face_sign[face],
                                    s,
                                    MixedElement::face_sign[face],
                                    K);
  }
} // namespace Biface
