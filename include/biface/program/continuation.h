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
  /**
   * Check that a run can go on with changed parameters: those that describe the
   * shell, its loads, and the stages that are done must be the same, see
   * doc/restart.md. Numbers may be written in another way.
   *
   * Throws InputError that names the entry and both values.
   *
   * @param before, now all entries as the text of a parameter file.
   * @param files_before, files_now see Parameters::named_pairs(); the names of
   * files do not matter, their contents do.
   * @param progress of the run.
   */
  void
  check_continuation(const std::string  &before,
                     const std::string  &now,
                     const PairsByEntry &files_before,
                     const PairsByEntry &files_now,
                     const Progress     &progress);
} // namespace Biface

#endif
