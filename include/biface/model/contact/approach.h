// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_model_contact_approach_h
#define biface_model_contact_approach_h

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <functional>

#include <biface/contact/active_set.h>

namespace Biface
{
  class ContactPair;
  struct Loads;
  struct State;


  // Where the body of a pair meets its face, before and beside the contact.

  /** The travel at which the body at rest just touches a free node of the
   * deformed face, one that can come into contact. Must be called on all ranks.
   * Throws InputError if it misses the shell, or if the shell does not fit into
   * it. */
  double
  travel_at_first_contact(const ContactPair &pair, const State &state);

  /** The mean of the deformed positions of the nodes that the body touches at
   * the given travel. Must be called on all ranks. */
  dealii::Point<3>
  first_contact_point(const ContactPair &pair,
                      const State       &state,
                      const double       travel_at_first_contact);

  /** The nodes of this rank that the body has passed through: supports hold
   * their face, so they cannot come into contact. */
  ActiveSet
  pierced_nodes(const ContactPair &pair,
                const State       &state,
                const Loads       &loads);

  /** How deep a node of the face that may touch is in the body; 0 if none is.
   * Must be called on all ranks. Unit: length. */
  double
  penetration(const ContactPair &pair, const State &state, const Loads &loads);

  /** The largest angle between the deformed thickness of the shell and the
   * normal of the body at an active point; 0 if there is none, small where the
   * shell lies on a smooth body, and large at a point that the side of an
   * obstacle holds. Must be called on all ranks. Unit: radians. */
  double
  largest_angle_of_normals(const ContactPair &pair,
                           const State       &state,
                           const Loads       &loads);

  /** Whether a node of this rank has passed through the body: one that did
   * not touch it, on the straight line between its places relative to the
   * body, and one that did, if the normal has turned by more than 120
   * degrees. */
  bool
  was_passed(const ContactPair &pair,
             const State       &before,
             const Loads       &loads_before,
             const State       &after,
             const Loads       &loads_after);

  /** The travel from the present place of the body until it touches a free
   * node of the face, see RigidBody::travel_to(). Must be called on all
   * ranks. */
  double
  remaining_travel(const ContactPair &pair,
                   const State       &state,
                   const Loads       &loads);

  /** The way of the body until it is in a free node of the face, by the given
   * depth and its velocity at present; infinite if it approaches none. Must be
   * called on all ranks.
   * @param velocity that of the body at a point relative to the shell, per
   * way. */
  double
  distance_to_contact(
    const ContactPair &pair,
    const State       &state,
    const Loads       &loads,
    const std::function<dealii::Tensor<1, 3>(const dealii::Point<3> &)>
                &velocity,
    const double depth);
} // namespace Biface

#endif
