// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_output_scalar_results_h
#define biface_output_scalar_results_h

#include <deal.II/base/point.h>

#include <optional>
#include <string>
#include <vector>

#include <biface/model/forces/cavity.h>
#include <biface/output/history_file.h>
#include <biface/output/ply_results.h>
#include <biface/stepping/stage.h>
#include <biface/stepping/step_report.h>

namespace Biface
{
  /**
   * Single numbers of the results by their names:
   * - a column of history.csv, such as `force`;
   * - a column of probes.csv at a named point, such as `top u_x`, of the middle
   *   surface unless the face is given, as in `top inner u_x`;
   * - a column of forces.csv of a body, such as `alpha_1 min F_x`;
   * - the frequency of a mode, such as `frequency 1`;
   * - the factor of buckling.csv of a shape, such as `buckling factor 1`.
   */
  class ScalarResults
  {
  public:
    /** What is known besides the results of every run. */
    struct Known
    {
      /** The volume of the cavity. */
      bool volume = false;
      /** The number of modes, and that of buckling shapes. */
      unsigned int n_modes = 0, n_buckling = 0;

      /** What is known at the ends of all of some stages.
       * @param cavity null if its volume is not of interest. */
      static Known
      at_ends(const Cavity *cavity, const std::vector<Stage> &stages);
    };

    /** Which columns of history.csv count. */
    enum class Columns
    {
      all,
      /** The differentiable ones: neither works, which are sums over all steps,
       * nor counts, nor positions. */
      differentiable
    };

    /** Throws InputError if there is no such number.
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

    /** Whether there is a frequency among them. */
    bool
    have_frequency() const
    {
      return have(Source::Kind::frequency);
    }

    /** Whether there is a buckling factor among them. */
    bool
    have_buckling() const
    {
      return have(Source::Kind::buckling);
    }

    /** Whether there is a force of a body among them. */
    bool
    have_force() const
    {
      return have(Source::Kind::force);
    }

    /** The values of a step. Must be called on all ranks.
     * @param cavity null if its volume is not of interest. */
    std::vector<double>
    evaluate(const ShellEquations &equations,
             const Cavity         *cavity,
             const StepReport     &report,
             const State          &state) const;

  private:
    /** Where a number is found. */
    struct Source
    {
      enum class Kind
      {
        history,
        probe,
        force,
        frequency,
        buckling
      };

      Kind kind = Kind::history;
      /** The number of the group of columns of history.csv, of the point, the
       * body or the shape. */
      unsigned int position = 0;
      /** Position in the group, or among the components of the last columns of
       * probes.csv or forces.csv. */
      unsigned int component = 0;
      /** The share of the inner face. */
      double inner = 0.5;
    };

    bool
    have(const Source::Kind kind) const;

    /** Whether a column of history.csv counts. */
    bool
    counts(const std::string &column) const;

    /** The source of a name; none if there is no such number. */
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
