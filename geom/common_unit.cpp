#include "geom/common_unit.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

#include "geom/parallel_reduce.h"

namespace cocoon {
namespace {

constexpr int no_exponent = 2000;  // above every exponent of a double

// The exponent of the lowest bit that is set in `value`.
int lowest_bit(double value) {
  const auto bits = std::bit_cast<std::uint64_t>(value);
  constexpr std::uint64_t hidden = std::uint64_t{1} << 52;
  const int biased = static_cast<int>((bits >> 52) & 0x7FFU);
  const std::uint64_t mantissa = (bits & (hidden - 1)) | (biased == 0 ? 0 : hidden);
  if (mantissa == 0) return no_exponent;
  return std::max(biased, 1) - 1075 + std::countr_zero(mantissa);
}

int lowest_bit(const Point& p) {
  return std::min({lowest_bit(p.x), lowest_bit(p.y), lowest_bit(p.z)});
}

double power_of_two(int exponent) {
  return exponent == no_exponent ? 0.0 : std::ldexp(1.0, exponent);
}

}  // namespace

double common_unit(Points points, const Execution& execution) {
  const auto lowest_of = [&](std::size_t begin, std::size_t end) {
    int exponent = no_exponent;
    for (const Point& p : points.subspan(begin, end - begin)) {
      exponent = std::min(exponent, lowest_bit(p));
    }
    return exponent;
  };
  return power_of_two(parallel_reduce(execution, points.size(), no_exponent, lowest_of,
                                      [](int a, int b) { return std::min(a, b); }));
}

double common_unit(const Point& point) { return power_of_two(lowest_bit(point)); }

}  // namespace cocoon
