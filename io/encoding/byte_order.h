// Numbers in the bytes of a file, whose order need not be this machine's.
#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstring>
#include <span>
#include <string>
#include <type_traits>

namespace cocoon {

template <class T>
T load_number(const char* bytes, std::endian order) {
  static_assert(std::is_arithmetic_v<T>);
  char copy[sizeof(T)];
  std::memcpy(copy, bytes, sizeof(T));
  if (order != std::endian::native) std::reverse(copy, copy + sizeof(T));
  T value;
  std::memcpy(&value, copy, sizeof(T));
  return value;
}

// Turns the bytes of each number of that width around. Precondition: whole numbers.
inline void reverse_each(std::span<char> numbers, std::size_t width) {
  for (auto at = numbers.begin(); at != numbers.end();) {
    const auto next = at + static_cast<std::ptrdiff_t>(width);
    std::reverse(at, next);
    at = next;
  }
}

template <class T>
void append_little_endian(std::string& bytes, T value) {
  static_assert(std::is_arithmetic_v<T>);
  char copy[sizeof(T)];
  std::memcpy(copy, &value, sizeof(T));
  if (std::endian::native != std::endian::little) std::reverse(copy, copy + sizeof(T));
  bytes.append(copy, sizeof(T));
}

}  // namespace cocoon
