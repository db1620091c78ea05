// SPDX-License-Identifier: LGPL-2.1-or-later

#include <algorithm>
#include <limits>

#include <biface/model/contact/contact_interaction.h>
#include <biface/model/contact/contact_pair.h>
#include <biface/model/forces/viscous_damping.h>
#include <biface/model/state/loads.h>
#include <biface/stepping/critical_point_search.h>
#include <biface/stepping/stage_run.h>

namespace Biface
{
  using namespace dealii;

  CriticalPointSearch::PivotCounts
  CriticalPointSearch::count(const StageRun &run, const Attempt &attempt)
  {
    // the pivots of the matrix say nothing with dashpots or inertia in it,
    // without the
    // term of rank one of a gas, or with the stresses at the start of a linear
    // stage
    PivotCounts n;
    if (run.stage.critical_points == CriticalPoints::ignore ||
        run.stage.damping > 0 || run.stage.inertia || run.stage.sealed ||
        run.stage.theory == StrainTheory::linear)
      return n;
    n.before              = run.progress.n_negative_pivots;
    n.after               = attempt.result.n_negative_pivots;
    const bool every_step = run.stage.locates_critical_points() ||
                            counts_symmetric_part(run, attempt) ||
                            is_too_thin(run, attempt);
    if (every_step)
      n.after = count(run, attempt.state, attempt.level, every_step);
    if (!n.after)
      {
        if (attempt.result.iterations > 0)
          warn_of_uncounted_pivots(run);
        return n;
      }
    // dashpots or inertia of the stage before hold the state before
    if (ViscousDamping::is_active(run.state) || run.starts_from_motion())
      {
        n.before.reset();
        return n;
      }
    // The stage before may not have counted them, or had another ground;
    // numbers that differ are counted in double precision.
    const bool same_without_contact = run.stage.contact &&
                                      run.contact.pairs.size() == 1 &&
                                      run.contact.count_active(run.state) == 0;
    const bool other_tangent =
      run.control->done() == 0 && !same_without_contact;
    if (!n.before || (n.differ() && other_tangent))
      n.before = count(run, run.state, run.progress.reached, every_step);
    if (n.differ() && !every_step)
      n.after = count(run, attempt.state, attempt.level, every_step);
    return n;
  }


  bool
  CriticalPointSearch::counts_symmetric_part(const StageRun &run,
                                             const Attempt  &attempt) const
  {
    const Loads loads = run.loads_at(attempt.level);
    return !attempt.result.n_negative_pivots && attempt.result.iterations > 0 &&
           !has_warned && !run.equations.is_symmetric(loads) &&
           run.equations.is_symmetric_but_for_loads(loads);
  }


  bool
  CriticalPointSearch::is_too_thin(const StageRun &run,
                                   const Attempt  &attempt) const
  {
    // the ratio of bending to membrane stiffness in digits of single precision
    constexpr double digits = 10;
    const double     ratio =
      run.equations.mesh.size() / run.equations.mesh.thickness();
    return !attempt.result.exact_pivots() && attempt.result.n_negative_pivots &&
           ratio * ratio * std::numeric_limits<float>::epsilon() > digits;
  }


  std::optional<unsigned int>
  CriticalPointSearch::count(const StageRun  &run,
                             const State     &state,
                             const LoadLevel &level,
                             const bool       often)
  {
    const auto n = buckling_analysis.count_negative_pivots(
      {state, run.loads_at(level)}, often);
    if (!n)
      warn_of_uncounted_pivots(run);
    return n;
  }


  void
  CriticalPointSearch::warn_of_uncounted_pivots(const StageRun &run)
  {
    // 'report' leaves them out where friction or rolling is the cause
    const bool left_out = !run.stage.locates_critical_points() &&
                          (run.rolls || run.equations.has_unsymmetric_contact(
                                          run.loads_at(run.progress.reached)));
    if (has_warned || left_out)
      return;
    out << "  Warning: critical points of " << run.stage.name
        << " cannot be found: the tangent is not symmetric, as with "
           "'Thickness law = asymmetric', or the linear solver does not count "
           "negative pivots"
        << std::endl;
    has_warned = true;
  }


  double
  CriticalPointSearch::bisect(
    const StageRun                                       &run,
    const std::function<Attempt(const Control::Trial &)> &attempt_step,
    Control::Trial                                       &trial,
    Attempt                                              &attempt,
    PivotCounts                                          &n_negative)
  {
    // parts of the loads and, since these are stationary at a limit point, of
    // the step
    constexpr double       tolerance = 1e-3, maximum_part = 0.05;
    constexpr unsigned int max_bisections = 40;

    LoadLevel level_before = run.progress.reached;
    double    low = 0, high = 1, taken = 1;
    for (unsigned int i = 0; i < max_bisections; ++i)
      {
        if (relative_change(level_before, attempt.level) <= tolerance &&
            high - low <= maximum_part)
          break;
        // by the size of the step, whatever its control prescribes
        const double middle = (low + high) / 2;
        // the size at hand is that of the bisection before
        run.control->scale_step(middle / taken);
        taken                      = middle;
        const Control::Trial other = run.control->propose(run.last_converged());
        out << "  bisection for a critical point" << std::endl;
        Attempt half = attempt_step(other);
        if (half.result.stopped)
          {
            attempt = half;
            return high;
          }
        half.result.iterations += attempt.result.iterations;
        const std::optional<unsigned int> n =
          (half.result.converged ? count(run, half.state, half.level, true)
                                 : std::nullopt);
        // the far side as it is ends the step: it is an equilibrium, too
        if (!n)
          {
            attempt.result.iterations = half.result.iterations;
            break;
          }
        // the step ends on the far side, where the critical eigenvalue has its
        // new sign
        if (n == n_negative.before)
          {
            low                       = middle;
            level_before              = half.level;
            attempt.result.iterations = half.result.iterations;
          }
        else
          {
            high             = middle;
            trial            = other;
            attempt          = half;
            n_negative.after = n;
          }
      }
    run.control->scale_step(high / taken);
    return high;
  }


  std::shared_ptr<const CriticalPoint>
  CriticalPointSearch::describe(const StageRun    &run,
                                const LoadLevel   &level_before,
                                const PivotCounts &n_negative,
                                const bool         located)
  {
    const unsigned int n_before = *n_negative.before,
                       n_after  = *n_negative.after;
    out << "  negative pivots: " << n_after << " after " << n_before;
    const LoadLevel   &level = run.progress.reached;
    const unsigned int n_changed =
      std::max(n_after, n_before) - std::min(n_after, n_before);
    // more at once than eigenvalues are computed, as where cells get too small:
    // their shapes have nothing in common
    const bool several = !located && n_changed > BucklingAnalysis::n_candidates;
    const auto critical =
      (several
         ? std::nullopt
         : buckling_analysis.critical_mode({run.state, run.loads_at(level)},
                                           change_of(level_before, level),
                                           n_after > n_before));
    if (critical && !critical->is_of_tangent)
      {
        out << " of the symmetric part of the tangent, which itself is not "
               "singular: the loads have no potential, and this is no critical "
               "point"
            << std::endl;
        return nullptr;
      }
    if (!critical)
      {
        out << (several ? ", the step passed several critical points" : "")
            << std::endl;
        return nullptr;
      }

    auto point               = std::make_shared<CriticalPoint>();
    point->n_negative_before = n_before;
    point->n_negative_after  = n_after;
    point->located           = located;
    point->mode              = critical->mode;
    const LoadLevel &start   = run.progress.control.start;
    point->loads = {load_fraction(start, level, run.stage.end(start)), level};
    out << ", " << (located ? "here is a " : "the step passed a ")
        << point->kind() << std::endl;
    if (run.stage.critical_points == CriticalPoints::switch_branch &&
        !point->is_limit_point())
      // the next step, which tests this, attempts the branch
      run.progress.branch = owned_part(point->mode.shape);
    return point;
  }
} // namespace Biface
