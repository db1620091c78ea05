// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_model_contact_moving_body_h
#define biface_model_contact_moving_body_h

#include <functional>
#include <memory>
#include <vector>

#include <biface/contact/rigid_body.h>
#include <biface/contact/tread.h>

namespace Biface
{
  struct BodyParameters;


  /** The body of a ContactPair, at rest and after its motions: the ground,
   * which travels, or another body, which has motions of its own and may be on
   * the ground. */
  class MovingBody
  {
  public:
    /** The ground. */
    MovingBody(const RigidBody &at_rest, const TreadParameters &tread)
      : body(at_rest), tread_height(tread.height.value_or(0))
    {}

    /** Another body, behind the tread if it touches it. */
    MovingBody(const BodyParameters &other, const TreadParameters &tread);

    const RigidBody &
    at_rest() const
    {
      return body;
    }

    /** The body after the given travel from its place at rest. */
    RigidBody
    after_travel(const double travel) const
    {
      return body.moved(travel);
    }

    /** Whether the body is not the ground, but moves with it. */
    bool
    is_on_ground() const;

    /** Another body that is on this one, the ground, after its travel. */
    RigidBody
    carried_by(const RigidBody &on_this, const double travel) const;

    /** The body, which is not the ground, after its own motions by the
     * factors of the loads. The ground takes those along that are on it.
     * @param with_ground the further motion of a body on the ground. */
    RigidBody
    after_motions(
      const std::vector<double>                         &factors,
      const std::function<RigidBody(const RigidBody &)> &with_ground) const;

  private:
    RigidBody body;
    double    tread_height;
    /** The parameters of another body; null for the ground. */
    std::shared_ptr<const BodyParameters> other;
  };
} // namespace Biface

#endif
