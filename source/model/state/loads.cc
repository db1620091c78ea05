// SPDX-License-Identifier: LGPL-2.1-or-later

#include <biface/model/state/loads.h>
#include <biface/model/state/placed_body.h>

namespace Biface
{
  void
  Loads::place(const unsigned int number, const PlacedBody &body)
  {
    bodies.insert_or_assign(number, std::make_shared<const PlacedBody>(body));
  }


  const PlacedBody *
  Loads::body(const unsigned int number) const
  {
    const auto found = bodies.find(number);
    return found == bodies.end() ? nullptr : found->second.get();
  }


  const RigidBody *
  Loads::ground() const
  {
    const PlacedBody *placed = body(0);
    return placed ? &placed->body : nullptr;
  }
} // namespace Biface
