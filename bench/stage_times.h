// How long the stages of a computation take, told by the progress they report.
#pragma once

#include <map>
#include <string>
#include <string_view>

#include "bench/stopwatch.h"
#include "geom/execution.h"

namespace cocoon::bench {

// The time between a stage's first and last report; of several runs of a stage the sum.
class StageTimes : public Progress {
 public:
  explicit StageTimes(double Elapsed::*time = &Elapsed::processor) : time_(time) {}
  bool report(std::string_view stage, double fraction) override {
    const double now = stopwatch_.elapsed().*time_;
    if (fraction <= 0) begin_[std::string(stage)] = now;
    if (fraction >= 1) seconds_[std::string(stage)] += now - begin_[std::string(stage)];
    return true;
  }
  // 0 for a stage that did not run.
  double seconds(const std::string& stage) const {
    const auto found = seconds_.find(stage);
    return found == seconds_.end() ? 0 : found->second;
  }

 private:
  Stopwatch stopwatch_;
  double Elapsed::*time_;
  std::map<std::string, double> begin_;
  std::map<std::string, double> seconds_;
};

}  // namespace cocoon::bench
