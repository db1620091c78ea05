// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_contact_contact_conditions_h
#define biface_contact_contact_conditions_h

#include <deal.II/base/parameter_handler.h>

#include <memory>
#include <vector>

#include <biface/contact/foundation_parameters.h>
#include <biface/contact/moved_foundation.h>
#include <biface/contact/multiplier_mass.h>

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
      FoundationParameters foundation;

      void
      add_parameters(dealii::ParameterHandler &prm);

      /** Throws InputError where a value is not usable. */
      void
      check() const;
    };

    /** Whether a node is in contact. One byte a node: vector<bool> cannot be
     * written to by parts. */
    using ActiveSet = std::vector<char>;

    /** Throws InputError where the foundation's parameters do not describe one.
     */
    explicit ContactConditions(const Parameters &parameters)
      : parameters(parameters)
      , foundation(make_foundation(parameters.foundation))
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

    /** The foundation, not yet moved. */
    MovedFoundation
    foundation_at_rest() const
    {
      return MovedFoundation(foundation);
    }

    /** Whether the tangent of the contact forces is symmetric. */
    bool
    is_symmetric() const
    {
      return parameters.mass == MultiplierMass::lumped;
    }

  private:
    const Parameters                             parameters;
    const std::shared_ptr<const RigidFoundation> foundation;
  };
} // namespace Biface

#endif
