#include "geom/perturbation.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cstddef>

#include "geom/insphere.h"
#include "geom/orient3d.h"

namespace cocoon {

namespace {

// The determinant of insphere is linear in the lifts |p|^2 of its five points. This is the sign of
// the coefficient of one lift: for e it is -orient3d(a, b, c, d); for any other point, by exchange
// of rows, orient3d with e in the place of that point.
Sign lift_coefficient(std::array<Point, 5> p, std::size_t lifted) {
  if (lifted == 4) return Sign::negative;  // orient3d(a, b, c, d) > 0 is the precondition
  p[lifted] = p[4];
  return orient3d(p[0], p[1], p[2], p[3]);
}

// Adds eps_i to the lift of the point of rank i, with eps_0 << eps_1 << ... << eps_4 << 1. As the
// unperturbed determinant is zero, its sign is that of the first nonzero coefficient from the top
// rank down.
Sign break_tie(const std::array<Point, 5>& p) {
  std::array<std::size_t, 5> by_rank = {0, 1, 2, 3, 4};
  std::sort(by_rank.begin(), by_rank.end(),
            [&p](std::size_t i, std::size_t j) { return p[i] > p[j]; });
  for (const std::size_t lifted : by_rank) {
    const Sign sign = lift_coefficient(p, lifted);
    if (sign != Sign::zero) return sign;
  }
  assert(false);  // e ranks somewhere, and its coefficient is negative
  return Sign::zero;
}

}  // namespace

// Two ranks are enough: if the coefficients of, say, c and d vanish, e lies in the planes abd and
// abc, hence on the line ab; but that line meets the sphere in a and b only, and e is neither.
Sign insphere_perturbed(const Point& a, const Point& b, const Point& c, const Point& d,
                        const Point& e) {
  const Sign sign = insphere(a, b, c, d, e);
  if (sign != Sign::zero) return sign;
  if (e == a || e == b || e == c || e == d) return Sign::zero;
  return break_tie({a, b, c, d, e});
}

}  // namespace cocoon
