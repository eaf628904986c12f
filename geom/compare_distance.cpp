#include "geom/compare_distance.h"

#include <algorithm>
#include <limits>

#include "geom/exact/exact_determinants.h"

namespace cocoon {
namespace {

// Squares of differences of K limbs fit 2K, see geom/exact/exact_determinants.h; so does the
// difference of two of them.
template <std::size_t K>
Sign exact_compare(const Point& p, const Point& a, const Point& b, int unit) {
  return sign_of(exact_squared_norm<K>(exact_difference<K>(a, p, unit)) -
                 exact_squared_norm<K>(exact_difference<K>(b, p, unit)));
}

}  // namespace

// Filter: each square passes 2 + 1 roundings and at most 2 additions, so a computed squared norm is
// within 5.01 u of the true one; the difference of the two is within 5.01 u of their sum, plus its
// own rounding: 7 u of the computed sum covers all. Underflow adds less than 2^-1070, nothing
// against a sum of at least 2^-900. Overflow leaves the sum infinite.
Sign compare_distance(const Point& p, const Point& a, const Point& b) {
  const Vec3 to_a = a - p;
  const Vec3 to_b = b - p;
  const double squared_a = squared_norm(to_a);
  const double squared_b = squared_norm(to_b);
  const double sum = squared_a + squared_b;
  if (sum >= 0x1p-900 && sum <= std::numeric_limits<double>::max()) {
    const double difference = squared_a - squared_b;
    const double error = 7 * 0x1p-53 * sum;
    if (difference > error) return Sign::positive;
    if (difference < -error) return Sign::negative;
  }
  const double reach = std::max(max_norm(to_a), max_norm(to_b));
  const CommonGrid grid = common_grid<9>({p.x, p.y, p.z, a.x, a.y, a.z, b.x, b.y, b.z}, reach);
  return in_fewest_limbs(grid,
                         [&]<std::size_t K>() { return exact_compare<K>(p, a, b, grid.unit); });
}

}  // namespace cocoon
