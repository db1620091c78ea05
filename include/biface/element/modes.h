// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_element_modes_h
#define biface_element_modes_h

#include <deal.II/base/tensor.h>

#include <array>

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
   */
  namespace Modes
  {
    constexpr unsigned int n = 22;

    /** The strains kept as coefficients of one bilinear function. */
    struct Group
    {
      /** Whether the function contains @f$\xi_1@f$, @f$\xi_2@f$. */
      std::array<bool, 2> varies;
      unsigned int        first_mode;
      unsigned int        size;
      /** Indices of the strains, see Resultants. */
      std::array<unsigned int, Resultants::n> strains;

      /** The mean square of the function over the element. */
      constexpr double
      weight() const
      {
        return (varies[0] ? 1. / 3 : 1.) * (varies[1] ? 1. / 3 : 1.);
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
      {{{{false, false}}, 0, 11, {{0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10}}},
       {{{false, true}}, 11, 5, {{0, 1, 6, 7, 10}}},
       {{{true, false}}, 16, 5, {{2, 3, 8, 9, 10}}},
       {{{true, true}}, 21, 1, {{10}}}}};

    /** `mode_of[group][strain]`: the number of the mode, or n if the group does
     * not contain this strain. */
    constexpr std::array<std::array<unsigned int, Resultants::n>, 4> mode_of =
      [] {
        std::array<std::array<unsigned int, Resultants::n>, 4> table{};
        for (unsigned int m = 0; m < 4; ++m)
          {
            for (unsigned int s = 0; s < Resultants::n; ++s)
              table[m][s] = n;
            for (unsigned int i = 0; i < groups[m].size; ++i)
              table[m][groups[m].strains[i]] = groups[m].first_mode + i;
          }
        return table;
      }();

    using Vector = dealii::Tensor<1, n>;

    /** The modes of strains given at the vertices. */
    inline Vector
    from_vertices(const std::array<Resultants::Vector, 4> &at_vertices)
    {
      Vector modes;
      for (const Group &group : groups)
        for (unsigned int i = 0; i < group.size; ++i)
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
        for (unsigned int i = 0; i < group.size; ++i)
          for (unsigned int v = 0; v < 4; ++v)
            values[v][group.strains[i]] +=
              group.value_at_vertex(v) * modes[group.first_mode + i];
      return values;
    }

    /**
     * The transpose of from_vertices() with the weights of the groups: the
     * resultants @f$\mathbf h_v@f$ at the vertices for which
     * @f$\sum_m w_m H_m\,\delta E_m = \sum_v\mathbf
     * h_v\cdot\delta\boldsymbol\varepsilon_v@f$.
     */
    inline std::array<Resultants::Vector, 4>
    to_vertices(const Vector &resultants)
    {
      std::array<Resultants::Vector, 4> at_vertices;
      for (const Group &group : groups)
        for (unsigned int i = 0; i < group.size; ++i)
          for (unsigned int v = 0; v < 4; ++v)
            at_vertices[v][group.strains[i]] +=
              group.weight() * group.value_at_vertex(v) *
              resultants[group.first_mode + i] / 4;
      return at_vertices;
    }

    /** Modes of a quantity that is constant over the element. */
    inline Vector
    constant(const Resultants::Vector &value)
    {
      Vector modes;
      for (unsigned int s = 0; s < Resultants::n; ++s)
        modes[s] = value[s];
      return modes;
    }

    /** Sum over the modes of @f$w_m\,a_m b_m@f$: the mean over the element of
     * the scalar product of two interpolated quantities. */
    inline double
    mean_product(const Vector &a, const Vector &b)
    {
      double sum = 0;
      for (const Group &group : groups)
        for (unsigned int i = 0; i < group.size; ++i)
          sum +=
            group.weight() * a[group.first_mode + i] * b[group.first_mode + i];
      return sum;
    }
  } // namespace Modes


  /**
   * The constitutive law between modes,
   * @f$\mathbf H^m = (\mathbf Q^T\mathbf D\mathbf Q)\,\mathbf E^m@f$ for each
   * group m.
   */
  class ModeStiffness
  {
  public:
    explicit ModeStiffness(const Resultants::Matrix &D) : D(D)
    {}

    /** The resultants of given strains. */
    Modes::Vector
    resultants(const Modes::Vector &strain) const
    {
      Modes::Vector H;
      for (const Modes::Group &group : Modes::groups)
        for (unsigned int i = 0; i < group.size; ++i)
          for (unsigned int j = 0; j < group.size; ++j)
            H[group.first_mode + i] += D[group.strains[i]][group.strains[j]] *
                                       strain[group.first_mode + j];
      return H;
    }

    /** The entry of @f$\mathbf D@f$ for two strains. */
    double
    operator()(const unsigned int s, const unsigned int t) const
    {
      return D[s][t];
    }

  private:
    Resultants::Matrix D;
  };
} // namespace Biface

#endif
