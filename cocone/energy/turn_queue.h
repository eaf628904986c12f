// Who has the next turn of many cells, the clearest case first.
#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <queue>
#include <vector>

namespace cocoon {

// When a cell has its turn, as one number: the clearer first, then the first in canonical order.
using Turn = std::uint64_t;

inline Turn make_turn(float clarity, std::uint32_t rank) {
  constexpr std::uint32_t sign = 0x80000000U;
  const auto bits = std::bit_cast<std::uint32_t>(clarity);
  const std::uint32_t ordered = (bits & sign) != 0 ? ~bits : bits | sign;
  return static_cast<Turn>(ordered) << 32 | ~rank;
}
inline std::uint32_t rank_of(Turn turn) { return ~static_cast<std::uint32_t>(turn); }

// Clarities are from -1 to 1; hardly any is above that of the last turn. So turns wait by classes
// of clarity, and only one class at a time is sorted: those who come next are known and can be
// asked for in advance, which those of a heap are not.
class TurnQueue {
 public:
  // Complexity: O(1), but O(log k) where k turns as clear as the next ones came late.
  void push(float clarity, std::uint32_t rank);
  // Moves the next turn to `turn`; false if there is none. Complexity: O(log n) amortized.
  bool pop(Turn& turn);
  // About the rank that has its turn `steps` later than the last one popped; any if that is not
  // known. O(1).
  std::uint32_t rank_ahead(std::size_t steps) const {
    return sorted_.empty() ? 0 : rank_of(sorted_[sorted_.size() - std::min(steps, sorted_.size())]);
  }

 private:
  static constexpr std::size_t classes = 1024;
  static std::size_t class_of(float clarity) {
    return static_cast<std::size_t>((clarity + 1) * (static_cast<float>(classes) / 2));
  }
  bool open_next_class();

  std::vector<std::vector<Turn>> waiting_ = std::vector<std::vector<Turn>>(classes + 1);
  std::size_t open_ = classes + 1;  // all classes from this one on are sorted or late
  std::vector<Turn> sorted_;        // ascending: the next one is the last
  std::priority_queue<Turn> late_;  // that came when their class was open
};

}  // namespace cocoon
