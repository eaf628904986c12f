// Sorted lists of ids: sets, as stages hand them on.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace cocoon {

// Ascending; `none` comes last. Complexity: O(n) for each eleven bits of the largest id, by sorting
// for these bits from the lowest on (radix sort), once there are enough ids for that to pay.
template <class IdType>
void sort_ids(std::vector<IdType>& ids) {
  constexpr std::size_t few = 300;
  if (ids.size() < few) return std::sort(ids.begin(), ids.end());
  constexpr unsigned bits = 11;
  constexpr std::uint32_t mask = (1U << bits) - 1;
  std::uint32_t all_bits = 0;
  for (const IdType id : ids) all_bits |= id.value;
  std::vector<IdType> sorted(ids.size());
  for (unsigned shift = 0; shift < 32 && all_bits >> shift != 0; shift += bits) {
    std::array<std::uint32_t, mask + 2> place{};
    for (const IdType id : ids) ++place[(id.value >> shift & mask) + 1];
    for (std::size_t k = 1; k < place.size(); ++k) place[k] += place[k - 1];
    for (const IdType id : ids) sorted[place[id.value >> shift & mask]++] = id;
    std::swap(ids, sorted);
  }
}

// Sorted, each id once.
template <class IdType>
void make_set(std::vector<IdType>& ids) {
  sort_ids(ids);
  ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
}

}  // namespace cocoon
