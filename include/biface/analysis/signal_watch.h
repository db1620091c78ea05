// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_analysis_signal_watch_h
#define biface_analysis_signal_watch_h

#include <mpi.h>

#include <array>

#include <signal.h>

namespace Biface
{
  /**
   * During the life of an object, SIGTERM and SIGINT are recorded instead of
   * ending the process, and exceeding the file size limit is a write error
   * instead of ending the process (SIGXFSZ). The second of these signals, also
   * one of the other kind, ends the process at once, for example where it
   * hangs. Signals belong to the process: only one object at a time.
   */
  class SignalWatch
  {
  public:
    SignalWatch();

    /** Restore the previous handlers. */
    ~SignalWatch();

    SignalWatch(const SignalWatch &) = delete;
    SignalWatch &
    operator=(const SignalWatch &) = delete;

    /** The signal received by any rank, or 0: the same on all ranks, all of
     * which must call this. */
    int
    caught(const MPI_Comm communicator) const;

  private:
    /** The previous handlers of SIGTERM, SIGINT and SIGXFSZ. */
    std::array<struct sigaction, 3> before;
  };


  /** The name of a signal, "SIGTERM" or "SIGINT". */
  const char *
  signal_name(const int signal);
} // namespace Biface

#endif
