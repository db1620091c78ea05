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


    /** The matrix of a laminate between the strains of a group and those that
     * it lacks, along the tangents of a cell unless they are null. */
    Resultants::Matrix
    law_of_group(const unsigned int        m,
                 const Resultants::Matrix &stiffness,
                 const CellTangents       *tangents)
    {
      return tangents && (m == 1 || m == 2)
               ? tangents->in_basis(stiffness, m - 1)
               : stiffness;
    }
  } // namespace


  ModeStiffness::ModeStiffness(const Resultants::Matrix &stiffness,
                               const Formulation         formulation,
                               const CellTangents       *tangents)
    : with_twist(formulation == Formulation::standard)
  {
    for (unsigned int m = 0; m < D.size(); ++m)
      {
        const Resultants::Matrix law = law_of_group(m, stiffness, tangents);
        for (unsigned int s = 0; s < Resultants::n; ++s)
          for (unsigned int t = 0; t < Resultants::n; ++t)
            D[m][s][t] = law[s][t];
        set_twist(D[m]);
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


  Modes::Components
  CellTangents::strains(const unsigned int a) const
  {
    using namespace Resultants;
    using Modes::twist;

    Modes::Components result;
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


  Modes::Components
  CellTangents::resultants(const unsigned int a) const
  {
    using namespace Resultants;
    using Modes::twist;

    // T_H differs from T_E by the shear, of which a strain counts twice
    const Modes::Components of_strains  = strains(a);
    Modes::Components       of_stresses = of_strains;
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
    Modes::Components result;
    for (unsigned int i = 0; i < group.size; ++i)
      for (unsigned int j = 0; j < group.size; ++j)
        result[group.strains[i]] += work(j, i) * of_stresses[group.strains[j]];
    return result;
  }


  std::array<Resultants::Vector, Resultants::n>
  CellTangents::basis(const unsigned int a) const
  {
    using namespace Resultants;

    std::array<Resultants::Vector, Resultants::n> result;
    const Modes::Components                       kept = strains(a);
    const unsigned int                            b    = 1 - a;
    Resultants::Vector                            shear;
    for (unsigned int face = 0; face < 2; ++face)
      {
        Tensor<2, 2> t;
        for (unsigned int c = 0; c < 2; ++c)
          t[c] = faces[face][c];
        // the dual vectors are its columns
        const Tensor<2, 2> dual     = invert(t);
        result[tangential(a, face)] = kept[tangential(a, face)];
        result[transverse(a, face)] = kept[transverse(a, face)];
        for (unsigned int i = 0; i < 2; ++i)
          {
            result[tangential(b, face)][tangential(i, face)] =
              dual[i][b] * dual[i][b];
            shear[tangential(i, face)] = dual[i][0] * dual[i][1];
            // a strain that does no work with the shear of the group
            result[transverse(b, face)][transverse(i, face)] =
              (i == 0 ? -middle[a][1] : middle[a][0]);
          }
        result[tangential(b, face)][tangential(2, face)] =
          2 * dual[0][b] * dual[1][b];
        shear[tangential(2, face)] =
          dual[0][0] * dual[1][1] + dual[0][1] * dual[1][0];
      }
    result[inner_shear]          = (shear - kept[Modes::twist]) / 2;
    result[outer_shear]          = (shear + kept[Modes::twist]) / 2;
    result[thickness][thickness] = 1;
    return result;
  }


  Resultants::Matrix
  CellTangents::in_basis(const Resultants::Matrix &stiffness,
                         const unsigned int        a) const
  {
    const auto         strains = basis(a);
    Resultants::Matrix result;
    for (unsigned int t = 0; t < Resultants::n; ++t)
      {
        const Resultants::Vector H = stiffness * strains[t];
        for (unsigned int s = 0; s < Resultants::n; ++s)
          result[s][t] = strains[s] * H;
      }
    return result;
  }


  std::array<Resultants::Vector, 4>
  Modes::at_vertices(const Vector &modes, const ComponentsOfGroups &along)
  {
    std::array<Resultants::Vector, 4> values;
    for (unsigned int m = 0; m < groups.size(); ++m)
      {
        const Group       &group = groups[m];
        Resultants::Vector of_group;
        for (unsigned int i = 0; i < group.size; ++i)
          {
            const double       mode = modes[group.first_mode + i];
            const unsigned int s    = group.strains[i];
            if (m == 1 || m == 2)
              of_group += mode * along[m - 1][s];
            else
              of_group[s] += mode;
          }
        for (unsigned int v = 0; v < 4; ++v)
          values[v] += group.value_at_vertex(v) * of_group;
      }
    return values;
  }


  std::array<Resultants::Vector, 4>
  CellTangents::strains_at_vertices(const Modes::Vector &E) const
  {
    return Modes::at_vertices(E, strains());
  }


  std::array<Resultants::Vector, 4>
  CellTangents::resultants_at_vertices(const Modes::Vector &H) const
  {
    return Modes::at_vertices(H, {{resultants(0), resultants(1)}});
  }


  void
  ModeStiffness::release_thickness_strain(
    const Resultants::Matrix &softest_of_axes, const CellTangents *tangents)
  {
    constexpr unsigned int thickness = Resultants::thickness;

    for (unsigned int m = 1; m < Modes::groups.size(); ++m)
      {
        const Resultants::Matrix softest =
          law_of_group(m, softest_of_axes, tangents);
        const Tangential by_thickness = tangential_row(softest, thickness);
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
