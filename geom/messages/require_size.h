// What is given to a stage must belong together; mixing up two models shows in their sizes first.
#pragma once

#include <cstddef>

namespace cocoon {

// Throws InputError, one line with both numbers, if `size` is not `wanted`. `stage`: whose input it
// is; `what`: of what it has so many, in the plural. Complexity: O(1).
void require_size(const char* stage, const char* what, std::size_t size, std::size_t wanted);

// Throws InputError, one line with both numbers. `what`: of which there are `count`, in the
// singular. Complexity: O(1).
[[noreturn]] void refuse_index(const char* stage, const char* what, std::size_t index,
                               std::size_t count);

// Does so unless index < count. Complexity: O(1).
inline void require_index(const char* stage, const char* what, std::size_t index,
                          std::size_t count) {
  if (index >= count) [[unlikely]]
    refuse_index(stage, what, index, count);
}

}  // namespace cocoon
