// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_laminate_time_step_h
#define biface_laminate_time_step_h

namespace Biface
{
  /** The time between two equilibria, and the temperature. */
  struct TimeStep
  {
    /** The duration. Unit: time. */
    double duration = 0;
    /** The temperature in the middle of the step. Unit: that of Relaxation. */
    double temperature = 0;
  };
} // namespace Biface

#endif
