// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_element_element_geometry_h
#define biface_element_element_geometry_h

#include <deal.II/base/symmetric_tensor.h>
#include <deal.II/base/tensor.h>

#include <array>

#include <biface/element/interpolation.h>
#include <biface/element/mean_vectors.h>
#include <biface/element/strain.h>
#include <biface/element/strain_sampling.h>
#include <biface/element/thickness_strain.h>

namespace Biface
{
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
      /** @f$N_{q,a}/A_a@f$ for the shape function of this vertex; for its
       * neighbor along @f$\alpha_a@f$ it is the negative, the others vanish.
       * Unit: 1/length. */
      std::array<double, 2> slope;

      /** See SurfacePoint::connection(). Zero if vectors are interpolated. */
      std::array<dealii::Tensor<2, 3>, 2> connection;

      /** What turns the components of the neighbor along @f$\alpha_a@f$ into
       * those that are subtracted here: the unit tensor if components are
       * interpolated, those of the same vector in the frame of this vertex
       * if vectors are. */
      std::array<dealii::Tensor<2, 3>, 2> turn;

      ThicknessMetric metric;

      /** The thickness h at this vertex. */
      double thickness;

      /** `face_slope[face][a]` is @f$\delta^\pm_{,a}/A_a@f$: the slope of a
       * face relative to the reference surface. Zero if the thickness is
       * constant. */
      std::array<std::array<double, 2>, 2> face_slope;

      /** The frame @f$\mathbf e_1,\mathbf e_2,\mathbf e_3@f$ in columns: the
       * Cartesian vector of components in the frame. */
      dealii::Tensor<2, 3> axes;
    };

    std::array<Vertex, 4> vertices;

    /** What turns components at vertex @p s before the interpolation adds them
     * to components at vertex @p r, see Vertex::turn. */
    dealii::Tensor<2, 3>
    turn(const unsigned int r, const unsigned int s) const
    {
      return interpolation == Interpolation::components
               ? dealii::Tensor<2, 3>(dealii::unit_symmetric_tensor<3>())
               : transpose(vertices[r].axes) * vertices[s].axes;
    }

    /**
     * The constant weight of the element's strains and resultants,
     * @f$w=\bar\mu\,4l_1l_2@f$: the area of the middle surface, with
     * @f$\bar\mu = A_1A_2\bar\zeta_1\bar\zeta_2@f$ at the center of the
     * element.
     */
    double weight;

    StrainSampling sampling;
    Interpolation  interpolation;

    /** Vertices or mean director. */
    ThicknessStrain thickness_strain = ThicknessStrain::vertices;
    /** What MeanDirector needs: @f$\varphi_a@f$. */
    std::array<double, 2> director_factor;

    /** What StrainMeans needs: @f$\varphi_a@f$, */
    std::array<double, 2> mean_factor;
    /** `[face][a]`, the mean of @f$\zeta_a^\pm/\bar\zeta_a@f$, */
    std::array<std::array<double, 2>, 2> zeta_ratio;
    /** and StrainMeans::undeformed(). */
    MeanVectors undeformed;
  };
} // namespace Biface

#endif
