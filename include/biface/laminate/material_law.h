// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_laminate_material_law_h
#define biface_laminate_material_law_h

#include <deal.II/base/symmetric_tensor.h>
#include <deal.II/base/tensor.h>

#include <limits>

namespace Biface
{
  /**
   * The order of the six strains and stresses at a point of a ply:
   * 11, 22, 12, 13, 23, 33, as in Resultants. The Green-Lagrange strains 12,
   * 13, 23 are doubled, so that the stresses (second Piola-Kirchhoff) are the
   * derivatives of an energy by the strains.
   */
  namespace PointStrains
  {
    constexpr unsigned int n = 6;
    /** The index of the strain 33. */
    constexpr unsigned int thickness = 5;
    /** The index of a transverse shear strain; @p a is 0, 1 for 13, 23. */
    constexpr unsigned int
    transverse(const unsigned int a)
    {
      return 3 + a;
    }
    /** The components of a tensor that each strain stands for. */
    constexpr unsigned int pairs[n][2] = {
      {0, 0}, {1, 1}, {0, 1}, {0, 2}, {1, 2}, {2, 2}};

    using Vector = dealii::Tensor<1, n>;
    using Matrix = dealii::Tensor<2, n>;

    /** The value where a law has no strain or stress. */
    constexpr double none = std::numeric_limits<double>::quiet_NaN();

    inline dealii::SymmetricTensor<2, 3>
    to_strain(const Vector &strain)
    {
      dealii::SymmetricTensor<2, 3> result;
      for (unsigned int i = 0; i < n; ++i)
        result[pairs[i][0]][pairs[i][1]] =
          strain[i] / (pairs[i][0] == pairs[i][1] ? 1 : 2);
      return result;
    }

    inline dealii::SymmetricTensor<2, 3>
    to_stress(const Vector &stress)
    {
      dealii::SymmetricTensor<2, 3> result;
      for (unsigned int i = 0; i < n; ++i)
        result[pairs[i][0]][pairs[i][1]] = stress[i];
      return result;
    }
  } // namespace PointStrains


  /**
   * The elastic law at a point of a ply, in the frame of the shell: an energy
   * per undeformed volume as a function of the strains. Unit of energies,
   * stresses and moduli: force/area.
   *
   * Where strains have no energy, as where they turn a volume inside out, the
   * functions return nan.
   */
  class MaterialLaw
  {
  public:
    using Vector = PointStrains::Vector;
    using Matrix = PointStrains::Matrix;

    virtual ~MaterialLaw() = default;

    virtual double
    energy(const Vector &strain) const = 0;

    /** The stresses, and their derivatives by the strains. */
    virtual void
    evaluate(const Vector &strain, Vector &stress, Matrix &moduli) const = 0;

    /** The stress 33 and its derivative by the strain 33. */
    struct ThicknessStress
    {
      double stress, modulus;
    };
    virtual ThicknessStress
    thickness_stress(const Vector &strain) const = 0;

    /** A strain 33 with about no stress 33, for the other strains. */
    virtual double
    free_thickness_strain(const Vector &strain) const = 0;

    /** The limit above which the strain 33 must lie, for the other strains. */
    virtual double
    lowest_thickness_strain(const Vector &strain) const = 0;

    /** The stresses of strains. */
    Vector
    stress(const Vector &strain) const
    {
      Vector stress;
      Matrix moduli;
      evaluate(strain, stress, moduli);
      return stress;
    }

    /** The moduli at zero strain, as a tensor. */
    dealii::SymmetricTensor<4, 3>
    initial_stiffness() const;
  };


  /** A linear law between the second Piola-Kirchhoff stresses and the
   * Green-Lagrange strains (St. Venant-Kirchhoff). */
  class LinearLaw : public MaterialLaw
  {
  public:
    /** The law with a stiffness.
     * @param stiffness in the frame of the shell. Unit: force/area.
     * @param along_normal whether the strain 33 of the law is that of the
     * distance along the normal, without the shear that makes the director
     * lean, see NormalThickness. */
    LinearLaw(const dealii::SymmetricTensor<4, 3> &stiffness,
              const bool                           along_normal);

    double
    energy(const Vector &strain) const override;

    void
    evaluate(const Vector &strain,
             Vector       &stress,
             Matrix       &moduli) const override;

    ThicknessStress
    thickness_stress(const Vector &strain) const override;

    double
    free_thickness_strain(const Vector &strain) const override;

    double
    lowest_thickness_strain(const Vector &strain) const override;

  private:
    /** The strains to which the stiffness of the law refers, without the lean
     * of the director. */
    Vector
    strain_of_law(const Vector &strain) const;

    Matrix b;
    bool   along_normal;
  };
} // namespace Biface

#endif
