#include "geom/exact/common_unit.h"

#include <algorithm>
#include <cmath>

#include "geom/exact/exact_integer.h"
#include "geom/parallel/parallel_reduce.h"

namespace cocoon {
namespace {

constexpr int no_exponent = 2000;  // above every exponent of a double

// The exponent of the lowest bit that is set in `value`.
int lowest_bit(double value) {
  const DyadicDouble parts = take_apart(value);
  return parts.mantissa == 0 ? no_exponent : parts.exponent;
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
