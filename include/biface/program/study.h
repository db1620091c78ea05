// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_program_study_h
#define biface_program_study_h

#include <deal.II/base/conditional_ostream.h>
#include <deal.II/base/parameter_handler.h>

#include <mpi.h>

#include <iosfwd>
#include <string>
#include <vector>

#include <biface/program/command_line.h>
#include <biface/program/parameters.h>
#include <biface/program/program.h>
#include <biface/program/sampling.h>

namespace Biface
{
  /** The parameters of a study: many analyses of one parameter file, in which
   * design variables take other values. */
  struct StudyParameters
  {
    /** A result, see ScalarResults, at the end of the run or of a stage. */
    struct Output
    {
      std::string result;
      /** Empty for the end of the run. */
      std::string stage;

      /** The column of study.csv. */
      std::string
      name() const
      {
        return result + (stage.empty() ? "" : " @ " + stage);
      }
    };

    std::string           base_file;
    std::string           directory  = "study";
    unsigned int          group_size = 1;
    bool                  warm_start = true;
    std::vector<Override> settings;
    std::vector<Output>   outputs;
    Sampling              sampling;

    void
    add_parameters(dealii::ParameterHandler &prm);
  };


  /**
   * Run the study that the command line names, or check it.
   *
   * The ranks are divided into groups. Each group takes the next sample when it
   * is free and runs it in a directory of its own, `sample-0001`, ...; its last
   * file is `sample.csv`, a line of the table. The first rank of all collects
   * these lines in `study.csv`. A sample that fails is a line that says so.
   *
   * Must be called on all ranks. Throws InputError if the study is invalid, and
   * OutputError if its results cannot be written.
   * @param screen receives the progress.
   * @param err receives the reason of an early end.
   */
  ExitCode
  run_study(const CommandLine          &command_line,
            const MPI_Comm              communicator,
            std::ostream               &screen,
            dealii::ConditionalOStream &err);
} // namespace Biface

#endif
