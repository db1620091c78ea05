// SPDX-License-Identifier: LGPL-2.1-or-later

#include <algorithm>
#include <utility>

#include <biface/element/director_tilt.h>
#include <biface/element/element_geometry.h>
#include <biface/element/quadrilateral.h>

namespace Biface
{
  using namespace dealii;

  namespace
  {
    /** The numerator and the denominator of t. */
    template <std::size_t n>
    std::pair<double, double>
    sums(const std::array<Tensor<1, 3>, n> &d,
         const std::array<double, n>       &weights)
    {
      double weighted = 0, all = 0;
      for (unsigned int k = 0; k < n; ++k)
        {
          weighted += weights[k] * d[k].norm_square();
          all += d[k].norm_square();
        }
      return {weighted, all};
    }
  } // namespace


  DirectorTilt::DirectorTilt(const ElementGeometry &geometry)
    : geometry(geometry)
  {
    const Quadrilateral &cell = *geometry.quadrilateral;
    for (unsigned int k = 0; k < n; ++k)
      undeformed[k] = cell.undeformed()[Quadrilateral::director(k)];
    const auto in_strain = cell.thickness_strain_of_tilt();
    std::copy(in_strain.begin(), in_strain.end(), weights.begin() + 1);
  }


  double
  DirectorTilt::factor_of(const unsigned int k, const unsigned int vertex) const
  {
    const double xi = (vertex & 1 ? 1 : -1), eta = (vertex & 2 ? 1 : -1);
    const std::array<double, n> shape{{1, xi, eta, xi * eta}};
    return shape[k] / (2 * geometry.vertices[vertex].thickness);
  }


  DirectorTilt::Vectors
  DirectorTilt::changes(const MixedElement::NodalVector &V) const
  {
    Vectors result;
    for (unsigned int q = 0; q < 4; ++q)
      {
        Tensor<1, 3> half_difference;
        for (unsigned int i = 0; i < 3; ++i)
          half_difference[i] =
            V[MixedElement::dof(q, i, MixedElement::half_difference)];
        const Tensor<1, 3> change = geometry.vertices[q].axes * half_difference;
        for (unsigned int k = 0; k < n; ++k)
          result[k] += factor_of(k, q) * change;
      }
    return result;
  }


  double
  DirectorTilt::value(const MixedElement::NodalVector &V) const
  {
    // no difference of large numbers
    const Vectors change       = changes(V);
    const auto [weighted, all] = sums(undeformed, weights);
    double of_weighted = 0, of_all = 0;
    for (unsigned int k = 0; k < n; ++k)
      {
        const double of_square = (2 * undeformed[k] + change[k]) * change[k];
        of_weighted += weights[k] * of_square;
        of_all += of_square;
      }
    return geometry.weight * (of_weighted - weighted / all * of_all) /
           (all + of_all);
  }


  void
  DirectorTilt::add_gradient(const double                     factor,
                             const MixedElement::NodalVector &V,
                             MixedElement::NodalVector       &gradient) const
  {
    add_mean_gradient(factor, V, V, gradient);
  }


  void
  DirectorTilt::add_mean_gradient(const double                     factor,
                                  const MixedElement::NodalVector &start,
                                  const MixedElement::NodalVector &end,
                                  MixedElement::NodalVector &gradient) const
  {
    Vectors d = changes(start), d_end = changes(end);
    for (unsigned int k = 0; k < n; ++k)
      {
        d[k] += undeformed[k];
        d_end[k] += undeformed[k];
      }
    const auto [weighted_start, all_start] = sums(d, weights);
    const auto [weighted_end, all_end]     = sums(d_end, weights);
    for (unsigned int k = 0; k < n; ++k)
      d[k] = (d[k] + d_end[k]) / 2;

    // N_1/M_1 - N_0/M_0 = ((N_1 - N_0) M - (M_1 - M_0) N)/(M_0 M_1) with the
    // means N and M
    const double weighted = (weighted_start + weighted_end) / 2,
                 all      = (all_start + all_end) / 2;
    const double scale = 2 * factor * geometry.weight / (all_start * all_end);
    for (unsigned int q = 0; q < 4; ++q)
      {
        Tensor<1, 3> sum;
        for (unsigned int k = 0; k < n; ++k)
          sum += factor_of(k, q) * (weights[k] * all - weighted) * d[k];
        sum = scale * (transpose(geometry.vertices[q].axes) * sum);
        for (unsigned int i = 0; i < 3; ++i)
          gradient[MixedElement::dof(q, i, MixedElement::half_difference)] +=
            sum[i];
      }
  }


  void
  DirectorTilt::add_second_derivative(const double                     factor,
                                      const MixedElement::NodalVector &V,
                                      MixedElement::NodalMatrix       &K) const
  {
    Vectors d = changes(V);
    for (unsigned int k = 0; k < n; ++k)
      d[k] += undeformed[k];
    const auto [weighted, all] = sums(d, weights);
    const double mean          = weighted / all,
                 scale         = 2 * factor * geometry.weight / all;

    // in the axes of each vertex, the sums over the coefficients with and
    // without their weights
    std::array<std::array<Tensor<1, 3>, 2>, 4> of_vertex;
    for (unsigned int q = 0; q < 4; ++q)
      {
        for (unsigned int k = 0; k < n; ++k)
          {
            of_vertex[q][0] += factor_of(k, q) * d[k];
            of_vertex[q][1] += factor_of(k, q) * (weights[k] - mean) * d[k];
          }
        for (Tensor<1, 3> &vector : of_vertex[q])
          vector = transpose(geometry.vertices[q].axes) * vector;
      }

    for (unsigned int r = 0; r < 4; ++r)
      for (unsigned int s = 0; s < 4; ++s)
        {
          double sum = 0;
          for (unsigned int k = 0; k < n; ++k)
            sum += (weights[k] - mean) * factor_of(k, r) * factor_of(k, s);
          const Tensor<2, 3> block =
            sum * (transpose(geometry.vertices[r].axes) *
                   geometry.vertices[s].axes) -
            2 / all *
              (outer_product(of_vertex[r][0], of_vertex[s][1]) +
               outer_product(of_vertex[r][1], of_vertex[s][0]));
          for (unsigned int i = 0; i < 3; ++i)
            for (unsigned int j = 0; j < 3; ++j)
              K[MixedElement::dof(r, i, MixedElement::half_difference)]
               [MixedElement::dof(s, j, MixedElement::half_difference)] +=
                scale * block[i][j];
        }
  }
} // namespace Biface
