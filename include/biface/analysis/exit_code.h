// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_analysis_exit_code_h
#define biface_analysis_exit_code_h

namespace Biface
{
  /** The exit codes of the program `biface`. */
  enum ExitCode : int
  {
    done           = 0,
    wrong_input    = 1,
    no_convergence = 2,
    /** An error of the program, or results that cannot be written; converged
     * steps are kept. */
    internal_error = 3,
    /** The end by SIGINT or by SIGTERM; converged steps are kept. The numbers
     * are those of shells for processes ended by these signals. */
    interrupted = 130,
    terminated  = 143
  };
} // namespace Biface

#endif
