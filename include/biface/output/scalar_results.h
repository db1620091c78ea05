// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_output_scalar_results_h
#define biface_output_scalar_results_h

#include <deal.II/base/point.h>

#include <optional>
#include <string>
#include <vector>

#include <biface/model/forces/cavity.h>
#include <biface/output/history_file.h>
#include <biface/output/requested_criteria.h>
#include <biface/stepping/step_report.h>

namespace Biface
{
  struct Stage;


  /**
   * Single numbers of the results by their names:
   * - a column of history.csv, such as `force`;
   * - a column of probes.csv at a named point, such as `top u_x`, of the middle
   *   surface unless the face is given, as in `top inner u_x`;
   * - a column of forces.csv of a body, such as `alpha_1 min F_x`;
   * - the stiffness of a body or support that moves, `BODY tangent` and
   *   `BODY secant`, see StiffnessOfMotion, with the name `foundation` of the
   *   ground; of a support with several motions the name of the motion;
   * - the frequency of a mode, such as `frequency 1`;
   * - the factor of buckling.csv of a shape, such as `buckling factor 1`.
   */
  class ScalarResults
  {
  public:
    /** What a run computes besides the results of every run. */
    struct Known
    {
      /** Whether the volume of the cavity is computed. */
      bool volume = false;
      /** The numbers of modes of vibration and of buckling shapes. */
      unsigned int n_modes = 0, n_buckling = 0;

      /** The results that are known at the end of each of some stages.
       * @param cavity null if its volume is not of interest. */
      static Known
      at_ends(const Cavity *cavity, const std::vector<Stage> &stages);
    };

    /** Which columns of history.csv can be named. */
    enum class Columns
    {
      all,
      /** The differentiable columns: neither works, which are sums over all
       * steps, nor counts, nor positions. */
      differentiable
    };

    /** Find the results by their names. Throws InputError if there is no such
     * result.
     * @param entry the entry that lists the names, for error messages. */
    ScalarResults(const std::string              &entry,
                  const std::vector<std::string> &names,
                  const ShellEquations           &equations,
                  const FailureCriteria          &criteria,
                  const dealii::Point<3>         &moment_center,
                  const Known                    &known,
                  const Columns                   columns);

    const std::vector<std::string> &
    get_names() const
    {
      return names;
    }

    /** Whether a frequency is among the results. */
    bool
    have_frequency() const
    {
      return have(Source::Kind::frequency);
    }

    /** Whether a buckling factor is among the results. */
    bool
    have_buckling() const
    {
      return have(Source::Kind::buckling);
    }

    /** Whether a stiffness is among the results. */
    bool
    have_stiffness() const
    {
      return have(Source::Kind::stiffness);
    }

    /** Whether a force of a body is among the results, or one that follows
     * from it. */
    bool
    have_force() const;

    /** The values of the results in a step. Must be called on all ranks.
     * @param cavity null if its volume is not of interest. */
    std::vector<double>
    evaluate(const ShellEquations &equations,
             const Cavity         *cavity,
             const StepReport     &report,
             const State          &state) const;

  private:
    /** The place where a result is found. */
    struct Source
    {
      enum class Kind
      {
        history,
        probe,
        force,
        stiffness,
        frequency,
        buckling
      };

      Kind kind = Kind::history;
      /** The number of the group of columns of history.csv, of the point, the
       * body or the shape. */
      unsigned int position = 0;
      /** What moves against the stiffness. */
      std::string name;
      /** The position in the group, or among the components of the last columns
       * of probes.csv or forces.csv; of a stiffness 0 for the tangent, 1 for
       * the secant. */
      unsigned int component = 0;
      /** The weight of the inner face in a displacement: 0 or 1 for one of the
       * faces, 0.5 for the middle surface. */
      double inner = 0.5;
    };

    bool
    have(const Source::Kind kind) const;

    /** Whether a column of history.csv can be named. */
    bool
    counts(const std::string &column) const;

    /** The source of a result; none if there is no result of this name. */
    std::optional<Source>
    find(const std::string    &name,
         const ShellEquations &equations,
         const Known          &known) const;

    const std::vector<std::string>  names;
    const FailureCriteria           criteria;
    const dealii::Point<3>          moment_center;
    const Columns                   columns;
    const std::vector<HistoryGroup> history;
    std::vector<Source>             sources;
  };
} // namespace Biface

#endif
