// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_laminate_time_step_h
#define biface_laminate_time_step_h

namespace Biface
{
  /** What happens between two equilibria beside the change of strains. */
  struct TimeStep
  {
    /** Unit: time. */
    double duration = 0;
    /** In the middle of it. Unit: that of Relaxation. */
    double temperature = 0;
  };
} // namespace Biface

#endif
