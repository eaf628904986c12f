#include "delaunay/kernel/vertex_claims.h"

namespace cocoon {

bool ClaimHolder::take_anew(VertexId v) {
  if (v == infinite_vertex) return true;
  const std::size_t block = block_of(v);
  std::uint8_t expected = VertexClaims::nobody;
  if (!claims_[block].compare_exchange_strong(expected, name_, std::memory_order_acquire,
                                              std::memory_order_relaxed)) {
    return false;
  }
  held_.push_back(block);
  return true;
}

void ClaimHolder::release() {
  for (const std::size_t block : held_) give_back(block);
  held_.clear();
}

void ClaimHolder::release_but(const Cell& cell) {
  const auto kept = std::partition(held_.begin(), held_.end(), [&](std::size_t block) {
    return std::any_of(cell.vertices.begin(), cell.vertices.end(),
                       [&](VertexId v) { return block_of(v) == block; });
  });
  std::for_each(kept, held_.end(), [&](std::size_t block) { give_back(block); });
  held_.erase(kept, held_.end());
}

}  // namespace cocoon
