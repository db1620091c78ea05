// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_contact_body_motion_h
#define biface_contact_body_motion_h

#include <deal.II/base/numbers.h>
#include <deal.II/base/tensor.h>

#include <optional>
#include <string>

#include <biface/contact/suspension.h>

namespace Biface
{
  /** A motion of a body: a translation, and a turn about an axis through a
   * point of the body, which moves along. Of several turns, the first one is
   * about the axis that the later ones take along. */
  struct BodyMotion
  {
    std::string name;
    /** The translation at the factor 1. Unit: length. */
    dealii::Tensor<1, 3> translation;
    /** The angle of the turn at the factor 1, right-handed, in radians. */
    double turn = 0;
    /** The vector along the axis of the turn, of any length; if not set, the
     * axis is that of the body. */
    std::optional<dealii::Tensor<1, 3>> axis;
    /** What resists the motion, where a force determines it. */
    Suspension suspension;
    /** The position of the factor in Loads::factors, or travel_of_ground.
     */
    unsigned int factor = 0;

    static constexpr unsigned int travel_of_ground =
      dealii::numbers::invalid_unsigned_int;

    /** The length of the translation at the factor 1 or, without one, the
     * angle, to which a force refers. */
    double
    amplitude() const
    {
      return translation.norm() > 0 ? translation.norm() : turn;
    }

    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      dealii::Tensor<1, 3> about = axis.value_or(dealii::Tensor<1, 3>());
      archive &name &translation &turn &about &suspension &factor;
      if (about.norm_square() > 0)
        axis = about;
    }
  };
} // namespace Biface

#endif
