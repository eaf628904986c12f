// Room in arrays that updates will make a little longer, again and again.
#pragma once

#include <cstddef>

namespace cocoon {

// How many elements to reserve for `count` now: an eighth more. Without room the first element that
// is added copies the whole array: a second and more for the cells of ten million points. Room that
// nothing is written to costs address space, no memory. Complexity: O(1).
constexpr std::size_t with_room_to_grow(std::size_t count) { return count + count / 8; }

}  // namespace cocoon
