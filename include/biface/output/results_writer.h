// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_output_results_writer_h
#define biface_output_results_writer_h

#include <deal.II/base/parameter_handler.h>

#include <string>
#include <utility>
#include <vector>

#include <biface/model/shell_equations.h>
#include <biface/model/state.h>
#include <biface/output/ply_results.h>
#include <biface/solver/load_stepping.h>

namespace Biface
{
  /**
   * Writes the files of the output directory, see doc/output.md. All functions
   * must be called on all ranks.
   */
  class ResultsWriter
  {
  public:
    struct Parameters
    {
      std::string     directory      = "output";
      double          profile        = 0;
      bool            vtu            = true;
      bool            ply_vtu        = false;
      unsigned int    points_per_ply = 3;
      FailureCriteria criteria;

      void
      add_parameters(dealii::ParameterHandler &prm);
    };

    /**
     * Make the directory, if need be, and begin history.csv. Throws
     * InputError where that is not possible.
     */
    ResultsWriter(const Parameters     &parameters,
                  const ShellEquations &equations);

    /** What is asked for and cannot be given: a sentence each. */
    std::vector<std::string>
    warnings() const;

    /** Write the parameters as used. */
    void
    write_parameters(const dealii::ParameterHandler &prm) const;

    /** Write everything about a converged step. */
    void
    write_step(const StepReport &report, const State &state);

  private:
    void
    append_history(const StepReport &report) const;

    /** Displacements of the named points. */
    void
    append_probes(const StepReport &report, const State &state) const;

    void
    write_contact(const StepReport &report, const State &state) const;

    void
    write_profile(const StepReport &report, const State &state) const;

    /** Strains and stresses in the plies at the named points. */
    void
    write_plies(const StepReport &report, const State &state) const;

    /** A series of VTU files, one a step, and the file that lists them. */
    struct Series
    {
      std::string name;
      /** Steps and files so far. */
      std::vector<std::pair<double, std::string>> times_and_names = {};
    };

    template <typename Patches>
    void
    write_vtu(const StepReport &report, Patches &patches, Series &series);

    std::string
    path(const std::string &name) const;

    const Parameters      parameters;
    const ShellEquations &equations;

    Series faces{"shell"};
    Series plies{"plies"};
  };
} // namespace Biface

#endif
