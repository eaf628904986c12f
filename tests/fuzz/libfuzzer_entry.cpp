// The entry point of libFuzzer, compiled once for each target.
#include <cstddef>
#include <cstdint>

#include "tests/fuzz/fuzz_target.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  cocoon::fuzz::COCOON_FUZZ_TARGET({data, size});
  return 0;
}
