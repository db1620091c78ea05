// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_element_geometry_h
#define biface_element_geometry_h

#include <deal.II/base/tensor.h>
#include <deal.II/fe/fe_values.h>

#include <array>

#include <biface/element/strain.h>
#include <biface/surface/reference_surface.h>

namespace Biface
{
  /**
   * The geometry of the surface in an element, computed once from FEValues and
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
      /** @f$N_{q,a}/A_a@f$ for the shape function of this vertex; for its
       * neighbor along @f$\alpha_a@f$ it is the negative, the others vanish.
       * Unit: 1/length. */
      std::array<double, 2> slope;

      /** See SurfacePoint::connection(). */
      std::array<dealii::Tensor<2, 3>, 2> connection;

      ThicknessMetric metric;

      /** The thickness h at this vertex. */
      double thickness;

      /** `face_slope[face][a]` is @f$\delta^\pm_{,a}/A_a@f$: the slope of a
       * face relative to the reference surface. Zero if the thickness is
       * constant. */
      std::array<std::array<double, 2>, 2> face_slope;
    };

    std::array<Vertex, 4> vertices;

    /**
     * The constant weight of all integrals over the element,
     * @f$w=\bar\mu\,4l_1l_2@f$: the area of the middle surface, with
     * @f$\bar\mu = A_1A_2\bar\zeta_1\bar\zeta_2@f$ at the center of the
     * element.
     */
    double weight;
  };


  /**
   * Compute the geometry of the current cell of two FEValues objects of a
   * bilinear scalar element on a manifold-exact mapping.
   *
   * @param at_vertices FEValues with the quadrature QTrapezoid and the flags
   * update_quadrature_points, update_gradients.
   * @param at_center FEValues with the quadrature QMidpoint and the flags
   * update_quadrature_points, update_JxW_values.
   * @param surface the manifold of the cell, whose sides must be coordinate
   * lines.
   * @param faces the heights at the vertices, see Laminate::faces(), assumed
   * bilinear in the coordinates.
   */
  ElementGeometry
  compute_element_geometry(const dealii::FEValues<2, 3> &at_vertices,
                           const dealii::FEValues<2, 3> &at_center,
                           const ReferenceSurface       &surface,
                           const std::array<std::array<double, 2>, 4> &faces);
} // namespace Biface

#endif
