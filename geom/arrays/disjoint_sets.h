// Sets that are joined and never parted again.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

namespace cocoon {

// Disjoint sets of 0 .. count - 1. Sets are joined under the smaller root, so a root is the
// smallest member of its set. Near constant time each in practice.
// Source: Tarjan & van Leeuwen 1984 (path halving).
class DisjointSets {
 public:
  // Precondition: count < 2^32. O(count).
  explicit DisjointSets(std::size_t count) : parent_(count) {
    std::iota(parent_.begin(), parent_.end(), std::uint32_t{0});
  }
  // Halves the path.
  std::uint32_t root(std::uint32_t member) {
    while (parent_[member] != member) {
      member = parent_[member] = parent_[parent_[member]];
    }
    return member;
  }
  // True if they were in different sets.
  bool join(std::uint32_t a, std::uint32_t b) {
    a = root(a);
    b = root(b);
    parent_[std::max(a, b)] = std::min(a, b);
    return a != b;
  }

 private:
  std::vector<std::uint32_t> parent_;
};

}  // namespace cocoon
