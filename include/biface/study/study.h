// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_study_study_h
#define biface_study_study_h

#include <deal.II/base/conditional_ostream.h>

#include <mpi.h>

#include <iosfwd>
#include <string>
#include <vector>

#include <biface/analysis/exit_code.h>
#include <biface/problem/override.h>

namespace Biface
{
  /** How to run a study, besides its file. */
  struct StudyOptions
  {
    std::string file_name;
    /** Changes of entries of the section 'Study', and of the base file. */
    std::vector<Override> overrides;
    /** The directory of the results; empty for that of the file. */
    std::string output;
    /** Whether to continue the study in this directory. */
    bool restart = false;
    /** Whether only to set up the study. */
    bool check_only = false;
    /** Whether to print only errors to the screen. */
    bool quiet = false;
  };


  /** Print the entries of a study, with their defaults, to @p screen.
   * @param json as JSON, otherwise as a parameter file. */
  void
  print_study_parameters(const bool json, std::ostream &screen);


  /**
   * Run a study, or check it.
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
  run_study(const StudyOptions         &options,
            const MPI_Comm              communicator,
            std::ostream               &screen,
            dealii::ConditionalOStream &err);
} // namespace Biface

#endif
