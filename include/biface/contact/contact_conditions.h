// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_contact_contact_conditions_h
#define biface_contact_contact_conditions_h

#include <deal.II/base/parameter_handler.h>

#include <vector>

#include <biface/contact/multiplier_mass.h>
#include <biface/contact/rigid_plane.h>

namespace Biface
{
  /**
   * The regularized, frictionless contact condition of
   * @cite GrigolyukKulikovPlotnikova2004, eq. (14.1), at one node of the outer
   * face, with the clearance c left in the deformed state and the multiplier
   * @f$\lambda@f$ (minus the pressure):
   * - in contact (active): @f$c - \lambda/\varepsilon = 0@f$,
   *   @f$\lambda\le 0@f$;
   * - apart: @f$\lambda = 0@f$, @f$c\ge 0@f$.
   *
   * The multiplier is a function of the displacements,
   * @f$\lambda=\varepsilon c@f$, so that it is no unknown of the linear
   * systems. The primal-dual active set method
   * @cite HintermuellerItoKunisch2002 finds which nodes are active.
   */
  class ContactConditions
  {
  public:
    struct Parameters
    {
      MultiplierMass       mass           = MultiplierMass::consistent;
      double               regularization = 1e4;
      dealii::Tensor<1, 3> normal{{1, 0, 0}};

      void
      add_parameters(dealii::ParameterHandler &prm);

      /** Throws InputError where a value is not usable. */
      void
      check() const;
    };

    /** Whether a node is in contact. One byte a node: vector<bool> cannot be
     * written to by parts. */
    using ActiveSet = std::vector<char>;

    explicit ContactConditions(const Parameters &parameters)
      : parameters(parameters)
    {}

    /** The multiplier of an active node. */
    double
    multiplier(const double clearance) const
    {
      return parameters.regularization * clearance;
    }

    /** Minus the derivative of an active node's multiplier with respect to its
     * motion along the foundation's normal. */
    double
    multiplier_stiffness() const
    {
      return parameters.regularization;
    }

    /** Whether the node should be active, by its state now: a node apart
     * enters where it has penetrated, an active one leaves where it is pulled.
     * Both are the sign of the clearance, see multiplier(). */
    static bool
    should_be_active(const double clearance)
    {
      return clearance < 0;
    }

    MultiplierMass
    mass() const
    {
      return parameters.mass;
    }

    const dealii::Tensor<1, 3> &
    normal() const
    {
      return parameters.normal;
    }

    /** Whether the tangent of the contact forces is symmetric. */
    bool
    is_symmetric() const
    {
      return parameters.mass == MultiplierMass::lumped;
    }

  private:
    const Parameters parameters;
  };
} // namespace Biface

#endif
