// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_element_strain_means_h
#define biface_element_strain_means_h

#include <deal.II/base/tensor.h>

#include <array>

#include <biface/element/element_geometry.h>
#include <biface/element/mean_vectors.h>
#include <biface/element/modes.h>
#include <biface/element/strain.h>

namespace Biface
{
  /**
   * What StrainSampling::means adds to the strain modes: the scalar products of
   * MeanVectors
   * @f{align*}{
   *   \varepsilon_{aa}^\pm,\ 1:\quad&
   *     -\tfrac13\,\varphi_a\,[\mathbf d_a^\pm]_c\cdot[\mathbf d_a^\pm]_c, \\
   *   2\varepsilon_{a3}^\pm,\ 1:\quad&
   *     -\tfrac23\,\varphi_a\frac{\zeta_a^\pm}{\bar\zeta_a}\,
   *     [\mathbf d_a^\pm]_c\cdot[\mathbf n]_c, \\
   *   \text{twist},\ \xi_c:\quad&
   *     \tfrac12\,\bigl([\mathbf d_a^+]_c\cdot[\mathbf d_c^+]_0
   *     -[\mathbf d_a^-]_c\cdot[\mathbf d_c^-]_0\bigr),
   * @f}
   * @f$c\neq a@f$, less their values in the undeformed shell. With
   * @f$\varphi_a=1@f$ the first two turn means over the vertices into means
   * over the element; @f$\varphi_a=1/(1+L_c^2/12h^2)@f$, with the length
   * @f$L_c@f$ of the element along @f$\alpha_c@f$, keeps thin shells from
   * locking. See the page on the theory.
   */
  namespace StrainMeans
  {
    /** The mode of the twist as coefficient of @f$\xi_c@f$, @f$c\neq a@f$. */
    constexpr unsigned int
    twist_mode(const unsigned int a)
    {
      return Modes::mode_of[1 + a][Modes::twist];
    }


    /** The vectors of the undeformed shell. */
    inline MeanVectors
    undeformed(const ElementGeometry &geometry)
    {
      MeanVectors x;
      for (unsigned int q = 0; q < 4; ++q)
        for (unsigned int a = 0; a < 2; ++a)
          {
            const ElementGeometry::Vertex &vertex = geometry.vertices[q];
            const double                   sign   = MeanVectors::sign(a, q) / 4;
            for (unsigned int face = 0; face < 2; ++face)
              {
                const dealii::Tensor<1, 3> tangent =
                  vertex.axes * vertex.metric.tangents[face][a];
                x.slope[face][a] += sign * tangent;
                x.mean[face][a] += tangent / 4;
              }
            for (unsigned int i = 0; i < 3; ++i)
              x.director[a][i] += sign * vertex.axes[i][2];
          }
      return x;
    }


    /** The change of the vectors by displacements with the given gradients at
     * the vertices. */
    inline MeanVectors
    change(const ElementGeometry                     &geometry,
           const std::array<DisplacementGradient, 4> &gradients)
    {
      MeanVectors x;
      for (unsigned int q = 0; q < 4; ++q)
        {
          const ElementGeometry::Vertex &vertex = geometry.vertices[q];
          const dealii::Tensor<1, 3>     beta =
            vertex.axes * (gradients[q].beta / 4);
          for (unsigned int a = 0; a < 2; ++a)
            {
              const double sign = MeanVectors::sign(a, q);
              for (unsigned int face = 0; face < 2; ++face)
                {
                  const dealii::Tensor<1, 3> g =
                    vertex.axes * (gradients[q].g[face][a] /
                                   (4 * vertex.metric.zeta[face][a]));
                  x.slope[face][a] += sign * g;
                  x.mean[face][a] += g;
                }
              x.director[a] += sign * beta;
            }
        }
      return x;
    }


    /** The vectors that are work-conjugate to the gradients at a vertex, from
     * those that are to the vectors: the transpose of change(). */
    inline DisplacementGradient
    conjugate_at_vertex(const ElementGeometry &geometry,
                        const MeanVectors     &conjugate,
                        const unsigned int     q)
    {
      const ElementGeometry::Vertex &vertex = geometry.vertices[q];
      DisplacementGradient           p;
      for (unsigned int a = 0; a < 2; ++a)
        {
          const double sign = MeanVectors::sign(a, q);
          p.beta += sign * conjugate.director[a];
          for (unsigned int face = 0; face < 2; ++face)
            p.g[face][a] =
              ((sign * conjugate.slope[face][a] + conjugate.mean[face][a]) *
               vertex.axes) /
              (4 * vertex.metric.zeta[face][a]);
        }
      p.beta = (p.beta * vertex.axes) / 4;
      return p;
    }


    /** Add the symmetric bilinear form of the products of StrainMeans, times
     * @p factor, to the strain modes. */
    inline void
    add_products(const ElementGeometry &geometry,
                 const MeanVectors     &x,
                 const MeanVectors     &y,
                 const double           factor,
                 Modes::Vector         &strain)
    {
      using namespace Resultants;
      for (unsigned int a = 0; a < 2; ++a)
        {
          const unsigned int c   = 1 - a;
          const double       phi = factor / 3 * geometry.mean_factor[a];
          double             twist[2];
          for (unsigned int face = 0; face < 2; ++face)
            {
              strain[tangential(a, face)] -=
                phi * (x.slope[face][a] * y.slope[face][a]);
              strain[transverse(a, face)] -= phi *
                                             geometry.zeta_ratio[face][a] *
                                             (x.slope[face][a] * y.director[a] +
                                              y.slope[face][a] * x.director[a]);
              twist[face] = x.slope[face][a] * y.mean[face][c] +
                            y.slope[face][a] * x.mean[face][c];
            }
          strain[twist_mode(a)] += factor / 4 * (twist[outer] - twist[inner]);
        }
    }


    /** The second variation of the products of StrainMeans, weighted by
     * resultants: the coefficients by which they couple the vectors. */
    struct Coupling
    {
      /** The coefficients of @f$[\mathbf d_a]_c[\mathbf d_a]_c@f$, as
       * `slope[face][a]`. */
      std::array<std::array<double, 2>, 2> slope;
      /** The coefficients of @f$[\mathbf d_a]_c[\mathbf n]_c@f$, as
       * `director[face][a]`. */
      std::array<std::array<double, 2>, 2> director;
      /** The coefficients of @f$[\mathbf d_a]_c[\mathbf d_c]_0@f$, as
       * `twist[face][a]`. */
      std::array<std::array<double, 2>, 2> twist;

      /** The coupling by the resultants @p H.
       * @param H without the weights of modes, which are added here. */
      Coupling(const ElementGeometry &geometry, const Modes::Vector &H)
      {
        using namespace Resultants;
        for (unsigned int face = 0; face < 2; ++face)
          for (unsigned int a = 0; a < 2; ++a)
            {
              const double phi = -2. / 3 * geometry.mean_factor[a];
              slope[face][a]   = phi * H[tangential(a, face)];
              director[face][a] =
                phi * geometry.zeta_ratio[face][a] * H[transverse(a, face)];
              // the twist comes after the sampled strains of its group
              const Modes::Group &group = Modes::groups[1 + a];
              twist[face][a]            = (face == outer ? 1. : -1.) / 2 *
                               group.weight(group.sampled) * H[twist_mode(a)];
            }
      }

      /** The vectors that are work-conjugate to @p x: the coupling applied to
       * them. */
      MeanVectors
      apply(const MeanVectors &x) const
      {
        MeanVectors y;
        for (unsigned int face = 0; face < 2; ++face)
          for (unsigned int a = 0; a < 2; ++a)
            {
              const unsigned int c = 1 - a;
              y.slope[face][a]     = slope[face][a] * x.slope[face][a] +
                                 director[face][a] * x.director[a] +
                                 twist[face][a] * x.mean[face][c];
              y.director[a] += director[face][a] * x.slope[face][a];
              y.mean[face][c] = twist[face][a] * x.slope[face][a];
            }
        return y;
      }
    };


    /**
     * change() as matrices: with three rows each, and a column for each
     * component of a vector at each vertex, `[i][3 * q + j]`.
     *
     * The mean of a tangent is the matrix `tangent` times the displacements of
     * its face, plus `tilt` times `director` times the
     * @f$\boldsymbol\beta@f$ of the vertices where the thickness varies. With
     * the signs of the vertices the same matrices give the slopes.
     */
    struct Maps
    {
      static constexpr unsigned int n_columns = 12;
      using Matrix = std::array<std::array<double, n_columns>, 3>;

      /** The matrices of the means of the tangents, as `tangent[face][a]`. */
      alignas(64) std::array<std::array<Matrix, 2>, 2> tangent;
      /** The factors of @p director where the thickness varies, as
       * `tilt[face][a][q]`. */
      std::array<std::array<std::array<double, 4>, 2>, 2> tilt;
      Matrix                                              director;
      /** Whether any `tilt` is not zero. */
      bool tapered = false;

      /** The value of MeanVectors::sign() at the vertex of a column. */
      static constexpr double
      sign(const unsigned int a, const unsigned int column)
      {
        return MeanVectors::sign(a, column / 3);
      }

      explicit Maps(const ElementGeometry &geometry)
      {
        for (unsigned int q = 0; q < 4; ++q)
          {
            const ElementGeometry::Vertex &vertex = geometry.vertices[q];
            for (unsigned int i = 0; i < 3; ++i)
              for (unsigned int j = 0; j < 3; ++j)
                director[i][3 * q + j] = vertex.axes[i][j] / 4;
            for (unsigned int a = 0; a < 2; ++a)
              {
                const ElementGeometry::Vertex &neighbor =
                  geometry.vertices[q ^ (1 << a)];
                const dealii::Tensor<2, 3> own =
                  vertex.axes * vertex.connection[a] +
                  vertex.slope[a] * vertex.axes;
                const dealii::Tensor<2, 3> &seen_by_neighbor = neighbor.axes;
                for (unsigned int face = 0; face < 2; ++face)
                  {
                    const double by_own = 1 / (4 * vertex.metric.zeta[face][a]);
                    const double by_neighbor =
                      -neighbor.slope[a] / (4 * neighbor.metric.zeta[face][a]);
                    for (unsigned int i = 0; i < 3; ++i)
                      for (unsigned int j = 0; j < 3; ++j)
                        tangent[face][a][i][3 * q + j] =
                          by_own * own[i][j] +
                          by_neighbor * seen_by_neighbor[i][j];
                    tilt[face][a][q] =
                      -vertex.face_slope[face][a] / vertex.metric.zeta[face][a];
                    tapered = tapered || tilt[face][a][q] != 0;
                  }
              }
          }
      }
    };
  } // namespace StrainMeans
} // namespace Biface

#endif
