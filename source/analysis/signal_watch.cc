// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/mpi.h>

#include <array>
#include <csignal>

#include <biface/analysis/signal_watch.h>

namespace Biface
{
  namespace
  {
    // the only type that a handler may write to
    volatile std::sig_atomic_t noted = 0;

    extern "C" void
    biface_note_signal(int signal)
    {
      // whoever sends another one, of either kind, does not want to wait
      if (noted != 0)
        {
          std::signal(signal, SIG_DFL);
          std::raise(signal);
        }
      noted = signal;
    }


    constexpr std::array<int, 3> watched{{SIGTERM, SIGINT, SIGXFSZ}};
  } // namespace


  SignalWatch::SignalWatch()
  {
    noted = 0;
    for (unsigned int i = 0; i < watched.size(); ++i)
      {
        // ignored, the limit of the size of a file is an error of the system
        // call that exceeds it, with a reason
        const bool       ignore = (watched[i] == SIGXFSZ);
        struct sigaction action = {};
        action.sa_handler       = (ignore ? SIG_IGN : biface_note_signal);
        // system calls continue
        action.sa_flags = (ignore ? 0 : SA_RESTART);
        sigemptyset(&action.sa_mask);
        sigaction(watched[i], &action, &before[i]);
      }
  }


  SignalWatch::~SignalWatch()
  {
    for (unsigned int i = 0; i < watched.size(); ++i)
      sigaction(watched[i], &before[i], nullptr);
  }


  int
  SignalWatch::caught(const MPI_Comm communicator) const
  {
    // ranks may see a signal at different times, but must stop at the same one
    return dealii::Utilities::MPI::max(static_cast<int>(noted), communicator);
  }


  const char *
  signal_name(const int signal)
  {
    return signal == SIGINT ? "SIGINT" : "SIGTERM";
  }
} // namespace Biface
