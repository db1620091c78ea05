// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_element_mixed_element_h
#define biface_element_mixed_element_h

#include <deal.II/base/tensor.h>

#include <array>

#include <biface/element/modes.h>
#include <biface/element/normal_thickness.h>
#include <biface/element/quadrilateral.h>
#include <biface/element/shell_fe_values.h>
#include <biface/element/strain.h>

namespace Biface
{
  /**
   * The mixed shell element of @cite GrigolyukKulikovPlotnikova2004,
   * eqs. (11)-(13) and (16), at given nodal displacements.
   *
   * The displacements of the two faces are bilinear; strains and resultants
   * have the modes of Modes. Unless the formulation is
   * Formulation::paper, the displacement vectors are bilinear, and the strains
   * are those of a Quadrilateral. With Formulation::paper it is their
   * components in the frames of the nodes, and strains are sampled at the
   * vertices. With
   * @f$\mathbf E(\mathbf V)@f$ the modes of the strains, @f$w@f$ the weight of
   * the element and @f$w_m@f$ those of the modes, the virtual work of
   * resultants @f$\mathbf H@f$ and initial resultants @f$\mathbf H_0@f$ is
   * @f[
   *   w\sum_m w_m\,\bigl(H_m\,\delta E_m + H_{0,m}\,\delta\eta_m\bigr),
   * @f]
   * with @f$\eta@f$ the nonlinear part of the strains.
   *
   * In a wall of several layers NormalThickness changes the thickness strain.
   */
  class MixedElement
  {
  public:
    static constexpr unsigned int n_dofs = 24;

    /**
     * The two unknowns per component at a node: the mean of the displacements
     * of the faces, @f$\bar v=\frac12(v^-+v^+)@f$, and half their difference,
     * @f$\tilde v=\frac12(v^+-v^-)@f$, so that @f$v^\pm=\bar
     * v\pm\tilde v@f$.
     *
     * In the displacements of the faces themselves, the stiffness
     * @f$E/h@f$ against a change of thickness would be added to that against
     * bending, @f$Eh^3@f$, which is lost in round-off if the shell is thin
     * @cite WallGeeRamm2000.
     */
    enum Part : unsigned int
    {
      mean,
      half_difference
    };

    /** Index of a nodal unknown: vertex by vertex, in the order @f$\bar
     * v_1,\tilde v_1,\bar v_2,\tilde v_2,\bar v_3,\tilde v_3@f$. */
    static constexpr unsigned int
    dof(const unsigned int vertex,
        const unsigned int component,
        const Part         part)
    {
      return 6 * vertex + 2 * component + part;
    }

    /** The sign of a face, @f$\partial v^\mp/\partial\tilde v@f$. */
    static constexpr std::array<double, 2> face_sign{{-1, 1}};

    /** The unknowns of the nodes, vertex by vertex, see dof(). Forces are
     * conjugate to them: @f$\bar f=f^-+f^+@f$ and @f$\tilde f=f^+-f^-@f$. */
    using NodalVector = dealii::Tensor<1, n_dofs>;

    /** A matrix for the unknowns of the nodes, `K[i][j]`, row by row. */
    using NodalMatrix = std::array<std::array<double, n_dofs>, n_dofs>;

    /** The displacement of a face at a vertex. */
    static dealii::Tensor<1, 3>
    face_displacement(const NodalVector &V,
                      const unsigned int vertex,
                      const unsigned int face)
    {
      dealii::Tensor<1, 3> v;
      for (unsigned int i = 0; i < 3; ++i)
        v[i] = V[dof(vertex, i, mean)] +
               face_sign[face] * V[dof(vertex, i, half_difference)];
      return v;
    }

    /** The force on a face at a vertex. */
    static dealii::Tensor<1, 3>
    face_force(const NodalVector &forces,
               const unsigned int vertex,
               const unsigned int face)
    {
      return face_displacement(forces, vertex, face) / 2;
    }

    /** Add a force at a vertex, where the derivative of the displacement by
     * the half difference is @p sign: see face_sign. */
    static void
    add_force(const dealii::Tensor<1, 3> &force,
              const unsigned int          vertex,
              const double                sign,
              NodalVector                &forces)
    {
      for (unsigned int i = 0; i < 3; ++i)
        {
          forces[dof(vertex, i, mean)] += force[i];
          forces[dof(vertex, i, half_difference)] += sign * force[i];
        }
    }

    /** Add a force on a face at a vertex. */
    static void
    add_face_force(const dealii::Tensor<1, 3> &force,
                   const unsigned int          vertex,
                   const unsigned int          face,
                   NodalVector                &forces)
    {
      add_force(force, vertex, face_sign[face], forces);
    }

    /** Add the derivative of a force at vertex @p r by the displacement at
     * vertex @p s, see add_force(). */
    static void
    add_stiffness(const dealii::Tensor<2, 3> &stiffness,
                  const unsigned int          r,
                  const double                sign_r,
                  const unsigned int          s,
                  const double                sign_s,
                  NodalMatrix                &K)
    {
      for (unsigned int i = 0; i < 3; ++i)
        for (unsigned int j = 0; j < 3; ++j)
          {
            const double k = stiffness[i][j];
            K[dof(r, i, mean)][dof(s, j, mean)] += k;
            K[dof(r, i, mean)][dof(s, j, half_difference)] += sign_s * k;
            K[dof(r, i, half_difference)][dof(s, j, mean)] += sign_r * k;
            K[dof(r, i, half_difference)][dof(s, j, half_difference)] +=
              sign_r * sign_s * k;
          }
    }

    /** The element keeps a reference to @p geometry. */
    MixedElement(const ElementGeometry &geometry, const NodalVector &V);

    /** The element halfway between given displacements, with the derivative of
     * the strains whose product with the change of the displacements is the
     * change of the strains, which are quadratic in the displacements or, with
     * NormalThickness, contain products of such strains.
     * strain() is not that of the displacements halfway. */
    MixedElement(const ElementGeometry &geometry,
                 const NodalVector     &start,
                 const NodalVector     &end);

    /** The strain modes, @f$\mathbf E(\mathbf V)@f$. */
    Modes::Vector
    strain() const;

    /** The derivative of the strain modes in the direction @p dV,
     * @f$\mathbf B(\mathbf V)\,d\mathbf V@f$. */
    Modes::Vector
    strain_variation(const NodalVector &dV) const;

    /** The strain modes of the nonlinear part, @f$\boldsymbol\eta(\mathbf
     * V)@f$. */
    Modes::Vector
    nonlinear_strain() const;

    /**
     * The hourglass part of @f$\boldsymbol\eta(d\mathbf V)@f$, which
     * strain_variation() leaves out. The derivative @f$\mathbf g_a@f$ of an
     * increment varies as @f$[\mathbf g_a]_c\,\xi_c@f$, @f$c\neq a@f$, and
     * except with Formulation::standard the constant modes of
     * @f$\varepsilon_{aa}^\pm@f$ contain the mean of
     * @f$|[\mathbf g_a^\pm]_c|^2/2\zeta_a^2@f$ over the vertices. All other
     * modes are zero.
     */
    Modes::Vector
    hourglass_strain(const NodalVector &dV) const;

    /** The internal force: the derivative of the virtual work of the resultants
     * with respect to the nodal displacements. */
    NodalVector
    internal_force(const Modes::Vector &resultants,
                   const Modes::Vector &H_0) const;

    /**
     * Add the tangent @f$\mathbf B^T\mathbf D\mathbf B + \mathbf G[\mathbf
     * H]@f$.
     *
     * @param stiffness the constitutive law.
     * @param resultants all that do work on the second variation of the
     * strains, including initial ones.
     * @param K what it is added to.
     * @param added the stiffness of plies that are not linear; null for none.
     */
    void
    add_tangent(const ModeStiffness &stiffness,
                const Modes::Vector &resultants,
                NodalMatrix         &K,
                const Modes::Matrix *added = nullptr) const;

    /**
     * The product of the tangent of add_tangent() and @p dV, computed from
     * strains and resultants: for a thin shell, a product with the matrix has
     * fewer digits, since it adds up forces that nearly cancel.
     */
    NodalVector
    tangent_product(const ModeStiffness &stiffness,
                    const Modes::Vector &resultants,
                    const NodalVector   &dV) const;

  private:
    const ElementGeometry              &geometry;
    std::array<DisplacementGradient, 4> gradients;

    /** The vectors of the deformed cell, and their change from the undeformed
     * one; not used with Formulation::paper. */
    Quadrilateral::Vectors cell, cell_change;

    /** The shear strains at the Gauss points; used with
     * NormalThickness. */
    NormalThickness::Shear shear{};

    /** Whether the strains are those of a Quadrilateral. */
    bool
    of_vectors() const
    {
      return geometry.quadrilateral != nullptr;
    }

    /** The tangents of the cell; null if they are the axes of the material. */
    const CellTangents *
    tangents() const
    {
      return geometry.tangents();
    }

    bool
    with_normal_thickness() const
    {
      return geometry.normal_thickness;
    }

    /** The strain modes before NormalThickness changes them. */
    Modes::Vector
    strain_of_directors() const;

    /** A row for each strain mode. The columns are sorted part by part, those
     * of a part vertex by vertex. */
    using StrainMatrix = std::array<std::array<double, n_dofs>, Modes::n>;

    /** The vectors that nodal displacements make in the cell, and the nodal
     * forces that are work-conjugate to vectors. */
    Quadrilateral::Vectors
    vectors_of(const NodalVector &V) const;
    NodalVector
    forces_of(const Quadrilateral::Vectors &conjugate) const;

    /** The second variation of the strains of a Quadrilateral, weighted by
     * resultants.
     * @param H with the weight of the element, without those of modes. */
    Quadrilateral::Form
    second_variation(const Modes::Vector &H) const;

    /** Compute @f$\mathbf B = d\mathbf E/d\mathbf V@f$ of a Quadrilateral. */
    void
    strain_matrix_of_vectors(StrainMatrix &B) const;

    /** Compute @f$\mathbf B = d\mathbf E/d\mathbf V@f$ for strains that are
     * sampled at the vertices. */
    void
    strain_matrix(StrainMatrix &B) const;

    /** The variation of NormalThickness::Shear, in the columns of
     * StrainMatrix. */
    using ShearMatrix = std::array<std::array<std::array<double, n_dofs>, 2>,
                                   Modes::n_gauss_points>;

    void
    shear_matrix(const StrainMatrix &B, ShearMatrix &G) const;

    /** Subtract the terms of NormalThickness from the rows of the thickness
     * strain. */
    void
    subtract_shear(const ShearMatrix &G, StrainMatrix &B) const;

    /** Subtract the second variation of the products of NormalThickness,
     * weighted by resultants, from the rows of the shear strains. */
    void
    subtract_second_variation(const ShearMatrix   &G,
                              const Modes::Vector &H,
                              StrainMatrix        &DB) const;
  };


  /** The derivatives of the displacements at a vertex of an element with the
   * given nodal displacements. */
  DisplacementGradient
  displacement_gradient(const ElementGeometry           &geometry,
                        const MixedElement::NodalVector &V,
                        const unsigned int               vertex);
} // namespace Biface

#endif
