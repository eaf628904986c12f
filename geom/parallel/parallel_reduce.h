// One value of many elements, computed by several threads.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <vector>

#include "geom/execution.h"

namespace cocoon {

// The size of the chunks into which a light pass over `count` elements is cut: at most 64 chunks,
// none of which is too small to be worth a task.
constexpr std::size_t coarse_grain(std::size_t count) {
  constexpr std::size_t most_chunks = 64;
  constexpr std::size_t smallest_chunk = std::size_t{1} << 15;
  return std::max(smallest_chunk, (count + most_chunks - 1) / most_chunks);
}

// combine(... combine(combine(identity, of_chunk(0, g)), of_chunk(g, 2 g)) ...): a value of each
// chunk [begin, end) of [0, count), on thread_count(execution) threads, combined in the order of
// the chunks, whose size depends on `count` alone. So the result is the same for every thread
// count. Complexity: one call of each per chunk; at most 64 chunks.
template <class T, class OfChunk, class Combine>
T parallel_reduce(const Execution& execution, std::size_t count, const T& identity,
                  const OfChunk& of_chunk, const Combine& combine) {
  const std::size_t grain = coarse_grain(count);
  std::vector<T> parts((count + grain - 1) / grain, identity);
  parallel_chunks(execution, count, grain, [&](std::size_t begin, std::size_t end) {
    parts[begin / grain] = of_chunk(begin, end);
  });
  T result = identity;
  for (const T& part : parts) result = combine(result, part);
  return result;
}

// The smallest index below `count` for which holds(index) is false; `count` if there is none.
// Complexity: a call for each index up to there, and beyond in chunks begun before it was found.
template <class Holds>
std::size_t first_failing(const Execution& execution, std::size_t count, const Holds& holds) {
  std::atomic<std::size_t> first{count};
  parallel_chunks(execution, count, coarse_grain(count), [&](std::size_t k, std::size_t end) {
    std::size_t found = first.load(std::memory_order_relaxed);
    if (k >= found) return;
    while (k < end && holds(k)) ++k;
    if (k == end) return;
    while (k < found && !first.compare_exchange_weak(found, k, std::memory_order_relaxed)) {
    }
  });
  return first.load(std::memory_order_relaxed);
}

}  // namespace cocoon
