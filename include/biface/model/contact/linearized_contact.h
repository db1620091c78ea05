// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_model_contact_linearized_contact_h
#define biface_model_contact_linearized_contact_h

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

namespace Biface
{
  /** The contact at an active point, linearized in its motion against the
   * body. */
  struct LinearizedContact
  {
    dealii::Point<3>     position;
    double               clearance;
    dealii::Tensor<1, 3> normal;
    /** The motion of the body at the point in the increment that follows.
     * Unit: length. */
    dealii::Tensor<1, 3> of_body;
  };
} // namespace Biface

#endif
