// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_output_results_writer_h
#define biface_output_results_writer_h

#include <deal.II/base/parameter_handler.h>

#include <optional>
#include <set>
#include <string>
#include <vector>

#include <biface/model/shell_equations.h>
#include <biface/model/state.h>
#include <biface/output/ply_results.h>
#include <biface/stepping/load_stepping.h>

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

    /** What was written so far. */
    struct Written
    {
      /** The last step, and those of which there are VTU files. */
      unsigned int              n_steps = 0;
      std::vector<unsigned int> faces, plies;

      template <class Archive>
      void
      serialize(Archive &archive, const unsigned int)
      {
        archive &n_steps &faces &plies;
      }
    };

    /**
     * Make the directory, if need be, and begin history.csv. Throws
     * InputError where that is not possible.
     *
     * @param continued what an earlier run has written, to continue its files:
     * what they hold beyond is cut off. Throws InputError where they hold less.
     */
    ResultsWriter(const Parameters             &parameters,
                  const ShellEquations         &equations,
                  const std::optional<Written> &continued = {});

    /** What is asked for and cannot be given: a sentence each. */
    std::vector<std::string>
    warnings() const;

    /** Write the parameters as used. A comment in the first line names the
     * program's version and the file that they were read from.
     * @param text of a parameter file. */
    void
    write_parameters(const std::string &text,
                     const std::string &file_name) const;

    /** Write everything about a converged step. Throws OutputError. */
    void
    write_step(const StepReport &report, const State &state);

    /** Bring all that was written to the disk. Throws OutputError. */
    void
    sync();

    const Written &
    get_written() const
    {
      return written;
    }

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

    /** One of a series of VTU files. */
    template <typename Patches>
    void
    write_vtu(const StepReport          &report,
              Patches                   &patches,
              const std::string         &series,
              std::vector<unsigned int> &steps);

    /** The file that lists the VTU files of a series. */
    void
    write_pvd(const std::string               &series,
              const std::vector<unsigned int> &steps) const;

    /** @param name of a file of the directory, which is about to be written.
     */
    std::string
    path(const std::string &name) const;

    const Parameters      parameters;
    const ShellEquations &equations;

    Written written;
    /** Files that may not have reached the disk. */
    mutable std::set<std::string> unsynced;
  };
} // namespace Biface

#endif
