// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_program_study_h
#define biface_program_study_h

#include <deal.II/base/conditional_ostream.h>

#include <mpi.h>

#include <iosfwd>

#include <biface/program/command_line.h>
#include <biface/program/exit_code.h>

namespace Biface
{
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
