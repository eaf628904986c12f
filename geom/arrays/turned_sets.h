// Sets that are joined and never parted again, of members that are turned against each other or
// not.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace cocoon {

// Disjoint sets of 0 .. count - 1, and of any two members of one set whether they are turned
// against each other. Sets are joined under the smaller root, so a root is the smallest member of
// its set. Threads may share the object as long as each asks about and joins sets of its own.
// Source: Tarjan & van Leeuwen 1984 (path halving); the parity is kept along the paths.
class TurnedSets {
 public:
  struct Place {
    std::uint32_t root;
    std::uint32_t turned;  // 1: against the root
  };

  // Precondition: count < 2^31. O(count).
  explicit TurnedSets(std::size_t count) : above_(count) {
    for (std::uint32_t k = 0; k < count; ++k) above_[k] = word_of_root(k);
  }

  // Where the member hangs: 2 * parent, + 1 if it is turned against it; the parent of a root is
  // itself.
  std::uint32_t word(std::uint32_t member) const { return above_[member]; }
  static constexpr std::uint32_t word_of_root(std::uint32_t member) { return member << 1; }
  // Hangs a member elsewhere, under an earlier one. Precondition: it has been alone, or the word
  // says what is known already.
  void hang(std::uint32_t member, std::uint32_t word) { above_[member] = word; }
  // All words.
  std::vector<std::uint32_t> take() && { return std::move(above_); }

  // Halves the path.
  Place place(std::uint32_t member) {
    std::uint32_t turned = 0;
    for (;;) {
      const std::uint32_t up = above_[member];
      if (up >> 1 == member) return {member, turned};
      const std::uint32_t second = above_[up >> 1] ^ (up & 1U);
      above_[member] = second;
      turned ^= second & 1U;
      member = second >> 1;
    }
  }

  // False if they are in one set, and turned otherwise than told. Near constant time in practice.
  bool join(std::uint32_t a, std::uint32_t b, std::uint32_t turned) {
    const Place at_a = place(a);
    const Place at_b = place(b);
    turned ^= at_a.turned ^ at_b.turned;
    if (at_a.root == at_b.root) return turned == 0;
    above_[std::max(at_a.root, at_b.root)] = std::min(at_a.root, at_b.root) << 1 | turned;
    return true;
  }

 private:
  std::vector<std::uint32_t> above_;
};

}  // namespace cocoon
