#include "geom/perturbation.h"

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
Sign lift_coefficient(const std::array<Point, 5>& p, std::size_t lifted) {
  if (lifted == 4) return Sign::negative;  // orient3d(a, b, c, d) > 0 is the precondition
  const auto row = [&](std::size_t i) -> const Point& { return p[i == lifted ? 4 : i]; };
  return orient3d(row(0), row(1), row(2), row(3));
}

// 1 if p > q lexicographically, else 0, without branches: on grids any coordinates may be equal.
unsigned ranks_above(const Point& p, const Point& q) {
  const auto greater = [](double a, double b) { return static_cast<unsigned>(a > b); };
  const auto not_less = [](double a, double b) { return static_cast<unsigned>(a >= b); };
  return greater(p.x, q.x) |
         (not_less(p.x, q.x) & (greater(p.y, q.y) | (not_less(p.y, q.y) & greater(p.z, q.z))));
}

// Adds eps_i to the lift of the point of rank i, with eps_0 << eps_1 << ... << eps_4 << 1. As the
// unperturbed determinant is zero, its sign is that of the first nonzero coefficient from the top
// rank down.
Sign break_tie(const std::array<Point, 5>& p) {
  std::array<std::size_t, 5> left = {0, 1, 2, 3, 4};
  for (std::size_t count = 5; count > 0; --count) {
    // Mostly the first or second rank decides: select the top instead of sorting.
    std::size_t top = 0;
    for (std::size_t i = 1; i < count; ++i) {
      const std::size_t above = ranks_above(p[left[i]], p[left[top]]);
      top ^= (top ^ i) & (0 - above);
    }
    const Sign sign = lift_coefficient(p, left[top]);
    if (sign != Sign::zero) return sign;
    left[top] = left[count - 1];
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

Sign break_cospherical_tie(const Point& a, const Point& b, const Point& c, const Point& d,
                           const Point& e) {
  return break_tie({a, b, c, d, e});
}

}  // namespace cocoon
