// Flags of vertices that several threads raise at once. None is ever lowered, so the order in which
// they are raised does not show.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "geom/ids.h"

namespace cocoon {

class SharedFlags {
 public:
  explicit SharedFlags(std::size_t num_vertices) : flags_(num_vertices) {}
  void raise(VertexId v) { flags_[v.index()].store(1, std::memory_order_relaxed); }
  bool is_raised(VertexId v) const {
    return flags_[v.index()].load(std::memory_order_relaxed) != 0;
  }

 private:
  std::vector<std::atomic<std::uint8_t>> flags_;
};

}  // namespace cocoon
