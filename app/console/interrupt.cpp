#include "app/console/interrupt.h"

#include <array>
#include <csignal>
#include <cstdlib>

namespace cocoon::app {

namespace {

volatile std::sig_atomic_t noted_signal = 0;

constexpr std::array noted_signals = {SIGINT, SIGTERM, SIGHUP};

// The next signal, whichever it is, ends the program at once: it may be waiting for a pipe.
void note_signal(int signal) {
  noted_signal = signal;
  struct sigaction standard = {};
  standard.sa_handler = SIG_DFL;
  for (const int other : noted_signals) {
    struct sigaction action = {};
    if (sigaction(other, nullptr, &action) == 0 && action.sa_handler == note_signal) {
      sigaction(other, &standard, nullptr);
    }
  }
}

// Who starts the program may have it ignore a signal: nohup, or a shell for what a script runs
// with &.
void note_unless_ignored(int signal) {
  struct sigaction action = {};
  if (sigaction(signal, nullptr, &action) == 0 && action.sa_handler == SIG_IGN) return;
  action = {};
  action.sa_handler = note_signal;
  sigaction(signal, &action, nullptr);
}

}  // namespace

void catch_interrupts() {
  for (const int signal : noted_signals) note_unless_ignored(signal);
  std::signal(SIGXFSZ, SIG_IGN);
}

bool interrupted() { return noted_signal != 0; }

void end_by_interrupt() {
  std::signal(noted_signal, SIG_DFL);
  std::raise(noted_signal);
  std::_Exit(128 + noted_signal);
}

}  // namespace cocoon::app
