#include "app/interrupt.h"

#include <csignal>
#include <cstdlib>

namespace cocoon::app {

namespace {

volatile std::sig_atomic_t noted_signal = 0;

void note_signal(int signal) { noted_signal = signal; }

}  // namespace

void catch_interrupts() {
  struct sigaction action = {};
  action.sa_handler = note_signal;
  action.sa_flags = static_cast<int>(SA_RESETHAND);
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
  std::signal(SIGXFSZ, SIG_IGN);
}

bool interrupted() { return noted_signal != 0; }

void end_by_interrupt() {
  std::signal(noted_signal, SIG_DFL);
  std::raise(noted_signal);
  std::_Exit(128 + noted_signal);
}

}  // namespace cocoon::app
