// Shows the running stage on standard error: one line rewritten in place on a terminal, one line
// per finished stage elsewhere.
#pragma once

#include <chrono>
#include <string_view>

#include "geom/execution.h"

namespace cocoon::app {

class ProgressLine : public Progress {
 public:
  enum class Style { none, terminal, log };

  explicit ProgressLine(Style style) : style_(style) {}
  ~ProgressLine() override { clear(); }
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  // Asks to stop once the user has interrupted the program (interrupt.h).
  bool report(std::string_view stage, double fraction) override;
  // Removes the line from the terminal, so that other text can be written.
  void clear();

 private:
  Style style_;
  std::size_t shown_width_ = 0;
  std::chrono::steady_clock::time_point last_shown_;
};

// What suits standard error: a rewritten line on a terminal, else nothing unless `forced`.
ProgressLine::Style progress_style(bool forced, bool quiet);

}  // namespace cocoon::app
