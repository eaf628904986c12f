// What is given to a stage must belong together; mixing up two models shows in their sizes first.
#pragma once

#include <cstddef>

namespace cocoon {

// Throws InputError, one line with both numbers, if `size` is not `wanted`. `stage`: whose input it
// is; `what`: of what it has so many, in the plural. Complexity: O(1).
void require_size(const char* stage, const char* what, std::size_t size, std::size_t wanted);

}  // namespace cocoon
