// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_program_signal_watch_h
#define biface_program_signal_watch_h

#include <mpi.h>

#include <array>

#include <signal.h>

namespace Biface
{
  /**
   * While an object of this class lives, SIGTERM and SIGINT no longer end the
   * process but are noted, and a file that grows beyond the limit of the
   * process is an error of writing instead of the end (SIGXFSZ). A second
   * signal of a kind does what it did before. One object at a time: signals
   * belong to the process.
   */
  class SignalWatch
  {
  public:
    SignalWatch();

    /** What signals did before, they do again. */
    ~SignalWatch();

    SignalWatch(const SignalWatch &) = delete;
    SignalWatch &
    operator=(const SignalWatch &) = delete;

    /** The signal that came to any of the ranks, or 0. Must be called on all
     * ranks, which get the same answer. */
    int
    caught(const MPI_Comm communicator) const;

  private:
    /** What SIGTERM, SIGINT and SIGXFSZ did before. */
    std::array<struct sigaction, 3> before;
  };


  /** "SIGTERM", "SIGINT". */
  const char *
  signal_name(const int signal);
} // namespace Biface

#endif
