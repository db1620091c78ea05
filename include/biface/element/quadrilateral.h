// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_element_quadrilateral_h
#define biface_element_quadrilateral_h

#include <deal.II/base/tensor.h>

#include <array>

#include <biface/element/modes.h>

namespace Biface
{
  /**
   * The strain modes of a cell whose faces and directors are bilinear vectors:
   * a quadrilateral of any shape, flat or warped, with any thickness at its
   * vertices. It knows no chart; see Formulation::standard.
   *
   * Each face, of which the index is omitted, has the vectors
   * @f$\mathbf g_a=\frac14\sum_q\xi_{aq}\mathbf p_q@f$ and
   * @f$\mathbf c=\frac14\sum_q\xi_{1q}\xi_{2q}\mathbf p_q@f$ of the positions
   * of its vertices; the directors
   * @f$\mathbf d_q=(\mathbf p_q^+-\mathbf p_q^-)/h_q@f$ have the bilinear
   * coefficients @f$\mathbf d_0,\mathbf d_1,\mathbf d_2,\mathbf d_{12}@f$. With
   * the components @f$C^a@f$ of the undeformed @f$\mathbf c@f$ along the
   * undeformed @f$\mathbf g_a@f$, the warp is
   * @f$\tilde{\mathbf c}=\mathbf c-C^1\mathbf g_1-C^2\mathbf g_2@f$: it
   * vanishes in a flat cell, and remains zero in a homogeneous deformation.
   * Where the thickness varies, the tangents in the modes are
   * @f$\boldsymbol\gamma_a=\mathbf g_a-\sigma_a\mathbf d_0@f$ with the slope
   * @f$\sigma_a@f$ of the face, that is, at constant @f$\alpha_3@f$.
   *
   * The covariant modes are sums of scalar products of these vectors, less
   * their values in the undeformed cell, so that no rigid motion strains a
   * cell; see for_products(). They are those for which constant strains of any
   * cell are in equilibrium, linear curvatures have no shear, and a warped cell
   * whose sides keep their lengths has no membrane strain.
   *
   * The modes that the element works with are the physical components of the
   * strains, see Modes: the constant ones in the frame of the material, the
   * others along the tangents of the cell. The strains that vary along
   * @f$\xi_2@f$ are @f$\mathbf T_E\mathbf E@f$, where the columns of
   * @f$\mathbf T_E@f$ are @f$\mathbf t_1\mathbf t_1@f$ on each face, with
   * @f$\mathbf t_a=\mathbf g_a/|\mathbf g_a|@f$, the shear along
   * @f$\mathbf t_1@f$, the thickness strain, and the twist
   * @f$\pm\mathbf t_1\mathbf t_2@f$. Their resultants are contravariant,
   * @f$\mathbf T_H@f$ with @f$\mathbf g_1\mathbf g_1@f$ and so on, and
   * @f$\mathbf E=(\mathbf T_H^T\mathbf T_E)^{-1}@f$ times the covariant modes.
   * Where the tangents are orthogonal and one is the first direction of the
   * material, @f$\mathbf T_E@f$ selects components.
   */
  class Quadrilateral
  {
  public:
    /** What describes an undeformed cell, vertex by vertex in the order of
     * deal.II. */
    struct Shape
    {
      /** The positions on the reference surface. Unit: length. */
      std::array<dealii::Tensor<1, 3>, 4> positions;
      /** The unit normals, which are shared by the cells at a vertex. */
      std::array<dealii::Tensor<1, 3>, 4> normals;
      /** The heights @f$\delta^-,\delta^+@f$ of the faces. Unit: length. */
      std::array<std::array<double, 2>, 4> heights;
      /** The first direction of the material, which is projected into the
       * cell. */
      dealii::Tensor<1, 3> direction;
    };

    /** The vectors of a cell: the tangents @f$\boldsymbol\gamma_a@f$, the
     * @f$\mathbf c@f$ and the warp @f$\tilde{\mathbf c}@f$ of each face, and
     * the coefficients of the director. */
    static constexpr unsigned int n_vectors = 12;
    using Vectors = std::array<dealii::Tensor<1, 3>, n_vectors>;

    static constexpr unsigned int
    tangent(const unsigned int face, const unsigned int a)
    {
      return 2 * face + a;
    }

    static constexpr unsigned int
    hourglass(const unsigned int face)
    {
      return 4 + face;
    }

    static constexpr unsigned int
    warp(const unsigned int face)
    {
      return 6 + face;
    }

    /** The coefficient of @f$1,\xi_1,\xi_2,\xi_1\xi_2@f$ (i = 0 to 3). */
    static constexpr unsigned int
    director(const unsigned int i)
    {
      return 8 + i;
    }

    /** The nodal vectors of a cell: the means of the two faces at the four
     * vertices, then half their differences. */
    static constexpr unsigned int n_nodal = 8;
    using NodalVectors = std::array<dealii::Tensor<1, 3>, n_nodal>;

    /** A symmetric form of the vectors of a cell. */
    using Form = std::array<std::array<double, n_vectors>, n_vectors>;

    /** A symmetric form of the nodal vectors. */
    using NodalForm = std::array<std::array<double, n_nodal>, n_nodal>;

    /** What a cell has in addition to its shape. */
    struct Options
    {
      /** Whether the quadratic terms of the constant strains are means over the
       * cell, and the twist varies; otherwise they are sampled at the vertices,
       * and the twist is constant. */
      bool means = true;
      /** Whether the thickness strain is that of the interpolated director, not
       * of the directors at the vertices: contact pressure on a soft layer does
       * not make it rock from node to node. */
      bool mean_director = false;
      /** The thickness of the wall of which the cell may be a layer; 0 for the
       * cell's own. Unit: length. */
      double wall_thickness = 0;
      /** Whether cells that are warped and thin are softened: the strains
       * @f$\mathbf g_a\cdot\tilde{\mathbf c}@f$ get the stiffness
       * @f$1/(1+12C_n^2/h^2)@f$ with the height @f$C_n@f$ of the warp. */
      bool soft_warp = true;
    };

    Quadrilateral(const Shape &shape, const Options &options);

    /** The vectors of the undeformed cell. */
    const Vectors &
    undeformed() const
    {
      return reference;
    }

    /** The vectors that given nodal vectors make; linear. */
    Vectors
    vectors(const NodalVectors &nodal) const;

    /** The nodal vectors that are work-conjugate, if @p conjugate is to the
     * vectors: the transpose of vectors(). */
    NodalVectors
    conjugate_at_nodes(const Vectors &conjugate) const;

    /** The symmetric bilinear form of the covariant modes: those of vectors x
     * are @f$\frac12@f$ of their products with themselves. */
    Modes::Vector
    products(const Vectors &x, const Vectors &y) const;

    /** The physical modes of covariant ones. */
    Modes::Vector
    physical(const Modes::Vector &covariant) const;

    /** The resultants that are work-conjugate to covariant modes, if @p H is to
     * the physical ones: the transpose of physical(). */
    Modes::Vector
    covariant_resultants(const Modes::Vector &H) const;

    /** The physical strains of the products of each warp with itself in the
     * constant modes, see MixedElement::hourglass_strain(). */
    Modes::Vector
    hourglass_strain(const Vectors &change) const;

    /** The second variation of the covariant modes, weighted by resultants.
     * @param H work-conjugate to the covariant modes. */
    Form
    form(const Modes::Vector &H) const;

    static Vectors
    apply(const Form &form, const Vectors &x);

    NodalForm
    at_nodes(const Form &form) const;

    /** The rows of the variation of the physical modes at vectors @p x, by the
     * Cartesian components of the nodal vectors: column 8 i + r for component i
     * of nodal vector r. */
    using Rows = std::array<std::array<double, 3 * n_nodal>, Modes::n>;
    void
    variation(const Vectors &x, Rows &rows) const;

    /** The area of the middle surface by its tangents at the center, the weight
     * of the element. Unit: length^2. */
    double
    area() const
    {
      return weight;
    }

    /** The factors of the squares of the coefficients 1, 2 and 12 of the
     * director in the constant thickness strain. */
    std::array<double, 3>
    thickness_strain_of_tilt() const
    {
      return {{of_directors[0][1], of_directors[0][2], of_directors[0][3]}};
    }

    /** The axes of the material in the rows, and the normal of the cell. */
    const dealii::Tensor<2, 3> &
    material_frame() const
    {
      return frame;
    }

    /** The components of the tangents along the axes of the material, which
     * make @f$\mathbf T_E@f$. */
    const CellTangents &
    get_tangents() const
    {
      return tangents;
    }

  private:
    /** Call a function with each product of two vectors in a covariant mode:
     * the mode, the vectors, and the factor. */
    template <typename Function>
    void
    for_products(const Function &function) const;

    /** Call a function with each block of the matrix that turns covariant modes
     * into physical ones: the modes of the block, and its entries. Other modes
     * are the same. */
    template <typename Function>
    void
    for_blocks(const Function &function) const;

    /** The factors of the nodal vectors in each vector. */
    std::array<std::array<double, n_nodal>, n_vectors> factors;

    Vectors reference;

    /** The components of c along the tangents, `components[face][a]`. */
    std::array<std::array<double, 2>, 2> components;
    /** The factors of the squares of the warp, `[face][a]`, and those by which
     * the shear sees the warp, `[a]`. */
    std::array<std::array<double, 2>, 2> of_warp;
    std::array<double, 2>                shear_of_warp;
    /** The factors of the products of directors, by the groups of Modes. */
    std::array<std::array<double, 10>, 4> of_directors;

    double               weight;
    dealii::Tensor<2, 3> frame;
    CellTangents         tangents;

    /** The physical modes: tangential strains of a face and shear strains in
     * the constant group, and tangential strains of the faces with the twist,
     * and the shear, in the two others. */
    std::array<dealii::Tensor<2, 3>, 2> constant_tangential;
    dealii::Tensor<2, 2>                constant_shear;
    std::array<dealii::Tensor<2, 3>, 2> varying_tangential;
    std::array<double, 2>               varying_shear;
  };
} // namespace Biface

#endif
