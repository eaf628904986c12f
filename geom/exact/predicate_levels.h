// The levels of the exact predicates, one function each. For tests, benchmarks and readers; callers
// want orient3d.h and insphere.h, which run these from top to bottom until one is certain.
#pragma once

#include <cstddef>

#include "geom/insphere.h"
#include "geom/orient3d.h"

namespace cocoon {

enum class PredicateLevel {
  filter,     // floating point, bound from the extent of the points on each axis
  permanent,  // floating point, bound from the products that occur; and points in a plane
              // x, y or z = const
  grid_64,    // integers, differences below 2^62 units of the common grid
  grid_128,   // integers, differences below 2^126 units
  grid_256,   // integers, differences below 2^254 units
  grid_512,   // integers, differences below 2^510 units
  wide,       // integers as wide as the range of double
};

// Of the integer levels: how many 64-bit limbs hold a difference of coordinates.
constexpr std::size_t limbs_of(PredicateLevel level) {
  return level <= PredicateLevel::grid_64    ? 1
         : level == PredicateLevel::grid_128 ? 2
         : level == PredicateLevel::grid_256 ? 4
         : level == PredicateLevel::grid_512 ? 8
                                             : 33;
}
constexpr PredicateLevel level_of_limbs(std::size_t limbs) {
  return limbs == 1   ? PredicateLevel::grid_64
         : limbs == 2 ? PredicateLevel::grid_128
         : limbs == 4 ? PredicateLevel::grid_256
         : limbs == 8 ? PredicateLevel::grid_512
                      : PredicateLevel::wide;
}

struct PredicateDecision {
  Sign sign = Sign::zero;
  PredicateLevel level = PredicateLevel::filter;
};

// Same sign as orient3d and insphere, and the level that knew it.
PredicateDecision decide_orient3d(const Point& a, const Point& b, const Point& c, const Point& d);
PredicateDecision decide_insphere(const Point& a, const Point& b, const Point& c, const Point& d,
                                  const Point& e);

// The second filters; `error` 0 with `value` 0 says an exact zero.
FilteredDeterminant orient3d_permanent(const Point& a, const Point& b, const Point& c,
                                       const Point& d);
FilteredDeterminant insphere_permanent(const Point& a, const Point& b, const Point& c,
                                       const Point& d, const Point& e);

// The integer levels. The level used is the narrowest that holds the differences, but not below
// `narrowest` (grid_64 or wider).
PredicateDecision orient3d_on_grid(const Point& a, const Point& b, const Point& c, const Point& d,
                                   PredicateLevel narrowest = PredicateLevel::grid_64);
PredicateDecision insphere_on_grid(const Point& a, const Point& b, const Point& c, const Point& d,
                                   const Point& e,
                                   PredicateLevel narrowest = PredicateLevel::grid_64);

}  // namespace cocoon
