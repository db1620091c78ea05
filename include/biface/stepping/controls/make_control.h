// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_stepping_controls_make_control_h
#define biface_stepping_controls_make_control_h

#include <memory>

#include <biface/stepping/controls/control.h>

namespace Biface
{
  /** Create the control of a stage. */
  std::unique_ptr<Control>
  make_control(const Stage               &stage,
               const Control::Parameters &parameters = Control::Parameters());
} // namespace Biface

#endif
