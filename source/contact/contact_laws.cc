// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/exceptions.h>

#include <biface/contact/bristles.h>
#include <biface/contact/contact_laws.h>
#include <biface/contact/friction.h>
#include <biface/contact/friction_by_slip_velocity.h>
#include <biface/contact/friction_with_history.h>

namespace Biface
{
  namespace
  {
    std::shared_ptr<const TangentialLaw>
    law_of_nodes(const ContactCondition &condition,
                 const FrictionLaw      &friction,
                 const FrictionKind      kind)
    {
      switch (kind)
        {
          case FrictionKind::none:
            break;
          case FrictionKind::with_history:
          case FrictionKind::glued:
            return std::make_shared<const FrictionWithHistory>(
              friction, condition, kind == FrictionKind::glued);
          case FrictionKind::by_slip_velocity:
            return std::make_shared<const FrictionBySlipVelocity>(friction,
                                                                  condition);
          case FrictionKind::by_bristles:
            // the tractions are those of BristleLaw, of whole lines at once;
            // nodes only keep the stick points for a stage that stands after
            // this one
            return std::make_shared<const FrictionWithoutHistory>(friction);
        }
      return std::make_shared<const TangentialLaw>();
    }
  } // namespace


  ContactLaws::ContactLaws(const ContactCondition &condition)
    : across(condition)
    , kind(FrictionKind::none)
    , of_nodes(std::make_shared<const TangentialLaw>())
  {}


  ContactLaws::ContactLaws(const ContactCondition &condition,
                           const FrictionLaw      &friction,
                           const FrictionKind      kind)
    : across(condition)
    , kind(kind)
    , law(std::make_shared<const FrictionLaw>(friction))
    , of_nodes(law_of_nodes(condition, friction, kind))
    , of_lines(kind == FrictionKind::by_bristles
                 ? std::make_shared<const BristleLaw>(friction, condition)
                 : nullptr)
  {}


  ContactLaws
  ContactLaws::with_condition(const ContactCondition &other) const
  {
    return law ? ContactLaws(other, *law, kind) : ContactLaws(other);
  }


  ContactLaws
  ContactLaws::with_friction(const FrictionLaw &other) const
  {
    Assert(has_friction(), dealii::ExcInternalError());
    return ContactLaws(across, other, kind);
  }
} // namespace Biface
