// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_program_program_h
#define biface_program_program_h

#include <mpi.h>

#include <iosfwd>
#include <string>
#include <vector>

namespace Biface
{
  /** The exit codes of the program `biface`. */
  enum ExitCode : int
  {
    done           = 0,
    wrong_input    = 1,
    no_convergence = 2,
    /** Or results cannot be written; converged steps are kept. */
    internal_error = 3,
    /** Stopped by SIGINT or SIGTERM; converged steps are kept. The numbers are
     * those of shells for processes ended by these signals. */
    interrupted = 130,
    terminated  = 143
  };

  /**
   * The program `biface`, without the set-up of MPI.
   *
   * @param arguments the command line, without the name of the program.
   * @param communicator the ranks.
   * @param out stream to which the first rank prints its progress.
   * @param err stream to which the first rank prints errors.
   *
   * Invalid input is detected on all ranks and reported by the first. Other
   * exceptions are passed to the caller.
   */
  ExitCode
  run_program(const std::vector<std::string> &arguments,
              const MPI_Comm                  communicator,
              std::ostream                   &out,
              std::ostream                   &err);
} // namespace Biface

#endif
