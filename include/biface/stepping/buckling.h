// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_stepping_buckling_h
#define biface_stepping_buckling_h

#include <vector>

#include <biface/model/quantities/forces_on_shell.h>
#include <biface/solver/buckling_analysis.h>
#include <biface/stepping/load_level.h>

namespace Biface
{
  /** Loads under which a tangent becomes singular. */
  struct CriticalLoads
  {
    /** The fraction of the change of the loads from the start of the stage to
     * its end. */
    double    factor = 0;
    LoadLevel level;
  };


  /** The prediction of buckling at the end of a stage. */
  struct Buckling
  {
    /** The modes in ascending order of their factors. */
    std::vector<BucklingMode> modes;
    /** The critical loads of each of the modes. */
    std::vector<CriticalLoads> loads;
    /** The forces at the critical loads of each of the modes, on the straight
     * line through those of the two equilibria of the analysis; empty if they
     * are not of interest. */
    std::vector<std::vector<ForceOnShell>> forces;
  };


  /** The change from one level to another of the loads that can make a shell
   * buckle. */
  LoadRates
  change_of(const LoadLevel &before, const LoadLevel &after);


  /** The critical loads of buckling modes.
   * @param start the loads at the start of the stage.
   * @param first, second those of the two equilibria of the analysis; the
   * second one is the end of the stage.
   * @param sealed whether the pressure follows from the volume of a gas. */
  Buckling
  buckling_from(const BucklingModes &found,
                const LoadLevel     &start,
                const LoadLevel     &first,
                const LoadLevel     &second,
                const bool           sealed);
} // namespace Biface

#endif
