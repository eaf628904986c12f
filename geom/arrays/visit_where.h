// Few among many.
#pragma once

#include <cstddef>
#include <cstdint>

namespace cocoon {

// Calls visit(i) for all i < count where test(i) holds, in order. A block in which it holds nowhere
// costs one branch: with a test that only compares elements of arrays the compiler looks at many of
// them at once. Complexity: O(count).
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

}  // namespace cocoon
