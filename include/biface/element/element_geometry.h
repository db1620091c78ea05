// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_element_element_geometry_h
#define biface_element_element_geometry_h

#include <deal.II/base/symmetric_tensor.h>
#include <deal.II/base/tensor.h>

#include <array>
#include <memory>

#include <biface/element/formulation.h>
#include <biface/element/strain.h>

namespace Biface
{
  struct CellTangents;
  class Quadrilateral;


  /**
   * The geometry of the shell in an element, computed once by ShellFEValues and
   * then used in every iteration. Independent of the kind of surface.
   *
   * Vertices are numbered as in deal.II, lexicographically with
   * @f$\alpha_1@f$ running fastest. The neighbor of vertex q along
   * @f$\alpha_1@f$ is `q ^ 1`, along @f$\alpha_2@f$ is `q ^ 2`.
   */
  struct ElementGeometry
  {
    struct Vertex
    {
      /** The derivatives @f$N_{q,a}/A_a@f$ of the shape function of this
       * vertex; those for its neighbor along @f$\alpha_a@f$ are the negative,
       * the others vanish. Unit: 1/length. */
      std::array<double, 2> slope;

      /** The matrix of the derivative in frame components, see
       * SurfacePoint::connection(). Zero if vectors are interpolated. */
      std::array<dealii::Tensor<2, 3>, 2> connection;

      ThicknessMetric metric;

      /** The thickness h at this vertex. */
      double thickness;

      /** The slopes of the faces relative to the reference surface,
       * `face_slope[face][a]` @f$=\delta^\pm_{,a}/A_a@f$. Zero if the thickness
       * is constant. */
      std::array<std::array<double, 2>, 2> face_slope;

      /** The frame @f$\mathbf e_1,\mathbf e_2,\mathbf e_3@f$ in columns, which
       * turns components in the frame into a Cartesian vector. */
      dealii::Tensor<2, 3> axes;
    };

    std::array<Vertex, 4> vertices;

    /** The faces along the cell, see FollowerPressure: quadratic in
     * @f$\alpha_1@f$ between three stations, the two sides and the middle of
     * the cell, and linear in @f$\alpha_2@f$, with components in a frame that
     * turns with @f$\alpha_2@f$. That is the frame of the surface in the
     * middle if components are interpolated, and the one of vertex 0, which
     * does not turn, if vectors are. */
    struct Stations
    {
      static constexpr unsigned int n = 3;

      /** The positions of the undeformed faces, `[face][station][side of
       * alpha_2]`, from a point on the axis around which the frame turns. Unit:
       * length. */
      std::array<std::array<std::array<dealii::Tensor<1, 3>, 2>, n>, 2>
        positions;

      /** The point from which positions count, and the frame on the side of
       * vertex 0 in columns, which turns components into a Cartesian vector. */
      dealii::Tensor<1, 3> origin;
      dealii::Tensor<2, 3> axes;

      /** The matrices that turn the components at a vertex into those at the
       * station of its own side, and at the one in the middle, which has the
       * mean of both sides. */
      std::array<dealii::Tensor<2, 3>, 4> at_side, at_middle;

      /** The derivative of a vector that keeps its components, by half of the
       * cell's length in @f$\alpha_2@f$; skew-symmetric. */
      dealii::Tensor<2, 3> spin;
    };

    /** The faces along the cell, from which the forces of a pressure follow. */
    Stations stations;

    /** The matrix that turns components at vertex @p s before the interpolation
     * adds them to components at vertex @p r: the unit tensor if components are
     * interpolated, those of the same vector in the frame of @p r if vectors
     * are. */
    dealii::Tensor<2, 3>
    turn(const unsigned int r, const unsigned int s) const
    {
      return formulation == Formulation::paper
               ? dealii::Tensor<2, 3>(dealii::unit_symmetric_tensor<3>())
               : transpose(vertices[r].axes) * vertices[s].axes;
    }

    /**
     * The derivative of a vector along @f$\alpha_a@f$ at vertex @p q, divided
     * by @f$A_a@f$.
     *
     * @param own the components at the vertex.
     * @param other the components at its neighbor.
     */
    dealii::Tensor<1, 3>
    derivative(const unsigned int          q,
               const unsigned int          a,
               const dealii::Tensor<1, 3> &own,
               const dealii::Tensor<1, 3> &other) const
    {
      const Vertex &vertex = vertices[q];
      if (formulation != Formulation::paper)
        return vertex.slope[a] * (own - turn(q, q ^ (1 << a)) * other);
      dealii::Tensor<1, 3> d;
      for (unsigned int i = 0; i < 3; ++i)
        d[i] = vertex.slope[a] * (own[i] - other[i]) +
               vertex.connection[a][i][0] * own[0] +
               vertex.connection[a][i][1] * own[1] +
               vertex.connection[a][i][2] * own[2];
      return d;
    }

    /** The vectors that are work-conjugate to the components at the vertex and
     * at its neighbor, from the vector @p p that is to the derivative: the
     * transpose of derivative(), where components are interpolated. */
    std::array<dealii::Tensor<1, 3>, 2>
    conjugate_of_derivative(const unsigned int          q,
                            const unsigned int          a,
                            const dealii::Tensor<1, 3> &p) const
    {
      const Vertex                       &vertex = vertices[q];
      std::array<dealii::Tensor<1, 3>, 2> result;
      for (unsigned int i = 0; i < 3; ++i)
        {
          result[0][i] = vertex.slope[a] * p[i] +
                         p[0] * vertex.connection[a][0][i] +
                         p[1] * vertex.connection[a][1][i] +
                         p[2] * vertex.connection[a][2][i];
          result[1][i] = -vertex.slope[a] * p[i];
        }
      return result;
    }

    /**
     * The constant weight of the element's strains and resultants,
     * @f$w=\bar\mu\,4l_1l_2@f$: the area of the middle surface, with
     * @f$\bar\mu = A_1A_2\bar\zeta_1\bar\zeta_2@f$ at the center of the
     * element; see Quadrilateral::area() where vectors are interpolated.
     */
    double weight;

    /** The part of the weight that belongs to each vertex: where the sides are
     * not coordinate lines, the integral of its shape function, which makes
     * constant loads consistent; a quarter otherwise. */
    std::array<double, 4> vertex_areas;

    /** The area per area of the unit square over the cell, linear in its
     * coordinates: `[0]` at the center, and `[1 + a]` its change from there to
     * the side at which the coordinate a is 1. The vertex_areas are its
     * integrals. */
    std::array<double, 3>
    area_density() const
    {
      std::array<double, 3> density{{weight, 0, 0}};
      for (unsigned int a = 0; a < 2; ++a)
        for (unsigned int v = 0; v < 4; ++v)
          density[1 + a] += ((v >> a) & 1 ? 3 : -3) * vertex_areas[v];
      return density;
    }

    Formulation formulation = Formulation::standard;

    /** The strains of the cell; null with Formulation::paper. */
    std::shared_ptr<const Quadrilateral> quadrilateral;
    /** Whether the thickness strain is that of the distance of the faces, as in
     * walls of several layers, see NormalThickness. */
    bool normal_thickness = false;
    /** Whether the sides are coordinate lines, along which the axes of the
     * material are taken; otherwise they have directions of their own, see
     * Quadrilateral::get_tangents(). */
    bool along_lines = true;

    /** The tangents of the cell, null if the sides are coordinate lines. */
    const CellTangents *
    tangents() const;
  };
} // namespace Biface

#endif
