// Operations that are cancelled at one of their reports.
#pragma once

#include <string>
#include <string_view>
#include <utility>

#include "geom/errors.h"
#include "geom/execution.h"

namespace cocoon::test {

// Stops at the n-th report.
struct StopAfter : Progress {
  explicit StopAfter(int n) : left(n) {}
  bool report(std::string_view, double) override { return --left > 0; }
  int left;
};

// Stops at the first report of this stage.
struct StopIn : Progress {
  explicit StopIn(std::string where) : stop_at(std::move(where)) {}
  bool report(std::string_view stage, double) override { return stage != stop_at; }
  std::string stop_at;
};

// Calls run(progress), which is stopped at its first report, then at the one `stride` later, and so
// on until it comes to an end; after_stop(n) when it was stopped at the n-th. Returns how often.
template <class Run, class AfterStop>
int stop_everywhere(Run run, AfterStop after_stop, int stride = 1) {
  int stopped = 0;
  for (int n = 1;; n += stride) {
    StopAfter progress(n);
    try {
      run(progress);
      return stopped;
    } catch (const Cancelled&) {
      ++stopped;
    }
    after_stop(n);
  }
}

}  // namespace cocoon::test
