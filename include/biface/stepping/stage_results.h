// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_stepping_stage_results_h
#define biface_stepping_stage_results_h

#include <string>

namespace Biface
{
  class EntryDeclarations;


  /** What is done where the number of negative pivots of the tangent changes
   * along the path of a stage, see CriticalPoint. */
  enum class CriticalPoints
  {
    ignore,
    /** Report the critical point after the step. */
    report,
    /** End the step at the critical point, by bisection. */
    locate,
    /** End the step at the critical point and, if it is a bifurcation, go on
     * along the other branch. */
    switch_branch
  };


  /** What is computed at the end of a stage or along its path, besides the
   * equilibria: see StageAnalysis. */
  struct StageResults
  {
    /** The number of natural frequencies computed at the end of the stage, see
     * ModalAnalysis. */
    unsigned int n_modes = 0;

    /** The number of buckling loads predicted at the end of the stage, see
     * BucklingAnalysis. */
    unsigned int n_buckling = 0;

    CriticalPoints critical_points = CriticalPoints::report;
    /** The first amplitude of the critical shape on the other branch, as a
     * multiple of the thickness. */
    double branch_amplitude = 1;

    /** Whether steps end at critical points. */
    bool
    locates_critical_points() const
    {
      return critical_points == CriticalPoints::locate ||
             critical_points == CriticalPoints::switch_branch;
    }

    /** The value of 'Critical points' in parameter files. */
    const std::string &
    critical_points_name() const;

    void
    add_parameters(EntryDeclarations &prm);

    /** Throws InputError if a value is invalid. */
    void
    check(const std::string &section) const;

    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &n_modes &n_buckling &critical_points &branch_amplitude;
    }
  };
} // namespace Biface

#endif
