#include "geom/execution.h"

#include <algorithm>
#include <optional>
#include <string>
#include <tbb/blocked_range.h>
#include <tbb/global_control.h>
#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>
#include <thread>

#include "geom/errors.h"

namespace cocoon {

bool PrefixedProgress::report(std::string_view stage, double fraction) {
  if (receiver_ == nullptr) return true;
  return receiver_->report(prefix_ + "/" + std::string(stage), fraction);
}

int thread_count(const Execution& execution) {
  if (execution.threads > 0) return execution.threads;
  return std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

void report_progress(const Execution& execution, std::string_view stage, double fraction) {
  if (execution.progress == nullptr) return;
  if (!execution.progress->report(stage, fraction)) {
    throw Cancelled("cancelled during " + std::string(stage));
  }
}

void parallel_chunks(const Execution& execution, std::size_t count, std::size_t grain,
                     const std::function<void(std::size_t, std::size_t)>& body) {
  if (count == 0) return;
  grain = std::max<std::size_t>(grain, 1);
  const std::size_t chunks = (count + grain - 1) / grain;
  const auto run_chunk = [&](std::size_t chunk) {
    body(chunk * grain, std::min(count, (chunk + 1) * grain));
  };
  const int threads = thread_count(execution);
  if (threads == 1 || chunks == 1) {
    for (std::size_t chunk = 0; chunk < chunks; ++chunk) run_chunk(chunk);
    return;
  }
  // More threads than cores were asked for (tests do): TBB warns on stderr unless it is allowed.
  std::optional<tbb::global_control> allowance;
  if (threads > tbb::info::default_concurrency()) {
    allowance.emplace(tbb::global_control::max_allowed_parallelism,
                      static_cast<std::size_t>(threads));
  }
  tbb::task_arena arena(threads);
  arena.execute([&] {
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, chunks, 1),
                      [&](const tbb::blocked_range<std::size_t>& range) {
                        for (std::size_t chunk = range.begin(); chunk != range.end(); ++chunk) {
                          run_chunk(chunk);
                        }
                      });
  });
}

}  // namespace cocoon
