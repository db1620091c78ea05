// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_program_program_h
#define biface_program_program_h

#include <mpi.h>

#include <iosfwd>
#include <string>
#include <vector>

#include <biface/analysis/exit_code.h>

namespace Biface
{
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
