// Ctrl-C (SIGINT), SIGTERM and the end of the terminal (SIGHUP): the running stage is asked to
// stop, so that no half-written file stays behind; then the program ends by that signal, as a shell
// expects (status 130, 143 or 129).
#pragma once

#include <string_view>

#include "geom/execution.h"

namespace cocoon::app {

// From now on the first of each of these signals is only noted; a second one ends the program at
// once. Those that are ignored when the program starts, as under nohup, stay so. A file that grows
// beyond a limit (SIGXFSZ) is an error of the write, like a full disk.
void catch_interrupts();

bool interrupted();

// For stages that are part of another one: shows nothing, and asks to stop once the user has
// interrupted the program.
class StopWhenInterrupted : public Progress {
 public:
  bool report(std::string_view, double) override { return !interrupted(); }
};

// Ends the program by the signal that was noted. Precondition: interrupted().
[[noreturn]] void end_by_interrupt();

}  // namespace cocoon::app
