#include "geom/parallel/task_scheduler.h"

#include <map>
#include <optional>
#include <tbb/blocked_range.h>
#include <tbb/global_control.h>
#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>
#include <utility>

namespace cocoon {
namespace {

// Whether this thread is at a task.
thread_local bool is_at_task = false;

void run_in(tbb::task_arena& arena, std::size_t count, Task task, void* context) {
  arena.execute([&] {
    tbb::parallel_for(
        tbb::blocked_range<std::size_t>(0, count, 1),
        [&](const tbb::blocked_range<std::size_t>& range) {
          struct AtTask {
            bool before = std::exchange(is_at_task, true);
            ~AtTask() { is_at_task = before; }
          } const at_task;
          const auto thread =
              static_cast<std::size_t>(tbb::this_task_arena::current_thread_index());
          for (std::size_t i = range.begin(); i != range.end(); ++i) task(context, i, thread);
        },
        tbb::simple_partitioner());
  });
}

}  // namespace

int available_cores() { return tbb::info::default_concurrency(); }

void run_tasks(int threads, std::size_t count, Task task, void* context) {
  // More threads than cores were asked for (tests do): TBB warns on stderr unless it is allowed.
  std::optional<tbb::global_control> allowance;
  if (threads > available_cores()) {
    allowance.emplace(tbb::global_control::max_allowed_parallelism,
                      static_cast<std::size_t>(threads));
  }
  if (is_at_task) {
    tbb::task_arena arena(threads);  // one of its own, so that this thread takes up no other task
    return run_in(arena, count, task, context);
  }
  // By number of threads. Kept, since some kilobytes of an arena that tasks ran in are never given
  // back: oneTBB 2021.8.
  thread_local std::map<int, tbb::task_arena> arenas;
  run_in(arenas.try_emplace(threads, threads).first->second, count, task, context);
}

}  // namespace cocoon
