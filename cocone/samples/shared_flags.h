// Flags of vertices that several threads raise at once. None is ever lowered, so the order in which
// they are raised does not show.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "cocone/facet_set.h"
#include "geom/ids.h"

namespace cocoon {

class SharedFlags {
 public:
  explicit SharedFlags(std::size_t num_vertices) : flags_(num_vertices, 0) {}
  void raise(VertexId v) { std::atomic_ref(flags_[v]).store(1, std::memory_order_relaxed); }
  // The following when all threads are done.
  bool is_raised(VertexId v) const { return flags_[v] != 0; }
  VertexSet take() && { return std::move(flags_); }

 private:
  VertexSet flags_;
};

}  // namespace cocoon
