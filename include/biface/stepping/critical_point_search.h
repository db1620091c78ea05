// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_stepping_critical_point_search_h
#define biface_stepping_critical_point_search_h

#include <deal.II/base/conditional_ostream.h>

#include <functional>
#include <memory>
#include <optional>

#include <biface/solver/buckling_analysis.h>
#include <biface/stepping/attempt.h>
#include <biface/stepping/critical_point.h>

namespace Biface
{
  struct ControlTrial;


  /** Finds the critical points that a step passes, by the numbers of negative
   * pivots of the tangent at its start and end, see CriticalPoints. */
  class CriticalPointSearch
  {
  public:
    /** The objects are kept by reference. */
    CriticalPointSearch(BucklingAnalysis           &buckling_analysis,
                        dealii::ConditionalOStream &out)
      : buckling_analysis(buckling_analysis), out(out)
    {}

    /** The numbers of negative pivots at the start and at the end of a step, if
     * they are known. */
    struct PivotCounts
    {
      std::optional<unsigned int> before, after;

      /** Whether there is a critical point between them. */
      bool
      differ() const
      {
        return before && after && *before != *after;
      }
    };

    /** The numbers of negative pivots before and after a converged attempt,
     * which belong to equilibria if they differ. If they agree, the second may
     * be that of an iterate close to the equilibrium, unless the stage locates
     * critical points. */
    PivotCounts
    count(const StageRun &run, const Attempt &attempt);

    /**
     * Shorten a step in which the number of negative pivots changes to end
     * where it does.
     *
     * @param attempt_step attempts a step proposed by the control.
     * @param trial, attempt, n_negative those of the whole step, then those of
     * the shortened one, or the attempt that was stopped.
     * @return the part of the step that is left.
     */
    double
    bisect(const StageRun                                     &run,
           const std::function<Attempt(const ControlTrial &)> &attempt_step,
           ControlTrial                                       &trial,
           Attempt                                            &attempt,
           PivotCounts                                        &n_negative);

    /** Describe and print the critical point of the last step, and note a
     * branch that the next one is to take.
     * @return null if its shape was not found. */
    std::shared_ptr<const CriticalPoint>
    describe(const StageRun    &run,
             const LoadLevel   &level_before,
             const PivotCounts &n_negative,
             const bool         located);

  private:
    /** Whether the negative pivots after an attempt are to be counted for the
     * symmetric part of a tangent that loads make unsymmetric, which Newton's
     * method does not do. */
    bool
    counts_symmetric_part(const StageRun &run, const Attempt &attempt) const;

    /** Whether the shell is so thin that factors in single precision may have
     * another number of negative pivots than the tangent. */
    bool
    is_too_thin(const StageRun &run, const Attempt &attempt) const;

    /** The number of negative pivots of an equilibrium with the loads of a
     * stage, in double precision; warns once if it cannot be counted.
     * @param often see LinearSolver::count_negative_pivots(). */
    std::optional<unsigned int>
    count(const StageRun  &run,
          const State     &state,
          const LoadLevel &level,
          const bool       often);

    /** Warn once of a tangent whose negative pivots are not counted. */
    void
    warn_of_uncounted_pivots(const StageRun &run);

    BucklingAnalysis           &buckling_analysis;
    dealii::ConditionalOStream &out;
    bool                        has_warned = false;
  };
} // namespace Biface

#endif
