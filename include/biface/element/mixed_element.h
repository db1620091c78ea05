// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_element_mixed_element_h
#define biface_element_mixed_element_h

#include <deal.II/base/tensor.h>

#include <array>

#include <biface/element/modes.h>
#include <biface/element/shell_fe_values.h>
#include <biface/element/strain.h>

namespace Biface
{
  /**
   * The mixed shell element of @cite GrigolyukKulikovPlotnikova2004,
   * eqs. (11)-(13) and (16), at given nodal displacements.
   *
   * The displacements of the two faces are bilinear, with components in the
   * frame of each node; strains and resultants have the modes of Modes. With
   * @f$\mathbf E(\mathbf V)@f$ the modes of the strains, @f$w@f$ the weight of
   * the element and @f$w_m@f$ those of the modes, the virtual work of
   * resultants @f$\mathbf H@f$ and initial resultants @f$\mathbf H_0@f$ is
   * @f[
   *   w\sum_m w_m\,\bigl(H_m\,\delta E_m + H_{0,m}\,\delta\eta_m\bigr),
   * @f]
   * with @f$\eta@f$ the nonlinear part of the strains.
   */
  class MixedElement
  {
  public:
    static constexpr unsigned int n_dofs = 24;

    /** Index of a nodal displacement: vertex by vertex, in the order
     * @f$v_1^-,v_1^+,v_2^-,v_2^+,v_3^-,v_3^+@f$. */
    static constexpr unsigned int
    dof(const unsigned int vertex,
        const unsigned int component,
        const unsigned int face)
    {
      return 6 * vertex + 2 * component + face;
    }

    /** @f$h\,\partial\beta/\partial v^\mp@f$: the contribution of each face to
     * the change of the director. */
    static constexpr std::array<double, 2> beta_sign{{-1, 1}};

    using NodalVector = dealii::Tensor<1, n_dofs>;

    /** `K[i][j]`, row by row. */
    using NodalMatrix = std::array<std::array<double, n_dofs>, n_dofs>;

    /** The element keeps a reference to @p geometry. */
    MixedElement(const ElementGeometry &geometry, const NodalVector &V);

    /** The modes of the strains, @f$\mathbf E(\mathbf V)@f$. */
    Modes::Vector
    strain() const;

    /** Their derivative in the direction @p dV,
     * @f$\mathbf B(\mathbf V)\,d\mathbf V@f$. */
    Modes::Vector
    strain_variation(const NodalVector &dV) const;

    /** The modes of the nonlinear part of the strains,
     * @f$\boldsymbol\eta(\mathbf V)@f$. */
    Modes::Vector
    nonlinear_strain() const;

    /** The internal force: the derivative of the virtual work above with
     * respect to the nodal displacements. */
    NodalVector
    internal_force(const Modes::Vector &H, const Modes::Vector &H_0) const;

    /**
     * Add the tangent @f$\mathbf B^T\mathbf D\mathbf B + \mathbf G[\mathbf
     * H]@f$.
     *
     * @param stiffness the constitutive law.
     * @param H all resultants that do work on the second variation of the
     * strains, including initial ones.
     * @param K what it is added to.
     */
    void
    add_tangent(const ModeStiffness &stiffness,
                const Modes::Vector &H,
                NodalMatrix         &K) const;

  private:
    const ElementGeometry              &geometry;
    std::array<DisplacementGradient, 4> gradients;

    using StrainMatrix = std::array<std::array<double, n_dofs>, Modes::n>;

    /** @f$\mathbf B = d\mathbf E/d\mathbf V@f$ */
    void
    strain_matrix(StrainMatrix &B) const;

    void
    add_geometric_stiffness(const Modes::Vector &H, NodalMatrix &K) const;
  };


  /** The derivatives of the displacements at a vertex of an element with the
   * given nodal displacements. */
  DisplacementGradient
  displacement_gradient(const ElementGeometry           &geometry,
                        const MixedElement::NodalVector &V,
                        const unsigned int               vertex);
} // namespace Biface

#endif
