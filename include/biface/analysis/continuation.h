// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_analysis_continuation_h
#define biface_analysis_continuation_h

#include <mpi.h>

#include <string>

#include <biface/input/entry_declarations.h>
#include <biface/input/pairs_file.h>
#include <biface/stepping/progress.h>

namespace Biface
{
  /**
   * Check that a run can be continued with changed parameters: those of the
   * shell, its loads, and the completed stages must be unchanged, see
   * doc/restart.md. Numbers may be written differently.
   *
   * Throws InputError that names the entry and both values.
   *
   * @param before, now all entries as the text of a parameter file.
   * @param attributes those of the entries of @p now, which say when each may
   * change.
   * @param files_before, files_now see Parameters::named_pairs(); only the
   * contents of files matter, not their names.
   * @param progress the progress of the run.
   */
  void
  check_continuation(const std::string       &before,
                     const std::string       &now,
                     const AttributesByEntry &attributes,
                     const PairsByEntry      &files_before,
                     const PairsByEntry      &files_now,
                     const Progress          &progress);
} // namespace Biface

#endif
