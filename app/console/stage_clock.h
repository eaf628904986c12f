// A Progress that measures how long each stage takes.
#pragma once

#include <chrono>
#include <string>
#include <string_view>
#include <vector>

#include "geom/execution.h"

namespace cocoon::app {

struct StageTime {
  std::string stage;   // as reported: "poles", "reconstruction/delaunay"
  double seconds = 0;  // summed over all its runs
};

// Times a stage from its report of 0 to its report of 1 (nested stages are stages of their own),
// and passes every report on.
class StageClock : public Progress {
 public:
  explicit StageClock(Progress* next) : next_(next) {}
  bool report(std::string_view stage, double fraction) override;

  // All finished stages, in the order in which they first began.
  std::vector<StageTime> times() const;
  // Time of one stage; of its nested stages together if it was never reported itself; 0 if neither.
  double seconds(std::string_view stage) const;
  // Since the clock was made.
  double total_seconds() const;

 private:
  using Clock = std::chrono::steady_clock;
  struct Entry {
    std::string stage;
    double seconds = 0;
    bool running = false;
    bool finished = false;
    Clock::time_point begin;
  };
  Entry& entry(std::string_view stage);

  Progress* next_;  // not owned, may be null
  Clock::time_point made_ = Clock::now();
  std::vector<Entry> entries_;
};

// Runs `body` as a stage of the program's own ("read", "write") and returns what it returns.
template <class Body>
auto timed(const Execution& execution, std::string_view stage, Body body) {
  return run_step(execution, stage, [&](const Execution&) { return body(); });
}

}  // namespace cocoon::app
