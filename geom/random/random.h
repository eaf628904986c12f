// Random numbers that are the same bits on every machine and with every standard library (the
// distributions of <random> are not), but for gaussian(), which takes a logarithm. For sample
// models, tests and insertion rounds; not for secrets. Complexity: O(1) each, expected where
// numbers are drawn until they fit; shuffle O(n).
#pragma once

#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "geom/point.h"
#include "geom/random/mixed_bits.h"

namespace cocoon {

// One step of SplitMix64: a good 64-bit mix of `state`, which it advances.
// Source: Steele, Lea & Flood, Fast splittable pseudorandom number generators (OOPSLA 2014).
constexpr std::uint64_t splitmix64(std::uint64_t& state) {
  state += 0x9E3779B97F4A7C15ULL;
  return mixed_bits(state);
}

// xoshiro256**, period 2^256 - 1, seeded through SplitMix64.
// Source: Blackman & Vigna, Scrambled linear pseudorandom number generators (TOMS 2021).
class Random {
 public:
  explicit constexpr Random(std::uint64_t seed) {
    for (std::uint64_t& word : state_) word = splitmix64(seed);
  }

  constexpr std::uint64_t bits() {
    const std::uint64_t result = std::rotl(state_[1] * 5, 7) * 9;
    const std::uint64_t t = state_[1] << 17;
    state_[2] ^= state_[0];
    state_[3] ^= state_[1];
    state_[1] ^= state_[2];
    state_[0] ^= state_[3];
    state_[2] ^= t;
    state_[3] = std::rotl(state_[3], 45);
    return result;
  }

  // In [0, 1), a multiple of 2^-53.
  constexpr double uniform() { return static_cast<double>(bits() >> 11) * 0x1p-53; }
  constexpr double uniform(double low, double high) { return low + (high - low) * uniform(); }

  // In [0, count), count > 0. The bias is below count / 2^53.
  constexpr std::size_t below(std::size_t count) {
    return static_cast<std::size_t>(uniform() * static_cast<double>(count));
  }

  // Mean 0, standard deviation 1: the polar method, which needs no sine or cosine.
  // Source: Marsaglia & Bray, A convenient method for generating normal variables (SIAM Rev. 1964).
  double gaussian() {
    double u = 0;
    double v = 0;
    double square = 0;
    do {
      u = uniform(-1, 1);
      v = uniform(-1, 1);
      square = u * u + v * v;
    } while (square >= 1 || square == 0);
    return u * std::sqrt(-2 * std::log(square) / square);
  }

  // Uniform in the unit cube; uniform on the unit sphere.
  constexpr Point in_unit_cube() {
    const double x = uniform();
    const double y = uniform();
    return {x, y, uniform()};
  }
  Point on_unit_sphere() {
    // Marsaglia 1972: a uniform point of the disk, lifted.
    double u = 0;
    double v = 0;
    double square = 0;
    do {
      u = uniform(-1, 1);
      v = uniform(-1, 1);
      square = u * u + v * v;
    } while (square >= 1);
    const double scale = 2 * std::sqrt(1 - square);
    return {u * scale, v * scale, 1 - 2 * square};
  }

  // Fisher-Yates.
  template <class Range>
  constexpr void shuffle(Range& range) {
    for (std::size_t i = range.size(); i > 1; --i) std::swap(range[i - 1], range[below(i)]);
  }

 private:
  std::array<std::uint64_t, 4> state_{};
};

}  // namespace cocoon
