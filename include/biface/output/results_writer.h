// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_output_results_writer_h
#define biface_output_results_writer_h

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <biface/output/forces_file.h>
#include <biface/output/history_file.h>
#include <biface/output/plies_file.h>
#include <biface/output/plies_vtu.h>
#include <biface/output/profile_file.h>
#include <biface/output/result_file.h>
#include <biface/output/shell_vtu.h>

namespace Biface
{
  class EntryDeclarations;
  struct Stage;


  /**
   * The list of the files of results, see doc/output.md. All functions must be
   * called on all ranks.
   */
  class ResultsWriter
  {
  public:
    struct Parameters
    {
      std::string directory = "output";
      /** Steps between those whose series of files are written, beside the last
       * steps of the stages. */
      unsigned int            every = 1;
      ForcesFile::Parameters  forces;
      ProfileFile::Parameters profile;
      ShellVtu::Parameters    shell_vtu;
      PliesVtu::Parameters    plies_vtu;
      PliesFile::Parameters   plies;
      FailureCriteria         criteria;

      void
      add_parameters(EntryDeclarations &prm);
    };

    /** The steps in each file, by ResultFile::name. */
    using Written = std::map<std::string, std::vector<unsigned int>>;

    /**
     * Start the files. Those of an earlier run are removed. Throws OutputError
     * if that fails.
     *
     * @param directory kept by reference.
     * @param stages those of the run.
     * @param cavity that whose volume is of interest, kept by pointer, or null.
     * @param n_sensitivities the number of derivatives at the end of a stage.
     * @param continued the steps written by an earlier run, to continue its
     * files; later ones are removed. Throws InputError if some of them are
     * missing.
     */
    ResultsWriter(const Parameters             &parameters,
                  ResultsDirectory             &directory,
                  const std::vector<Stage>     &stages,
                  const ShellEquations         &equations,
                  const Cavity                 *cavity,
                  const unsigned int            n_sensitivities,
                  const std::optional<Written> &continued = {});

    /** A sentence for each requested result that is not available. */
    std::vector<std::string>
    warnings() const;

    /** The names and purposes of the files. */
    std::vector<std::string>
    list() const;

    /** Write the parameters as used. A comment in the first line gives the
     * version of the program and the file that was read.
     * @param text the text of a parameter file. */
    void
    write_parameters(const std::string &text, const std::string &file_name);

    /** Write all results of a converged step. Throws OutputError. */
    void
    write_step(const StepReport &report, const State &state);

    /** The maxima of the failure indices in the last step written. */
    const std::vector<FailureMaximum> &
    get_failure_maxima() const
    {
      return history->get_failure_maxima();
    }

    /** Flush all files to the disk. Throws OutputError. */
    void
    sync()
    {
      directory.sync();
    }

    Written
    get_written() const;

  private:
    const unsigned int every;
    ResultsDirectory  &directory;
    /** The files, in the order of list(). */
    std::vector<std::unique_ptr<ResultFile>> files;
    /** The file history.csv, one of the files. */
    const HistoryFile *history;
  };
} // namespace Biface

#endif
