// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_laminate_cord_law_h
#define biface_laminate_cord_law_h

#include <deal.II/base/tensor.h>

#include <memory>

#include <biface/laminate/resultants.h>

namespace Biface
{
  class ForceCurve;
  class Relaxation;

  /**
   * What the cords of a ply add to the law of its material: a stress along them
   * that depends on the Green-Lagrange strain along them. Unit of energies,
   * stresses and moduli: force per area of the ply.
   */
  class CordLaw
  {
  public:
    virtual ~CordLaw() = default;

    struct Response
    {
      double energy, stress, modulus;
    };

    /** The response at a strain along the cords; energy and stress are those
     * since the undeformed state. */
    virtual Response
    response(const double strain) const = 0;

    /** Whether a strain is below the one from which on cords are softer. */
    virtual bool
    is_slack(const double strain) const = 0;

    /** The lowest modulus that any strain can have. */
    virtual double
    lowest_modulus() const = 0;
  };


  /**
   * Cords that go slack in a ply whose linear law contains them, in the manner
   * of @cite Bert1977 . Below the strain @f$-e_c@f$ the stress along the cords
   * is smaller by @f$\kappa(e+e_c)@f$, with @f$\kappa=E_L-E_{L,c}@f$ and the
   * modulus @f$E_{L,c}@f$ in compression. The stiffness of the ply is then
   * @f$\mathbf b-\kappa\,\mathbf a\mathbf a^T@f$, where @f$\mathbf a@f$ are the
   * components of the dyad of the cords. A uniaxial stress along the cords has
   * exactly the moduli @f$E_L@f$ in tension and @f$E_{L,c}@f$ in compression,
   * and the same Poisson's ratios.
   */
  class SlackCordLaw : public CordLaw
  {
  public:
    /** The law for the loss of modulus in compression.
     * @param loss @f$\kappa@f$. Unit: force/area.
     * @param onset @f$e_c\ge0@f$
     * @param initial_strain the strain that causes the initial stress of the
     * ply. */
    SlackCordLaw(const double loss,
                 const double onset,
                 const double initial_strain);

    Response
    response(const double strain) const override;

    bool
    is_slack(const double strain) const override
    {
      return strain < limit;
    }

    double
    lowest_modulus() const override
    {
      return -loss;
    }

  private:
    double loss, limit;
  };


  /**
   * Cords whose nominal stress, the force per undeformed area of the ply, is
   * linear in their stretch @f$\lambda=\sqrt{1+2e}@f$:
   * @f$P = E\,(\lambda-1)@f$, with a lower modulus where they are shorter than
   * @f$1-e_c@f$. The stress is @f$P/\lambda@f$. In tension, what a measured
   * curve @f$F(\lambda)@f$ has beyond its initial slope may be added,
   * @f$n\,[F(\lambda)-F'(1)(\lambda-1)]@f$ with n cords per area.
   */
  class StretchedCordLaw : public CordLaw
  {
  public:
    /**
     * @param modulus of the cords alone. Unit: force/area of the ply.
     * @param compression The modulus in compression beyond the onset. Unit:
     * force/area of the ply.
     * @param onset @f$e_c@f$ of CordLaw.
     * @param curve of a cord; null for none.
     * @param n_per_area the cords per area of the ply across them. Unit:
     * 1/area.
     */
    StretchedCordLaw(const double                      modulus,
                     const double                      compression,
                     const double                      onset,
                     std::shared_ptr<const ForceCurve> curve      = nullptr,
                     const double                      n_per_area = 0);

    Response
    response(const double strain) const override;

    bool
    is_slack(const double strain) const override;

    double
    lowest_modulus() const override;

  private:
    double                            modulus, compression, onset;
    std::shared_ptr<const ForceCurve> curve;
    double                            n_per_area;
  };


  /** Cords at a height within a ply: a point of the integration over the
   * thickness. */
  struct CordPoint
  {
    /** The vector @f$\mathbf A@f$ in the strain along the cords
     * @f$e=\mathbf A\cdot\mathbf E@f$, with the tangential strains of both
     * faces, in the order of Resultants. */
    dealii::Tensor<1, Resultants::n_tangential> direction;
    /** The part of the thickness of the ply that the point stands for. Unit:
     * length. */
    double                         thickness;
    std::shared_ptr<const CordLaw> law;
    /** The height above the inner face. Unit: length. */
    double height;
    /** The position of the ply in Laminate::get_plies(). */
    unsigned int ply;
    /** The relaxation of the stress of the cords; null for none. */
    std::shared_ptr<const Relaxation> relaxation;
  };
} // namespace Biface

#endif
