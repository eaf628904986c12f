#include "app/console/interrupt.h"

#include <csignal>
#include <cstdlib>
#include <initializer_list>

namespace cocoon::app {

namespace {

volatile std::sig_atomic_t noted_signal = 0;

void note_signal(int signal) { noted_signal = signal; }

// Who starts the program may have it ignore a signal: nohup, or a shell for what a script runs
// with &.
void note_unless_ignored(int signal) {
  struct sigaction action = {};
  if (sigaction(signal, nullptr, &action) == 0 && action.sa_handler == SIG_IGN) return;
  action = {};
  action.sa_handler = note_signal;
  action.sa_flags = static_cast<int>(SA_RESETHAND);
  sigaction(signal, &action, nullptr);
}

}  // namespace

void catch_interrupts() {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) note_unless_ignored(signal);
  std::signal(SIGXFSZ, SIG_IGN);
}

bool interrupted() { return noted_signal != 0; }

void end_by_interrupt() {
  std::signal(noted_signal, SIG_DFL);
  std::raise(noted_signal);
  std::_Exit(128 + noted_signal);
}

}  // namespace cocoon::app
