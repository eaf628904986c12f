#include "app/console/stage_clock.h"

namespace cocoon::app {

StageClock::Entry& StageClock::entry(std::string_view stage) {
  for (Entry& candidate : entries_) {
    if (candidate.stage == stage) return candidate;
  }
  entries_.push_back({std::string(stage), 0, false, false, {}});
  return entries_.back();
}

bool StageClock::report(std::string_view stage, double fraction) {
  const Clock::time_point now = Clock::now();
  Entry& timed_stage = entry(stage);
  if (!timed_stage.running) {
    // A second report of 1 ends nothing: it must not begin a run that never ends.
    if (fraction < 1 || !timed_stage.finished) timed_stage.begin = now;
    timed_stage.running = fraction < 1;
    timed_stage.finished = timed_stage.finished || fraction >= 1;
  } else if (fraction >= 1) {
    timed_stage.seconds += std::chrono::duration<double>(now - timed_stage.begin).count();
    timed_stage.running = false;
    timed_stage.finished = true;
  }
  return next_ == nullptr || next_->report(stage, fraction);
}

std::vector<StageTime> StageClock::times() const {
  std::vector<StageTime> result;
  for (const Entry& timed_stage : entries_) {
    if (timed_stage.finished) result.push_back({timed_stage.stage, timed_stage.seconds});
  }
  return result;
}

double StageClock::seconds(std::string_view stage) const {
  for (const Entry& timed_stage : entries_) {
    if (timed_stage.stage == stage) return timed_stage.seconds;
  }
  const std::string prefix = std::string(stage) + "/";
  double nested = 0;
  for (const Entry& timed_stage : entries_) {
    const bool is_child = timed_stage.stage.compare(0, prefix.size(), prefix) == 0 &&
                          timed_stage.stage.find('/', prefix.size()) == std::string::npos;
    if (is_child) nested += timed_stage.seconds;
  }
  return nested;
}

double StageClock::total_seconds() const {
  return std::chrono::duration<double>(Clock::now() - made_).count();
}

}  // namespace cocoon::app
