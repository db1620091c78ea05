// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_stepping_instant_h
#define biface_stepping_instant_h

namespace Biface
{
  /** An instant of an analysis: the position of the stage and the completed
   * fraction of it. */
  struct Instant
  {
    unsigned int stage    = 0;
    double       fraction = 0;

    /** The time, of which each stage takes 1, see TimeInterval. */
    double
    time() const
    {
      return stage + fraction;
    }

    bool
    operator<(const Instant &other) const
    {
      return stage != other.stage ? stage < other.stage
                                  : fraction < other.fraction;
    }
  };
} // namespace Biface

#endif
