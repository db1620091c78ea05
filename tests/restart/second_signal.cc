// SPDX-License-Identifier: LGPL-2.1-or-later

// The first signal is only recorded; the second one ends the process, also if
// it is of the other kind.

#include <csignal>
#include <iostream>

#include <biface/analysis/signal_watch.h>

#include <sys/wait.h>
#include <unistd.h>

namespace
{
  /** The signal that ends a process that watches and receives two; 0 if it
   * ends by itself. */
  int
  ended_by(const int first, const int second)
  {
    const pid_t child = fork();
    if (child == 0)
      {
        const Biface::SignalWatch watch;
        std::raise(first);
        std::raise(second);
        _exit(0);
      }
    int status = 0;
    waitpid(child, &status, 0);
    return WIFSIGNALED(status) ? WTERMSIG(status) : 0;
  }
} // namespace


int
main()
{
  for (const int first : {SIGTERM, SIGINT})
    for (const int second : {SIGTERM, SIGINT})
      std::cout << Biface::signal_name(first) << ", then "
                << Biface::signal_name(second) << ": "
                << (ended_by(first, second) == second ? "ended" : "FAILED")
                << std::endl;
}
