// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/vector.h>

#include <vector>

#include <biface/element/recovered_strains.h>

namespace Biface
{
  using namespace dealii;

  namespace
  {
    /** The strains that the group along @f$\xi_2@f$ (@p a = 0) or
     * @f$\xi_1@f$ (1) lacks, and on which its resultants do no work. */
    std::vector<Resultants::Vector>
    missing_strains(const CellTangents &tangents, const unsigned int a)
    {
      using namespace Resultants;
      const auto                      basis = tangents.basis(a);
      std::vector<Resultants::Vector> missing;
      for (const auto face : {inner, outer})
        for (const unsigned int strain :
             {tangential(1 - a, face), transverse(1 - a, face)})
          missing.push_back(basis[strain]);
      missing.push_back(basis[tangential(2, inner)] +
                        basis[tangential(2, outer)]);
      return missing;
    }


    /** Add those of the missing strains that leave no resultants for them,
     * with the thickness strain that keeps the resultant of the thickness. */
    void
    release(std::vector<Resultants::Vector> missing,
            const Resultants::Matrix       &stiffness,
            Resultants::Vector             &strain)
    {
      Resultants::Vector thickness;
      thickness[Resultants::thickness] = 1;
      missing.push_back(thickness);
      const unsigned int n = missing.size();
      FullMatrix<double> of_missing(n);
      Vector<double>     right_side(n), amounts(n);
      for (unsigned int f = 0; f < n; ++f)
        {
          const Resultants::Vector H = stiffness * missing[f];
          for (unsigned int g = 0; g < n; ++g)
            of_missing(g, f) = missing[g] * H;
          right_side[f] = -(missing[f] * (stiffness * strain));
        }
      right_side[n - 1] = 0;
      of_missing.gauss_jordan();
      of_missing.vmult(amounts, right_side);
      for (unsigned int f = 0; f < n; ++f)
        strain += amounts[f] * missing[f];
    }
  } // namespace


  std::array<Resultants::Vector, 4>
  recovered_strains(const CellTangents       &tangents,
                    const Modes::Vector      &E,
                    const Resultants::Matrix &stiffness)
  {
    std::array<Resultants::Vector, 4> values = tangents.strains_at_vertices(E);
    const auto                        along  = tangents.strains();
    for (unsigned int a = 0; a < 2; ++a)
      {
        const Modes::Group &group = Modes::groups[1 + a];
        Resultants::Vector  strain;
        for (unsigned int i = 0; i < group.size; ++i)
          strain += E[group.first_mode + i] * along[a][group.strains[i]];
        Resultants::Vector released = strain;
        release(missing_strains(tangents, a), stiffness, released);
        for (unsigned int v = 0; v < 4; ++v)
          values[v] += group.value_at_vertex(v) * (released - strain);
      }
    return values;
  }
} // namespace Biface
