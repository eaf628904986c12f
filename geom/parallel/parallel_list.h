// One list of what several threads find.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "geom/execution.h"

namespace cocoon {

namespace parallel_list_detail {

// run(body) calls body(begin, end) for the chunks.
template <class T, class Find, class Run>
std::vector<T> list_chunks(const Execution& execution, std::size_t count, std::size_t grain,
                           const Find& find, const Run& run) {
  std::vector<std::vector<T>> parts((count + grain - 1) / grain);
  run([&](std::size_t begin, std::size_t end) { find(begin, end, parts[begin / grain]); });
  std::vector<std::size_t> places(parts.size() + 1, 0);
  for (std::size_t k = 0; k < parts.size(); ++k) places[k + 1] = places[k] + parts[k].size();
  std::vector<T> all(places.back());
  parallel_chunks(execution, parts.size(), 1, [&](std::size_t k, std::size_t) {
    std::copy(parts[k].begin(), parts[k].end(), all.data() + places[k]);
  });
  return all;
}

}  // namespace parallel_list_detail

// What find(begin, end, found) appends to `found` for each chunk [begin, end) of [0, count), of at
// most `grain` elements, in the order of the chunks; on thread_count(execution) threads. The same
// list for every thread count. Complexity: a call per chunk, and O(found).
template <class T, class Find>
std::vector<T> parallel_list(const Execution& execution, std::size_t count, std::size_t grain,
                             const Find& find) {
  return parallel_list_detail::list_chunks<T>(execution, count, grain, find, [&](const auto& body) {
    parallel_chunks(execution, count, grain, body);
  });
}

// The same as a part of a stage that takes long. Errors: Cancelled.
template <class T, class Find>
std::vector<T> parallel_list(const Execution& execution, const StagePart& part, std::size_t count,
                             std::size_t grain, const Find& find) {
  return parallel_list_detail::list_chunks<T>(execution, count, grain, find, [&](const auto& body) {
    parallel_chunks(execution, part, count, grain, body);
  });
}

}  // namespace cocoon
