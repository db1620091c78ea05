// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_program_program_h
#define biface_program_program_h

#include <mpi.h>

#include <iosfwd>

namespace Biface
{
  /** What the program `biface` returns to its caller. */
  enum ExitCode : int
  {
    done           = 0,
    wrong_input    = 1,
    no_convergence = 2,
    /** Or results cannot be written; what was reached is kept. */
    internal_error = 3,
    /** Stopped by SIGINT or SIGTERM; what was reached is kept. The numbers are
     * those a shell gives to processes that end by these signals. */
    interrupted = 130,
    terminated  = 143
  };

  /**
   * The program `biface`, without the set-up of MPI.
   *
   * @param argc, argv the command line.
   * @param communicator the ranks.
   * @param out where the first rank prints its progress.
   * @param err where the first rank prints what went wrong.
   *
   * Wrong input is found on all ranks alike and answered on the first. Other
   * exceptions are left to the caller.
   */
  ExitCode
  run_program(int            argc,
              char         **argv,
              const MPI_Comm communicator,
              std::ostream  &out,
              std::ostream  &err);
} // namespace Biface

#endif
