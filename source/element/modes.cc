// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/vector.h>

#include <cmath>
#include <vector>

#include <biface/element/modes.h>

namespace Biface
{
  using namespace dealii;

  namespace
  {
    constexpr unsigned int inner_shear =
      Resultants::tangential(2, Resultants::inner);
    constexpr unsigned int outer_shear =
      Resultants::tangential(2, Resultants::outer);

    using Tangential = Tensor<1, Resultants::n_tangential>;

    /** A basis of the tangential strains that a group lacks. */
    std::vector<Tangential>
    missing_strains(const unsigned int m, const bool with_twist)
    {
      std::vector<Tangential> basis;
      for (unsigned int s = 0; s < Resultants::n_tangential; ++s)
        if (Modes::mode_of[m][s] == Modes::n)
          {
            Tangential strain;
            strain[s] = 1;
            if (with_twist && Modes::mode_of[m][Modes::twist] != Modes::n)
              {
                // of the shear strains only the mean is missing
                if (s == outer_shear)
                  continue;
                if (s == inner_shear)
                  strain[outer_shear] = 1;
              }
            basis.push_back(strain);
          }
      return basis;
    }


    Tangential
    tangential_row(const Resultants::Matrix &matrix, const unsigned int s)
    {
      Tangential row;
      for (unsigned int t = 0; t < Resultants::n_tangential; ++t)
        row[t] = matrix[s][t];
      return row;
    }
  } // namespace


  ModeStiffness::ModeStiffness(const Resultants::Matrix &stiffness,
                               const StrainSampling      sampling)
    : with_twist(sampling == StrainSampling::means)
  {
    for (auto &matrix : D)
      {
        for (unsigned int s = 0; s < Resultants::n; ++s)
          for (unsigned int t = 0; t < Resultants::n; ++t)
            matrix[s][t] = stiffness[s][t];
        set_twist(matrix);
      }
  }


  void
  ModeStiffness::set_twist(Tensor<2, Modes::twist + 1> &matrix) const
  {
    using Modes::twist;
    for (unsigned int s = 0; s < Resultants::n; ++s)
      matrix[s][twist] = matrix[s][outer_shear] - matrix[s][inner_shear];
    for (unsigned int t = 0; t <= Resultants::n; ++t)
      matrix[twist][t] = (matrix[outer_shear][t] - matrix[inner_shear][t]) / 2;
  }


  bool
  CellTangents::are_axes() const
  {
    for (const auto &face : faces)
      for (unsigned int a = 0; a < 2; ++a)
        if (!(std::abs(face[a][a] - 1) < 1e-4))
          return false;
    return true;
  }


  CellTangents::Components
  CellTangents::strains(const unsigned int a) const
  {
    using namespace Resultants;
    using Modes::twist;

    Components result;
    for (unsigned int face = 0; face < 2; ++face)
      {
        const auto  &t    = faces[face];
        const double sign = (face == inner ? -1. : 1.);
        for (unsigned int i = 0; i < 2; ++i)
          {
            result[tangential(a, face)][tangential(i, face)] =
              t[a][i] * t[a][i];
            result[twist][tangential(i, face)] = sign * t[0][i] * t[1][i];
            result[transverse(a, face)][transverse(i, face)] = middle[a][i];
          }
        result[tangential(a, face)][tangential(2, face)] =
          2 * t[a][0] * t[a][1];
        result[twist][tangential(2, face)] =
          sign * (t[0][0] * t[1][1] + t[0][1] * t[1][0]);
      }
    result[thickness][thickness] = 1;
    return result;
  }


  CellTangents::Components
  CellTangents::resultants(const unsigned int a) const
  {
    using namespace Resultants;
    using Modes::twist;

    // T_H differs from T_E by the shear, of which a strain counts twice
    const Components of_strains  = strains(a);
    Components       of_stresses = of_strains;
    for (Resultants::Vector &column : of_stresses)
      for (unsigned int face = 0; face < 2; ++face)
        column[tangential(2, face)] /= 2;

    const Modes::Group &group = Modes::groups[1 + a];
    FullMatrix<double>  work(group.size);
    for (unsigned int i = 0; i < group.size; ++i)
      for (unsigned int j = 0; j < group.size; ++j)
        // the resultant of the twist is the mean of the faces
        work(i, j) = of_strains[group.strains[i]] *
                     of_stresses[group.strains[j]] /
                     (group.strains[i] == twist ? 2 : 1);
    work.gauss_jordan();
    Components result;
    for (unsigned int i = 0; i < group.size; ++i)
      for (unsigned int j = 0; j < group.size; ++j)
        result[group.strains[i]] += work(j, i) * of_stresses[group.strains[j]];
    return result;
  }


  namespace
  {
    /** The values of modes at the vertices, where unit modes of the groups that
     * vary in one direction have given components. */
    std::array<Resultants::Vector, 4>
    at_vertices(const Modes::Vector                           &modes,
                const std::array<CellTangents::Components, 2> &components)
    {
      std::array<Resultants::Vector, 4> values;
      for (unsigned int m = 0; m < Modes::groups.size(); ++m)
        {
          const Modes::Group &group = Modes::groups[m];
          Resultants::Vector  of_group;
          for (unsigned int i = 0; i < group.size; ++i)
            {
              const double       mode = modes[group.first_mode + i];
              const unsigned int s    = group.strains[i];
              if (m == 1 || m == 2)
                of_group += mode * components[m - 1][s];
              else
                of_group[s] += mode;
            }
          for (unsigned int v = 0; v < 4; ++v)
            values[v] += group.value_at_vertex(v) * of_group;
        }
      return values;
    }
  } // namespace


  std::array<Resultants::Vector, 4>
  CellTangents::strains_at_vertices(const Modes::Vector &E) const
  {
    return at_vertices(E, {{strains(0), strains(1)}});
  }


  std::array<Resultants::Vector, 4>
  CellTangents::resultants_at_vertices(const Modes::Vector &H) const
  {
    return at_vertices(H, {{resultants(0), resultants(1)}});
  }


  void
  ModeStiffness::turn(const CellTangents &tangents)
  {
    using Modes::twist;

    for (unsigned int a = 0; a < 2; ++a)
      {
        const Modes::Group            &group   = Modes::groups[1 + a];
        const CellTangents::Components strains = tangents.strains(a);
        const auto                     law     = D[1 + a];
        for (unsigned int i = 0; i < group.size; ++i)
          for (unsigned int j = 0; j < group.size; ++j)
            {
              const unsigned int s = group.strains[i], t = group.strains[j];
              double             sum = 0;
              for (unsigned int k = 0; k < Resultants::n; ++k)
                for (unsigned int l = 0; l < Resultants::n; ++l)
                  sum += strains[s][k] * law[k][l] * strains[t][l];
              // the resultant of the twist is the mean of the faces
              D[1 + a][s][t] = (s == twist ? sum / 2 : sum);
            }
      }
  }


  void
  ModeStiffness::release_thickness_strain(const Resultants::Matrix &softest)
  {
    constexpr unsigned int thickness = Resultants::thickness;

    const Tangential by_thickness = tangential_row(softest, thickness);
    for (unsigned int m = 1; m < Modes::groups.size(); ++m)
      {
        // the strains f that the group lacks, with D_ff y = D_f3, section 4 of
        // doc/theory.md
        const std::vector<Tangential> missing = missing_strains(m, with_twist);
        FullMatrix<double>            of_missing(missing.size());
        Vector<double>                right_side(missing.size());
        for (unsigned int f = 0; f < missing.size(); ++f)
          {
            right_side[f] = missing[f] * by_thickness;
            for (unsigned int s = 0; s < Resultants::n_tangential; ++s)
              for (unsigned int g = 0; g < missing.size(); ++g)
                of_missing(f, g) +=
                  missing[f][s] * (tangential_row(softest, s) * missing[g]);
          }
        of_missing.gauss_jordan();
        Vector<double> amounts(missing.size());
        of_missing.vmult(amounts, right_side);
        Tangential y;
        for (unsigned int f = 0; f < missing.size(); ++f)
          y += amounts[f] * missing[f];

        auto      &matrix                = D[m];
        const auto change_free_thickness = [&](const double sign) {
          for (unsigned int s = 0; s < Resultants::n; ++s)
            for (unsigned int t = 0; t < Resultants::n; ++t)
              if (s != thickness && t != thickness)
                matrix[s][t] += sign * matrix[s][thickness] *
                                matrix[thickness][t] /
                                matrix[thickness][thickness];
        };
        // the law between the other strains where the thickness strain has no
        // resultant is taken out before the row of that changes, and put back
        // after
        change_free_thickness(-1);
        for (unsigned int s = 0; s < Resultants::n; ++s)
          {
            const double released = tangential_row(softest, s) * y;
            matrix[s][thickness] -= released;
            if (s != thickness)
              matrix[thickness][s] -= released;
          }
        change_free_thickness(1);
        set_twist(matrix);
      }
  }
} // namespace Biface
