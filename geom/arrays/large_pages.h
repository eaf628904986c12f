// Large pages for large arrays.
#pragma once

#include <cstddef>

namespace cocoon {

// Asks the operating system to back the whole large pages (2 MiB) inside of [begin, begin + bytes)
// by such, where it can: a wish, not a need. For an array that is about to be written for the first
// time: filling it then costs one page fault where it costs 512 otherwise, and random access needs
// fewer entries of the translation cache. Does nothing for small arrays, on other systems than
// Linux, and where the administrator wants none. Complexity: O(1), one system call.
void prefer_large_pages(const void* begin, std::size_t bytes);

// The same for what a vector has reserved.
template <class Vector>
void prefer_large_pages(const Vector& vector) {
  prefer_large_pages(vector.data(), vector.capacity() * sizeof(typename Vector::value_type));
}

}  // namespace cocoon
