// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_output_results_writer_h
#define biface_output_results_writer_h

#include <deal.II/base/parameter_handler.h>

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <biface/output/plies_file.h>
#include <biface/output/plies_vtu.h>
#include <biface/output/profile_file.h>
#include <biface/output/result_file.h>
#include <biface/output/shell_vtu.h>

namespace Biface
{
  /**
   * The list of the files of results, see doc/output.md. All functions must be
   * called on all ranks.
   */
  class ResultsWriter
  {
  public:
    struct Parameters
    {
      std::string             directory = "output";
      ProfileFile::Parameters profile;
      ShellVtu::Parameters    shell_vtu;
      PliesVtu::Parameters    plies_vtu;
      PliesFile::Parameters   plies;
      FailureCriteria         criteria;

      void
      add_parameters(dealii::ParameterHandler &prm);
    };

    /** The steps that each file holds, by ResultFile::name. */
    using Written = std::map<std::string, std::vector<unsigned int>>;

    /**
     * Make the directory, if need be, and start the files. Throws InputError
     * where that is not possible.
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

    /** The names of the files, with what they are for. */
    std::vector<std::string>
    list() const;

    /** Write the parameters as used. A comment in the first line names the
     * program's version and the file that they were read from.
     * @param text of a parameter file. */
    void
    write_parameters(const std::string &text, const std::string &file_name);

    /** Write everything about a converged step. Throws OutputError. */
    void
    write_step(const StepReport &report, const State &state);

    /** Bring all that was written to the disk. Throws OutputError. */
    void
    sync()
    {
      directory.sync();
    }

    Written
    get_written() const;

  private:
    ResultsDirectory directory;
    /** In the order of list(). */
    std::vector<std::unique_ptr<ResultFile>> files;
  };
} // namespace Biface

#endif
