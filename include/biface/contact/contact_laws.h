// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_contact_contact_laws_h
#define biface_contact_contact_laws_h

#include <memory>

#include <biface/contact/contact_condition.h>

namespace Biface
{
  class BristleLaw;
  class FrictionLaw;
  class TangentialLaw;


  /** How friction holds the points in contact. */
  enum class FrictionKind
  {
    none,
    /** Friction with stick points, see FrictionWithHistory. */
    with_history,
    /** Friction with stick points, of nodes that cannot slip. */
    glued,
    /** Friction by the slip velocity, see FrictionBySlipVelocity. */
    by_slip_velocity,
    /** Friction by the deflection of bristles, see BristleLaw. */
    by_bristles
  };


  /** The laws between the shell and a body: across the face, and sideways.
   * Copies share them. */
  class ContactLaws
  {
  public:
    /** The laws of contact without friction. */
    explicit ContactLaws(const ContactCondition &condition);

    ContactLaws(const ContactCondition &condition,
                const FrictionLaw      &friction,
                const FrictionKind      kind);

    /** A copy with another penalty stiffness. */
    ContactLaws
    with_condition(const ContactCondition &other) const;

    /** The kind of friction of these laws with another law. There must be
     * friction. */
    ContactLaws
    with_friction(const FrictionLaw &other) const;

    const ContactCondition &
    condition() const
    {
      return across;
    }

    bool
    has_friction() const
    {
      return kind != FrictionKind::none;
    }

    FrictionKind
    kind_of_friction() const
    {
      return kind;
    }

    /** The law of friction, which must be there. */
    const FrictionLaw &
    friction() const
    {
      return *law;
    }

    /** How each node is held sideways for itself. */
    const TangentialLaw &
    tangential() const
    {
      return *of_nodes;
    }

    /** The bristles on the streamlines from which the tractions follow, all
     * at once; null if each node has a traction of its own. */
    const BristleLaw *
    bristles() const
    {
      return of_lines.get();
    }

  private:
    ContactCondition                     across;
    FrictionKind                         kind;
    std::shared_ptr<const FrictionLaw>   law;
    std::shared_ptr<const TangentialLaw> of_nodes;
    std::shared_ptr<const BristleLaw>    of_lines;
  };
} // namespace Biface

#endif
