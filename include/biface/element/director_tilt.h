// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_element_director_tilt_h
#define biface_element_director_tilt_h

#include <deal.II/base/tensor.h>

#include <array>

#include <biface/element/mixed_element.h>

namespace Biface
{
  struct ElementGeometry;


  /**
   * How much the directors of an element differ from their mean
   * @f$\mathbf d_0@f$, as the thickness strain sees it:
   * @f[
   *   T = A\,\bigl(t-\mathring t\bigr),\qquad
   *   t = \frac{\sum_k c_k\,|\mathbf d_k|^2}
   *            {|\mathbf d_0|^2+\sum_k|\mathbf d_k|^2},
   * @f]
   * with the coefficients @f$\mathbf d_1,\mathbf d_2,\mathbf d_{12}@f$ of
   * Quadrilateral, the undeformed area A, and the factors of
   * their squares in the thickness strain, @f$c_k=\frac12@f$ in thin cells. The
   * denominator is the mean of @f$|\mathbf d|^2@f$ at the vertices. Rigid
   * motions and a change of the thickness do not change T.
   *
   * A wall whose directors tilt in turn by @f$\pm\theta@f$ keeps its thickness
   * at the vertices, but its mean director, and with it the distance of the
   * faces between them, gets shorter by the factor @f$1-\theta^2/2@f$; see
   * PressedDirectors.
   */
  class DirectorTilt
  {
  public:
    /** @param geometry with Formulation::standard; kept by reference. */
    explicit DirectorTilt(const ElementGeometry &geometry);

    /** T. Unit: area.
     * @param V the nodal displacements, see MixedElement::dof(). */
    double
    value(const MixedElement::NodalVector &V) const;

    /** Add the derivative of T by the nodal displacements, times a factor. */
    void
    add_gradient(const double                     factor,
                 const MixedElement::NodalVector &V,
                 MixedElement::NodalVector       &gradient) const;

    /** Add the mean of the derivative between two states, times a factor: its
     * product with the displacement from one to the other is the change of T,
     * and it is that of the mean of both directors but for the square of the
     * displacement. */
    void
    add_mean_gradient(const double                     factor,
                      const MixedElement::NodalVector &start,
                      const MixedElement::NodalVector &end,
                      MixedElement::NodalVector       &gradient) const;

    /** Add the second derivative of T, times a factor. */
    void
    add_second_derivative(const double                     factor,
                          const MixedElement::NodalVector &V,
                          MixedElement::NodalMatrix       &K) const;

  private:
    /** The mean of the directors and the other coefficients. */
    static constexpr unsigned int n = 4;

    using Vectors = std::array<dealii::Tensor<1, 3>, n>;

    /** The factor of the half difference of the faces at a vertex in a
     * coefficient of the director. */
    double
    factor_of(const unsigned int k, const unsigned int vertex) const;

    /** What V adds to the coefficients. */
    Vectors
    changes(const MixedElement::NodalVector &V) const;

    const ElementGeometry &geometry;
    Vectors                undeformed;
    /** @f$c_k@f$, zero for the mean. */
    std::array<double, n> weights{};
  };
} // namespace Biface

#endif
