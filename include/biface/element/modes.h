// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_element_modes_h
#define biface_element_modes_h

#include <deal.II/base/tensor.h>

#include <array>

#include <biface/element/formulation.h>
#include <biface/laminate/resultants.h>

namespace Biface
{
  /**
   * The "double approximation" of strains and resultants,
   * @cite GrigolyukKulikovPlotnikova2004, eqs. (10)-(13).
   *
   * Each strain is evaluated at the four vertices of the element and
   * interpolated bilinearly in the reference coordinates
   * @f$\xi_1,\xi_2\in[-1,1]@f$. Of the coefficients of @f$1@f$,
   * @f$\xi_2@f$, @f$\xi_1@f$, @f$\xi_1\xi_2@f$ only those are kept that do not
   * cause locking: 22 numbers per element, in four groups.
   *
   * Formulation::standard adds two, the twist as coefficient of
   * @f$\xi_2@f$ and of @f$\xi_1@f$; see Quadrilateral.
   */
  namespace Modes
  {
    constexpr unsigned int n = 24;

    /** The index of the twist among the strains, after those of Resultants: a
     * strain @f$2\varepsilon_{12}^\pm=\pm t@f$ of opposite sign on the two
     * faces. The resultant is @f$H_t=(H_{12}^+-H_{12}^-)/2@f$. */
    constexpr unsigned int twist = Resultants::n;

    /** The strains that are kept as coefficients of one bilinear function. */
    struct Group
    {
      /** Whether the function contains @f$\xi_1@f$ and @f$\xi_2@f$. */
      std::array<bool, 2> varies;
      unsigned int        first_mode;
      /** The number of strains taken from the vertices, which come first. */
      unsigned int sampled;
      /** The number of all strains of the group. */
      unsigned int size;
      /** The indices of the strains, see Resultants. */
      std::array<unsigned int, Resultants::n> strains;

      /** The mean square of the function over the element. */
      constexpr double
      weight() const
      {
        return (varies[0] ? 1. / 3 : 1.) * (varies[1] ? 1. / 3 : 1.);
      }

      /** The weight of the @p i-th strain: that of the function, where the
       * twist counts for both faces. */
      constexpr double
      weight(const unsigned int i) const
      {
        return (strains[i] == twist ? 2 : 1) * weight();
      }

      /** The value of the function at a vertex, ±1; vertices are numbered
       * lexicographically. */
      constexpr double
      value_at_vertex(const unsigned int vertex) const
      {
        return (varies[0] && (vertex & 1) == 0 ? -1. : 1.) *
               (varies[1] && (vertex & 2) == 0 ? -1. : 1.);
      }
    };

    constexpr std::array<Group, 4> groups{
      {{{{false, false}}, 0, 11, 11, {{0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10}}},
       {{{false, true}}, 11, 5, 6, {{0, 1, 6, 7, 10, twist}}},
       {{{true, false}}, 17, 5, 6, {{2, 3, 8, 9, 10, twist}}},
       {{{true, true}}, 23, 1, 1, {{10}}}}};

    /** The number of the strain mode, `mode_of[group][strain]`, or n if the
     * group does not contain this strain. */
    constexpr std::array<std::array<unsigned int, twist + 1>, 4> mode_of = [] {
      std::array<std::array<unsigned int, twist + 1>, 4> table{};
      for (unsigned int m = 0; m < 4; ++m)
        {
          for (unsigned int s = 0; s <= twist; ++s)
            table[m][s] = n;
          for (unsigned int i = 0; i < groups[m].size; ++i)
            table[m][groups[m].strains[i]] = groups[m].first_mode + i;
        }
      return table;
    }();

    using Vector = dealii::Tensor<1, n>;

    /** `K[i][j]`, row by row. */
    using Matrix = std::array<std::array<double, n>, n>;

    /** The number of the points @f$\xi_1,\xi_2=\pm1/\sqrt3@f$ of the element,
     * numbered like the vertices next to them. With the weight 1/4 each they
     * integrate products of modes exactly. */
    constexpr unsigned int n_gauss_points = 4;

    /** The value of the function of a group at a Gauss point. */
    constexpr double
    value_at_gauss_point(const Group &group, const unsigned int g)
    {
      constexpr double xi = 0.57735026918962576451; // 1/sqrt(3)
      return group.value_at_vertex(g) * (group.varies[0] ? xi : 1.) *
             (group.varies[1] ? xi : 1.);
    }

    /** The strains or resultants along the axes of the laminate by the strains
     * of a group, those with the twist. */
    using Components = std::array<Resultants::Vector, twist + 1>;

    /** The components of the groups that vary along @f$\xi_2@f$ and along
     * @f$\xi_1@f$, where the tangents of the cell are not the axes of the
     * laminate, see CellTangents::strains(). */
    using ComponentsOfGroups = std::array<Components, 2>;

    /** Call a function with each mode, the strain at a Gauss point that it is a
     * part of, and its factor there. The twist is a part of two strains, and
     * along tangents that are not the axes, others are parts of several.
     * @param with_twist whether the twist is a mode.
     * @param along null where the tangents are the axes. */
    template <typename Function>
    void
    for_parts_at_gauss_point(const unsigned int        g,
                             const bool                with_twist,
                             const ComponentsOfGroups *along,
                             const Function           &function)
    {
      for (unsigned int m = 0; m < groups.size(); ++m)
        {
          const Group       &group = groups[m];
          const double       value = value_at_gauss_point(group, g);
          const unsigned int first = group.first_mode;
          if (along && (m == 1 || m == 2))
            {
              const unsigned int n = (with_twist ? group.size : group.sampled);
              for (unsigned int i = 0; i < n; ++i)
                {
                  const auto &components = (*along)[m - 1][group.strains[i]];
                  for (unsigned int s = 0; s < Resultants::n; ++s)
                    if (components[s] != 0)
                      function(first + i, s, value * components[s]);
                }
              continue;
            }
          for (unsigned int i = 0; i < group.sampled; ++i)
            function(first + i, group.strains[i], value);
          if (with_twist && group.size > group.sampled)
            for (unsigned int face = 0; face < 2; ++face)
              function(first + group.sampled,
                       Resultants::tangential(2, face),
                       face == Resultants::inner ? -value : value);
        }
    }

    /** The strains at a Gauss point. */
    inline Resultants::Vector
    at_gauss_point(const Vector             &modes,
                   const unsigned int        g,
                   const ComponentsOfGroups *along = nullptr)
    {
      Resultants::Vector strains;
      for_parts_at_gauss_point(
        g,
        true,
        along,
        [&](const unsigned int m, const unsigned int s, const double value) {
          strains[s] += value * modes[m];
        });
      return strains;
    }

    /** The modes of resultants given at the Gauss points: those for which
     * @f$\sum_m w_m H_m E_m@f$ is the mean of the products with
     * at_gauss_point().
     * @param with_twist whether the twist is a mode. */
    inline Vector
    from_gauss_points(
      const std::array<Resultants::Vector, n_gauss_points> &at_points,
      const bool                                            with_twist,
      const ComponentsOfGroups                             *along = nullptr)
    {
      Vector modes;
      for (unsigned int g = 0; g < n_gauss_points; ++g)
        for_parts_at_gauss_point(
          g,
          with_twist,
          along,
          [&](const unsigned int m, const unsigned int s, const double value) {
            modes[m] += value * at_points[g][s];
          });
      for (const Group &group : groups)
        for (unsigned int i = 0; i < group.size; ++i)
          modes[group.first_mode + i] /= n_gauss_points * group.weight(i);
      return modes;
    }

    /** The strain modes for strains given at the vertices, without the
     * twist. */
    inline Vector
    from_vertices(const std::array<Resultants::Vector, 4> &at_vertices)
    {
      Vector modes;
      for (const Group &group : groups)
        for (unsigned int i = 0; i < group.sampled; ++i)
          for (unsigned int v = 0; v < 4; ++v)
            modes[group.first_mode + i] +=
              group.value_at_vertex(v) * at_vertices[v][group.strains[i]] / 4;
      return modes;
    }

    /** The values of the kept modes at the vertices. */
    inline std::array<Resultants::Vector, 4>
    at_vertices(const Vector &modes)
    {
      std::array<Resultants::Vector, 4> values;
      for (const Group &group : groups)
        for (unsigned int v = 0; v < 4; ++v)
          {
            for (unsigned int i = 0; i < group.sampled; ++i)
              values[v][group.strains[i]] +=
                group.value_at_vertex(v) * modes[group.first_mode + i];
            for (unsigned int i = group.sampled; i < group.size; ++i)
              {
                const double value =
                  group.value_at_vertex(v) * modes[group.first_mode + i];
                values[v][Resultants::tangential(2, Resultants::inner)] -=
                  value;
                values[v][Resultants::tangential(2, Resultants::outer)] +=
                  value;
              }
          }
      return values;
    }

    /** The values at the vertices where the tangents of the cell are not the
     * axes of the laminate. */
    std::array<Resultants::Vector, 4>
    at_vertices(const Vector &modes, const ComponentsOfGroups &along);

    /**
     * The transpose of from_vertices() with the weights of the groups: the
     * resultants @f$\mathbf h_v@f$ at the vertices for which
     * @f$\sum_m w_m H_m\,\delta E_m = \sum_v\mathbf
     * h_v\cdot\delta\boldsymbol\varepsilon_v@f$, without the twist.
     */
    inline std::array<Resultants::Vector, 4>
    to_vertices(const Vector &resultants)
    {
      std::array<Resultants::Vector, 4> at_vertices;
      for (const Group &group : groups)
        for (unsigned int i = 0; i < group.sampled; ++i)
          for (unsigned int v = 0; v < 4; ++v)
            at_vertices[v][group.strains[i]] +=
              group.weight() * group.value_at_vertex(v) *
              resultants[group.first_mode + i] / 4;
      return at_vertices;
    }

    /** The modes of a quantity that is constant over the element. */
    inline Vector
    constant(const Resultants::Vector &value)
    {
      Vector modes;
      for (unsigned int s = 0; s < Resultants::n; ++s)
        modes[s] = value[s];
      return modes;
    }

    /** The sum over the modes of @f$w_m\,a_m b_m@f$: the mean over the element
     * of the scalar product of two interpolated quantities. */
    inline double
    mean_product(const Vector &a, const Vector &b)
    {
      double sum = 0;
      for (const Group &group : groups)
        for (unsigned int i = 0; i < group.size; ++i)
          sum +=
            group.weight(i) * a[group.first_mode + i] * b[group.first_mode + i];
      return sum;
    }
  } // namespace Modes


  /** The tangents of a cell along the axes of the laminate, unit vectors, along
   * which the strains that vary are components, see Quadrilateral. */
  struct CellTangents
  {
    /** The tangents of the faces, `faces[face][a]`, and of the middle surface.
     */
    std::array<std::array<dealii::Tensor<1, 2>, 2>, 2> faces;
    std::array<dealii::Tensor<1, 2>, 2>                middle;

    /** Whether they are the axes of the laminate, up to the square of the
     * small angle by which a cell between lines of curvature is a trapezoid. */
    bool
    are_axes() const;

    /** The strains along the axes for unit strains of the group that varies
     * along @f$\xi_2@f$ (@p a = 0) or @f$\xi_1@f$ (1): the columns of
     * @f$\mathbf T_E@f$. */
    Modes::Components
    strains(const unsigned int a) const;

    /** The strains of both groups. */
    Modes::ComponentsOfGroups
    strains() const
    {
      return {{strains(0), strains(1)}};
    }

    /** The resultants along the axes for unit resultants of the group, which do
     * the same work: @f$\mathbf T_H(\mathbf T_E^T\mathbf T_H)^{-1}@f$. */
    Modes::Components
    resultants(const unsigned int a) const;

    /** A basis of all strains: strains(), of which the twist is the difference
     * of the shear strains of the outer and the inner face, and those that the
     * group lacks and on which its resultants do no work. With the dual
     * vectors @f$\mathbf t^a@f$ these are
     * @f$\mathbf t^b\mathbf t^b@f$ (b not a) on each face, and
     * @f$\mathbf t^1\mathbf t^2@f$ on both. */
    std::array<Resultants::Vector, Resultants::n>
    basis(const unsigned int a) const;

    /** The matrix of a laminate between the strains of basis() and the
     * resultants that do work on them. */
    Resultants::Matrix
    in_basis(const Resultants::Matrix &stiffness, const unsigned int a) const;

    /** The values at the vertices, along the axes, of strains and of
     * resultants. */
    std::array<Resultants::Vector, 4>
    strains_at_vertices(const Modes::Vector &E) const;
    std::array<Resultants::Vector, 4>
    resultants_at_vertices(const Modes::Vector &H) const;
  };


  /**
   * The constitutive law between modes,
   * @f$\mathbf H^m = \mathbf D^m\mathbf E^m@f$ for each group m, where
   * @f$\mathbf D^m@f$ is the part of the laminate's matrix that belongs to the
   * strains of the group.
   */
  class ModeStiffness
  {
  public:
    /** The law of a laminate with the given matrix.
     * @param formulation the set of strain modes.
     * @param tangents of the cell, along which the strains that vary are
     * components, @f$\mathbf D^m=\mathbf T_E^T\mathbf D\mathbf T_E@f$, see
     * Quadrilateral; null if they are the axes of the laminate. */
    explicit ModeStiffness(
      const Resultants::Matrix &stiffness,
      const Formulation         formulation = Formulation::standard,
      const CellTangents       *tangents    = nullptr);

    /**
     * Let the tangential strains that a group lacks follow its thickness
     * strain, by @f$\mathbf y@f$ for a unit one, such that they have no
     * resultants: @f$\mathbf D_{ff}\mathbf y = \mathbf D_{f3}@f$ with the
     * missing strains f and, for all strains s,
     * @f[
     *   D^m_{s3} = D^m_{3s} = D_{s3} - \mathbf D_{sf}\mathbf y.
     * @f]
     * Otherwise a thickness strain that varies changes the volume, and the
     * nearly incompressible layers of a stack lock, since its bending
     * stretches each of them. Where the thickness strain has no resultant, the
     * law between the others remains the same: with s, t other than 3
     * @f[
     *   D^m_{st} - \frac{D^m_{s3}D^m_{3t}}{D^m_{33}} =
     *   D_{st} - \frac{D_{s3}D_{3t}}{D_{33}} .
     * @f]
     *
     * @param softest the matrix where all cords are slack, so that the law is
     * positive definite for any of them.
     * @param tangents those of the constructor; the strains f are the ones
     * that CellTangents::basis() adds.
     */
    void
    release_thickness_strain(const Resultants::Matrix &softest,
                             const CellTangents       *tangents = nullptr);

    /** The number of strains in a group. */
    unsigned int
    size(const Modes::Group &group) const
    {
      return with_twist ? group.size : group.sampled;
    }

    /** The resultants of given strains. */
    Modes::Vector
    resultants(const Modes::Vector &strain) const
    {
      Modes::Vector H;
      for (unsigned int m = 0; m < Modes::groups.size(); ++m)
        {
          const Modes::Group &group = Modes::groups[m];
          for (unsigned int i = 0; i < size(group); ++i)
            for (unsigned int j = 0; j < size(group); ++j)
              H[group.first_mode + i] +=
                (*this)(m, i, j) * strain[group.first_mode + j];
        }
      return H;
    }

    /** The entry of @f$\mathbf D^m@f$ for the @p i-th and @p j-th strain of
     * group @p m. */
    double
    operator()(const unsigned int m,
               const unsigned int i,
               const unsigned int j) const
    {
      const Modes::Group &group = Modes::groups[m];
      return D[m][group.strains[i]][group.strains[j]];
    }

  private:
    /** The matrices @f$\mathbf D^m@f$ of the groups. */
    std::array<dealii::Tensor<2, Modes::twist + 1>, Modes::groups.size()> D;

    bool with_twist;

    /** Set the rows and columns of the twist, from those of the faces. */
    void
    set_twist(dealii::Tensor<2, Modes::twist + 1> &matrix) const;
  };
} // namespace Biface

#endif
