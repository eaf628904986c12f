// Those of many elements for which a test holds.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

namespace cocoon {

// Few among many: calls visit(i) for all i < count where test(i) holds, in order. A block in which
// it holds nowhere costs one branch: with a test that only compares elements of arrays the compiler
// looks at many of them at once. Complexity: O(count).
template <class Test, class Visit>
void visit_where(std::size_t count, const Test& test, const Visit& visit) {
  constexpr std::size_t block = 128;
  const auto visit_block = [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      if (test(i)) visit(i);
    }
  };
  std::size_t begin = 0;
  for (; begin + block <= count; begin += block) {
    std::uint32_t any = 0;
    for (std::size_t k = 0; k < block; ++k) any |= test(begin + k) ? 1U : 0U;
    if (any != 0) visit_block(begin, begin + block);
  }
  visit_block(begin, count);
}

// About every second one: calls visit(i) for all i from begin to end - 1 where test(i) holds, in
// order. The processor cannot foresee which these are, so they are listed block by block without a
// branch on it. What visit(i) reads far away, test(i) may prefetch. Complexity: O(end - begin).
template <class Index, class Test, class Visit>
void visit_every_other(Index begin, Index end, const Test& test, const Visit& visit) {
  constexpr std::size_t block = 128;
  std::array<Index, block> listed;
  while (begin < end) {
    const Index block_end = static_cast<Index>(begin + std::min<std::size_t>(end - begin, block));
    std::size_t count = 0;
    for (; begin < block_end; ++begin) {
      listed[count] = begin;
      count += test(begin) ? 1U : 0U;
    }
    for (std::size_t k = 0; k < count; ++k) visit(listed[k]);
  }
}

}  // namespace cocoon
