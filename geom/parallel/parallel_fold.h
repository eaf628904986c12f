// What several threads find together, each for itself.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "geom/execution.h"

namespace cocoon {

// At most so many threads take part: each may keep an array of all elements.
inline constexpr std::size_t most_fold_parts = 16;

// Every thread that takes part has a part of its own from make(). take(part, begin, end) is called
// for chunks of [0, count) of at most `grain` elements, on thread_count(execution) threads, up to
// most_fold_parts; then join(first, other) for the parts, one after the other. Returns what they
// are joined to. Which chunks a part takes is left to chance, so the result must not depend on it:
// maxima do not. Complexity: count / grain calls of take, and of the others one each thread.
template <class Make, class Take, class Join>
auto parallel_fold(const Execution& execution, std::size_t count, std::size_t grain, Make make,
                   Take take, Join join) {
  struct Slot {
    std::optional<decltype(make())> part;
    // Another thread may go on with this number and part: what the one before wrote is seen. The
    // scheduler sees to that too, but ThreadSanitizer does not see it (execution.cpp).
    std::atomic<std::size_t> taken{0};
  };
  const std::size_t threads =
      std::min(static_cast<std::size_t>(thread_count(execution)), most_fold_parts);
  std::vector<Slot> slots(threads);
  parallel_chunks_by_thread({static_cast<int>(threads), execution.progress}, count, grain,
                            [&](std::size_t thread, std::size_t begin, std::size_t end) {
                              Slot& slot = slots[thread];
                              slot.taken.load(std::memory_order_acquire);
                              if (!slot.part) slot.part.emplace(make());
                              take(*slot.part, begin, end);
                              slot.taken.fetch_add(1, std::memory_order_release);
                            });
  std::optional<decltype(make())> all;
  for (Slot& slot : slots) {
    if (!slot.part) continue;
    if (all) {
      join(*all, std::as_const(*slot.part));
    } else {
      all.emplace(std::move(*slot.part));
    }
    slot.part.reset();
  }
  if (!all) all.emplace(make());
  return std::move(*all);
}

}  // namespace cocoon
