#include "app/console/progress_line.h"

#include <algorithm>
#include <fmt/format.h>

#include "app/console/interrupt.h"
#include "app/console/standard_streams.h"

namespace cocoon::app {

bool ProgressLine::report(std::string_view stage, double fraction) {
  // First: whoever reads that a stage is done must not read that it was cancelled.
  if (interrupted()) return false;
  const bool finished = fraction >= 1;
  if (style_ == Style::log && finished) {
    print_error(fmt::format("{}: done\n", stage));
  } else if (style_ == Style::terminal) {
    const auto now = std::chrono::steady_clock::now();
    if (now - last_shown_ > std::chrono::milliseconds(100)) {
      const std::string line = fmt::format("{} {:3.0f} %", stage, 100 * std::min(fraction, 1.0));
      print_error(fmt::format("\r{:<{}}", line, shown_width_));
      shown_width_ = line.size();
      last_shown_ = now;
    }
  }
  return true;
}

void ProgressLine::clear() {
  if (shown_width_ == 0) return;
  print_error(fmt::format("\r{:<{}}\r", "", shown_width_));
  shown_width_ = 0;
}

ProgressLine::Style progress_style(bool forced, bool quiet) {
  const bool terminal = is_error_seen();
  if (terminal && (forced || !quiet)) return ProgressLine::Style::terminal;
  return forced ? ProgressLine::Style::log : ProgressLine::Style::none;
}

}  // namespace cocoon::app
