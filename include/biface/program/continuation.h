// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_program_continuation_h
#define biface_program_continuation_h

#include <mpi.h>

#include <map>
#include <string>

#include <biface/program/parameters.h>
#include <biface/stepping/progress.h>

namespace Biface
{
  /** The contents of the files that parameters name, by what they are for. Must
   * be called on all ranks. Throws InputError where one cannot be read. */
  std::map<std::string, std::string>
  read_named_files(const Parameters &parameters, const MPI_Comm communicator);


  /**
   * Check that a run can go on with changed parameters: those that describe the
   * shell, its loads, and the stages that are done must be the same, see
   * doc/restart.md. Numbers may be written in another way.
   *
   * Throws InputError that names the entry and both values.
   *
   * @param before, now all entries as the text of a parameter file.
   * @param files_before, files_now see read_named_files(); the names of files
   * do not matter, their contents do.
   * @param progress of the run.
   */
  void
  check_continuation(const std::string                        &before,
                     const std::string                        &now,
                     const std::map<std::string, std::string> &files_before,
                     const std::map<std::string, std::string> &files_now,
                     const Progress                           &progress);
} // namespace Biface

#endif
