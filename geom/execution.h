// How a stage runs: on how many threads, and who is told of its progress. It never changes what
// a stage computes.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>

namespace cocoon {

// Told now and then how far a stage is; may ask it to stop. Called from the calling thread only.
class Progress {
 public:
  virtual ~Progress() = default;
  // `stage`: its name, constant during the stage; `fraction` in [0, 1], non-decreasing.
  // Returns false to cancel: the stage then throws Cancelled and leaves nothing half done.
  virtual bool report(std::string_view stage, double fraction) = 0;
};

// Passes reports on under "prefix/stage" ("reconstruction/delaunay"), to one who is there:
// run_step.
class PrefixedProgress : public Progress {
 public:
  PrefixedProgress(std::string prefix, Progress* receiver)
      : prefix_(std::move(prefix)), receiver_(receiver) {}
  bool report(std::string_view stage, double fraction) override;

 private:
  std::string prefix_;
  Progress* receiver_;  // not owned
};

struct Execution {
  int threads = 1;               // 0 or less = all cores that the process may use; at most 1024
  Progress* progress = nullptr;  // not owned, may be null
};

// The number of threads that `execution` stands for, 1 to 1024.
int thread_count(const Execution& execution);

// Reports progress and throws Cancelled if the receiver says stop. No receiver: nothing happens.
void report_progress(const Execution& execution, std::string_view stage, double fraction);

// Runs body(execution) as one step of a composition and returns what it returns: reports its begin
// and end, and what the stages in it report as "step/stage".
template <class Body>
auto run_step(const Execution& execution, std::string_view step, Body body) {
  report_progress(execution, step, 0);
  PrefixedProgress prefixed{std::string(step), execution.progress};
  const Execution nested{execution.threads, execution.progress == nullptr ? nullptr : &prefixed};
  if constexpr (std::is_void_v<decltype(body(nested))>) {
    body(nested);
    report_progress(execution, step, 1);
  } else {
    auto result = body(nested);
    report_progress(execution, step, 1);
    return result;
  }
}

// Calls body(begin, end) for consecutive chunks of [0, count) of at most `grain` elements, on
// thread_count(execution) threads. Chunk borders depend on count and grain alone, so per-chunk
// results combined in chunk order are the same for every thread count. Exceptions of body reach
// the caller. Complexity: count / grain calls.
void parallel_chunks(const Execution& execution, std::size_t count, std::size_t grain,
                     const std::function<void(std::size_t begin, std::size_t end)>& body);

// A part of a stage that takes long: from one fraction of its progress to another.
struct StagePart {
  std::string_view stage;
  double begin = 0;
  double end = 1;
};

// The same for such a part: about a hundred reports on the way, so that it can be cancelled.
// Errors: Cancelled.
void parallel_chunks(const Execution& execution, const StagePart& part, std::size_t count,
                     std::size_t grain,
                     const std::function<void(std::size_t begin, std::size_t end)>& body);

// As the first; body(thread, begin, end) is also told which thread calls it, by a number below
// thread_count(execution) that differs from those of all calls under way. Use parallel_fold
// (parallel_fold.h) for what each thread keeps for itself.
void parallel_chunks_by_thread(
    const Execution& execution, std::size_t count, std::size_t grain,
    const std::function<void(std::size_t thread, std::size_t begin, std::size_t end)>& body);

}  // namespace cocoon
