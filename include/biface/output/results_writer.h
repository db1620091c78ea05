// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_output_results_writer_h
#define biface_output_results_writer_h

#include <deal.II/base/parameter_handler.h>

#include <string>
#include <utility>
#include <vector>

#include <biface/model/shell_equations.h>
#include <biface/model/state.h>
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
      std::string directory = "output";
      double      profile   = 0;
      bool        vtu       = true;

      void
      add_parameters(dealii::ParameterHandler &prm);
    };

    /**
     * Make the directory, if need be, and begin history.csv. Throws
     * InputError where that is not possible.
     */
    ResultsWriter(const Parameters     &parameters,
                  const ShellEquations &equations);

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

    void
    write_vtu(const StepReport &report, const State &state);

    std::string
    path(const std::string &name) const;

    const Parameters      parameters;
    const ShellEquations &equations;

    /** Steps and files of shell.pvd. */
    std::vector<std::pair<double, std::string>> times_and_names;
  };
} // namespace Biface

#endif
