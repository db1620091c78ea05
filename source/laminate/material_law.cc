// SPDX-License-Identifier: LGPL-2.1-or-later

#include <limits>

#include <biface/laminate/material_law.h>

namespace Biface
{
  using namespace dealii;

  SymmetricTensor<4, 3>
  MaterialLaw::initial_stiffness() const
  {
    using PointStrains::pairs;
    Vector stress;
    Matrix moduli;
    evaluate(Vector(), stress, moduli);
    SymmetricTensor<4, 3> result;
    for (unsigned int i = 0; i < PointStrains::n; ++i)
      for (unsigned int j = 0; j < PointStrains::n; ++j)
        result[pairs[i][0]][pairs[i][1]][pairs[j][0]][pairs[j][1]] =
          moduli[i][j];
    return result;
  }


  LinearLaw::LinearLaw(const SymmetricTensor<4, 3> &stiffness,
                       const bool                   along_normal)
    : along_normal(along_normal)
  {
    using PointStrains::pairs;
    for (unsigned int i = 0; i < PointStrains::n; ++i)
      for (unsigned int j = 0; j < PointStrains::n; ++j)
        b[i][j] = stiffness[pairs[i][0]][pairs[i][1]][pairs[j][0]][pairs[j][1]];
  }


  LinearLaw::Vector
  LinearLaw::strain_of_law(const Vector &strain) const
  {
    // what the thickness strain owes to the leaning of the director is taken
    // off, as for 'Thickness strain = normal' in section 4 of doc/theory.md
    Vector result = strain;
    if (along_normal)
      for (unsigned int a = 0; a < 2; ++a)
        result[PointStrains::thickness] -= strain[PointStrains::transverse(a)] *
                                           strain[PointStrains::transverse(a)] /
                                           2;
    return result;
  }


  double
  LinearLaw::energy(const Vector &strain) const
  {
    const Vector e = strain_of_law(strain);
    return e * (b * e) / 2;
  }


  void
  LinearLaw::evaluate(const Vector &strain,
                      Vector       &stress,
                      Matrix       &moduli) const
  {
    stress = b * strain_of_law(strain);
    moduli = b;
    if (!along_normal)
      return;
    // the derivatives of the strain of the law by the strains
    const double S_33 = stress[PointStrains::thickness];
    for (unsigned int a = 0; a < 2; ++a)
      {
        const double lean = strain[PointStrains::transverse(a)];
        stress[PointStrains::transverse(a)] -= lean * S_33;
        for (unsigned int j = 0; j < PointStrains::n; ++j)
          moduli[j][PointStrains::transverse(a)] -=
            lean * b[j][PointStrains::thickness];
      }
    // columns before, rows from here on; and the second derivative of the
    // strain of the law, with which S_33 changes the stiffness in shear
    const Matrix by_columns = moduli;
    for (unsigned int a = 0; a < 2; ++a)
      {
        for (unsigned int j = 0; j < PointStrains::n; ++j)
          moduli[PointStrains::transverse(a)][j] -=
            strain[PointStrains::transverse(a)] *
            by_columns[PointStrains::thickness][j];
        moduli[PointStrains::transverse(a)][PointStrains::transverse(a)] -=
          S_33;
      }
  }


  MaterialLaw::ThicknessStress
  LinearLaw::thickness_stress(const Vector &strain) const
  {
    return {b[PointStrains::thickness] * strain_of_law(strain),
            b[PointStrains::thickness][PointStrains::thickness]};
  }


  double
  LinearLaw::free_thickness_strain(const Vector &strain) const
  {
    // linear, so that one step of Newton's method solves S_33 = 0
    return strain[PointStrains::thickness] -
           thickness_stress(strain).stress /
             b[PointStrains::thickness][PointStrains::thickness];
  }


  double
  LinearLaw::lowest_thickness_strain(const Vector &) const
  {
    // a linear law has a stress at any strain
    return -std::numeric_limits<double>::infinity();
  }
} // namespace Biface
