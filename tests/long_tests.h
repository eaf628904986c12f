// COCOON_LONG_TESTS=N makes tests of random steps take N times as many.
#pragma once

#include <cstddef>
#include <cstdlib>

namespace cocoon::test {

inline std::size_t long_factor() {
  const char* value = std::getenv("COCOON_LONG_TESTS");
  const unsigned long factor = value == nullptr ? 1 : std::strtoul(value, nullptr, 10);
  return factor == 0 ? 1 : factor;
}

}  // namespace cocoon::test
