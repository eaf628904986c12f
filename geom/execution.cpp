#include "geom/execution.h"

#include <algorithm>
#include <atomic>
#include <string>

#include "geom/errors.h"
#include "geom/parallel/task_scheduler.h"

#if defined(__SANITIZE_THREAD__)
// ThreadSanitizer sees the calls that the library of oneTBB makes to malloc and memcmp, but not
// what orders them.
extern "C" const char* __tsan_default_suppressions() { return "called_from_lib:libtbb.so.12"; }
#endif

namespace cocoon {
namespace {

// One parallel loop. What the calling thread wrote before it is seen by its tasks, and what these
// wrote is seen by the caller after it. The scheduler sees to that too, but inside a library that
// ThreadSanitizer does not see.
class ChunkLoop {
 public:
  using Body = std::function<void(std::size_t, std::size_t, std::size_t)>;

  ChunkLoop(std::size_t count, std::size_t grain, const Body& body)
      : count_(count), grain_(grain), body_(body) {
    begun_.store(true, std::memory_order_release);
  }
  ~ChunkLoop() { returned_.load(std::memory_order_acquire); }
  ChunkLoop(const ChunkLoop&) = delete;
  ChunkLoop& operator=(const ChunkLoop&) = delete;

  std::size_t num_chunks() const { return (count_ + grain_ - 1) / grain_; }
  void run(std::size_t thread, std::size_t chunk) const {
    body_(thread, chunk * grain_, std::min(count_, (chunk + 1) * grain_));
  }
  static void run_as_task(void* loop, std::size_t chunk, std::size_t thread) {
    static_cast<ChunkLoop*>(loop)->run_ordered(thread, chunk);
  }

 private:
  void run_ordered(std::size_t thread, std::size_t chunk) {
    struct Return {  // also if the body throws
      std::atomic<std::size_t>& returned;
      ~Return() { returned.fetch_add(1, std::memory_order_release); }
    };
    begun_.load(std::memory_order_acquire);
    const Return at_end{returned_};
    run(thread, chunk);
  }

  std::size_t count_;
  std::size_t grain_;
  const Body& body_;
  std::atomic<bool> begun_{false};
  std::atomic<std::size_t> returned_{0};
};

}  // namespace

bool PrefixedProgress::report(std::string_view stage, double fraction) {
  return receiver_->report(prefix_ + "/" + std::string(stage), fraction);
}

int thread_count(const Execution& execution) {
  constexpr int most = 1024;
  if (execution.threads > 0) return std::min(execution.threads, most);
  return std::clamp(available_cores(), 1, most);
}

void report_progress(const Execution& execution, std::string_view stage, double fraction) {
  if (execution.progress == nullptr) return;
  if (!execution.progress->report(stage, fraction)) {
    throw Cancelled("cancelled during " + std::string(stage));
  }
}

void parallel_chunks(const Execution& execution, std::size_t count, std::size_t grain,
                     const std::function<void(std::size_t, std::size_t)>& body) {
  parallel_chunks_by_thread(
      execution, count, grain,
      [&](std::size_t, std::size_t begin, std::size_t end) { body(begin, end); });
}

void parallel_chunks(const Execution& execution, const StagePart& part, std::size_t count,
                     std::size_t grain, const std::function<void(std::size_t, std::size_t)>& body) {
  if (execution.progress == nullptr) return parallel_chunks(execution, count, grain, body);
  constexpr std::size_t reports = 100;
  grain = std::max<std::size_t>(grain, 1);
  const std::size_t chunks = (count + grain - 1) / grain;
  // At least some chunks for each thread between two reports.
  const std::size_t least = 4 * static_cast<std::size_t>(thread_count(execution));
  const std::size_t slice = std::max(least, (chunks + reports - 1) / reports) * grain;
  for (std::size_t first = 0; first < count; first += slice) {
    const double done = static_cast<double>(first) / static_cast<double>(count);
    report_progress(execution, part.stage, part.begin + done * (part.end - part.begin));
    parallel_chunks(execution, std::min(slice, count - first), grain,
                    [&](std::size_t begin, std::size_t end) { body(first + begin, first + end); });
  }
}

void parallel_chunks_by_thread(
    const Execution& execution, std::size_t count, std::size_t grain,
    const std::function<void(std::size_t, std::size_t, std::size_t)>& body) {
  if (count == 0) return;
  ChunkLoop loop(count, std::max<std::size_t>(grain, 1), body);
  const int threads = thread_count(execution);
  if (threads == 1 || loop.num_chunks() == 1) {
    for (std::size_t chunk = 0; chunk < loop.num_chunks(); ++chunk) loop.run(0, chunk);
  } else {
    run_tasks(threads, loop.num_chunks(), ChunkLoop::run_as_task, &loop);
  }
}

}  // namespace cocoon
