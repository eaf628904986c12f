// A good mix of the bits of a word, for hashes and random numbers.
#pragma once

#include <cstdint>

namespace cocoon {

// The finalizer of SplitMix64: a bijection, and each bit of the result depends on all of `word`.
// Source: Steele, Lea & Flood, Fast splittable pseudorandom number generators (OOPSLA 2014).
constexpr std::uint64_t mixed_bits(std::uint64_t word) {
  word = (word ^ (word >> 30)) * 0xBF58476D1CE4E5B9U;
  word = (word ^ (word >> 27)) * 0x94D049BB133111EBU;
  return word ^ (word >> 31);
}

}  // namespace cocoon
