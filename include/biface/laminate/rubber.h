// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_laminate_rubber_h
#define biface_laminate_rubber_h

#include <array>
#include <vector>

#include <biface/laminate/material_law.h>

namespace Biface
{
  /** The common part of all laws of isotropic hyperelastic materials: the
   * strains at which the volume does not change, or vanishes. */
  class Rubber : public MaterialLaw
  {
  public:
    double
    free_thickness_strain(const Vector &strain) const override;

    double
    lowest_thickness_strain(const Vector &strain) const override;
  };


  /**
   * Laws whose energy depends on the invariants @f$I_1,I_2,I_3@f$ of the right
   * Cauchy-Green tensor @f$\mathbf C@f$, with @f$I_3=J^2@f$.
   */
  class RubberOfInvariants : public Rubber
  {
  public:
    double
    energy(const Vector &strain) const override;

    void
    evaluate(const Vector &strain,
             Vector       &stress,
             Matrix       &moduli) const override;

    ThicknessStress
    thickness_stress(const Vector &strain) const override;

  protected:
    /** The invariants less those of the undeformed state, 3, 3 and 1. */
    struct Invariants
    {
      double i_1, i_2, i_3;
    };

    /** The derivatives of the energy by the invariants. */
    struct Derivatives
    {
      dealii::Tensor<1, 3>          first;
      dealii::SymmetricTensor<2, 3> second;
    };

    virtual double
    energy_of(const Invariants &invariants) const = 0;

    virtual Derivatives
    derivatives_at(const Invariants &invariants) const = 0;

  private:
    static Invariants
    invariants(const Vector &strain);
  };


  /**
   * Compressible neo-Hookean rubber,
   * @f[
   *   \psi = \frac\mu2\,(I_1-3-2\ln J)
   *     + \frac\lambda2\Bigl(\frac{J^2-1}2-\ln J\Bigr),\qquad
   *   \lambda=K-\tfrac23\mu .
   * @f]
   */
  class NeoHooke : public RubberOfInvariants
  {
  public:
    /** @param mu the shear modulus. Unit: force/area.
     * @param K the bulk modulus. Unit: force/area. */
    NeoHooke(const double mu, const double K);

  protected:
    double
    energy_of(const Invariants &invariants) const override;
    Derivatives
    derivatives_at(const Invariants &invariants) const override;

  private:
    double mu, lambda;
  };


  /**
   * Rubber with a polynomial in the invariants of the part of the strain that
   * keeps the volume, @f$\bar I_1=J^{-2/3}I_1@f$, @f$\bar I_2=J^{-4/3}I_2@f$:
   * @f[
   *   \psi = \sum_{i=1}^3 c_{i0}(\bar I_1-3)^i + c_{01}(\bar I_2-3)
   *     + \frac K2\Bigl(\frac{J^2-1}2-\ln J\Bigr),
   * @f]
   * which contains the laws of Mooney-Rivlin (@f$c_{10},c_{01}@f$) and Yeoh
   * (@f$c_{10},c_{20},c_{30}@f$).
   */
  class PolynomialRubber : public RubberOfInvariants
  {
  public:
    /** Rubber with given constants.
     * @param c @f$c_{10},c_{20},c_{30}@f$. Unit: force/area.
     * @param c_01 Unit: force/area.
     * @param K the bulk modulus. Unit: force/area. */
    PolynomialRubber(const std::array<double, 3> &c,
                     const double                 c_01,
                     const double                 K);

  protected:
    double
    energy_of(const Invariants &invariants) const override;
    Derivatives
    derivatives_at(const Invariants &invariants) const override;

  private:
    std::array<double, 3> c;
    double                c_01, K;
  };


  /**
   * Ogden's rubber: with the principal stretches
   * @f$\bar\lambda_A=J^{-1/3}\lambda_A@f$
   * @f[
   *   \psi = \sum_i\frac{\mu_i}{\alpha_i}
   *     (\bar\lambda_1^{\alpha_i}+\bar\lambda_2^{\alpha_i}
   *      +\bar\lambda_3^{\alpha_i}-3)
   *     + \frac K2\Bigl(\frac{J^2-1}2-\ln J\Bigr).
   * @f]
   * The shear modulus is @f$\frac12\sum_i\mu_i\alpha_i@f$.
   */
  class OgdenRubber : public Rubber
  {
  public:
    struct Term
    {
      /** The coefficient @f$\mu_i@f$. Unit: force/area. */
      double mu;
      double alpha;
    };

    /** Rubber with given terms.
     * @param K the bulk modulus. Unit: force/area. */
    OgdenRubber(const std::vector<Term> &terms, const double K);

    double
    energy(const Vector &strain) const override;

    void
    evaluate(const Vector &strain,
             Vector       &stress,
             Matrix       &moduli) const override;

    ThicknessStress
    thickness_stress(const Vector &strain) const override;

  private:
    std::vector<Term> terms;
    double            K;
  };
} // namespace Biface

#endif
