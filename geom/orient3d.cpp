#include "geom/orient3d.h"

#include "geom/exact/exact_determinants.h"
#include "geom/exact/predicate_levels.h"

namespace cocoon {

// As in orient3d_filter each product passes 8 roundings, so |error| < 8.01 u * permanent, the
// determinant with all signs positive. The computed permanent is at least (1 - u)^8 times the true
// one: 9 u of it is enough. Underflow is paid for by 2^-60 of the first filter's bound.
FilteredDeterminant orient3d_permanent(const Point& a, const Point& b, const Point& c,
                                       const Point& d) {
  if (b.x == a.x && c.x == a.x && d.x == a.x) return {0, 0};
  if (b.y == a.y && c.y == a.y && d.y == a.y) return {0, 0};
  if (b.z == a.z && c.z == a.z && d.z == a.z) return {0, 0};
  const FilteredDeterminant filter = orient3d_filter(a, b, c, d);
  const Vec3 p = b - a;
  const Vec3 q = c - a;
  const Vec3 r = d - a;
  const double permanent = std::fabs(p.x) * (std::fabs(q.y * r.z) + std::fabs(q.z * r.y)) +
                           std::fabs(p.y) * (std::fabs(q.z * r.x) + std::fabs(q.x * r.z)) +
                           std::fabs(p.z) * (std::fabs(q.x * r.y) + std::fabs(q.y * r.x));
  return {filter.value, 9 * 0x1p-53 * permanent + 0x1p-60 * filter.error};
}

PredicateDecision orient3d_on_grid(const Point& a, const Point& b, const Point& c, const Point& d,
                                   PredicateLevel narrowest) {
  const double reach = std::max(std::max(max_norm(b - a), max_norm(c - a)), max_norm(d - a));
  const CommonGrid grid =
      common_grid<12>({a.x, a.y, a.z, b.x, b.y, b.z, c.x, c.y, c.z, d.x, d.y, d.z}, reach);
  const std::array<Point, 4> points = {a, b, c, d};
  const auto decide = [&]<std::size_t K>() {
    return PredicateDecision{exact_orient3d<K>(points, grid.unit), level_of_limbs(K)};
  };
  return in_fewest_limbs(grid, decide, limbs_of(narrowest));
}

namespace {

PredicateDecision decide_after_filter(const Point& a, const Point& b, const Point& c,
                                      const Point& d) {
  const FilteredDeterminant permanent = orient3d_permanent(a, b, c, d);
  if (permanent.is_certain() || permanent.error == 0)
    return {sign_of(permanent.value), PredicateLevel::permanent};
  return orient3d_on_grid(a, b, c, d);
}

}  // namespace

PredicateDecision decide_orient3d(const Point& a, const Point& b, const Point& c, const Point& d) {
  const FilteredDeterminant filter = orient3d_filter(a, b, c, d);
  if (filter.is_certain()) return {sign_of(filter.value), PredicateLevel::filter};
  return decide_after_filter(a, b, c, d);
}

Sign orient3d_after_filter(const Point& a, const Point& b, const Point& c, const Point& d) {
  return decide_after_filter(a, b, c, d).sign;
}

// Each of the two products passes 2 subtractions, 1 multiplication, 1 subtraction: |error| <
// 4.01 u (|left| + |right|); 5 u of the computed sum covers its own rounding. Underflow adds at
// most 2^-1074, which the rest covers if the sum is at least 2^-900. Overflow leaves the
// determinant infinite or NaN.
Sign orient2d(double ax, double ay, double bx, double by, double cx, double cy) {
  const double left = (bx - ax) * (cy - ay);
  const double right = (by - ay) * (cx - ax);
  const double determinant = left - right;
  const double permanent = std::fabs(left) + std::fabs(right);
  const double error = 5 * 0x1p-53 * permanent;
  if (permanent >= 0x1p-900 && permanent <= std::numeric_limits<double>::max()) {
    if (determinant > error) return Sign::positive;
    if (determinant < -error) return Sign::negative;
  }
  if ((ax == bx && ax == cx) || (ay == by && ay == cy)) return Sign::zero;

  const double reach = std::max(std::max(std::fabs(bx - ax), std::fabs(by - ay)),
                                std::max(std::fabs(cx - ax), std::fabs(cy - ay)));
  const std::array<double, 6> xy = {ax, ay, bx, by, cx, cy};
  const CommonGrid grid = common_grid(xy, reach);
  return in_fewest_limbs(grid, [&]<std::size_t K>() { return exact_orient2d<K>(xy, grid.unit); });
}

bool are_collinear(const Point& a, const Point& b, const Point& c) {
  return orient2d(a.x, a.y, b.x, b.y, c.x, c.y) == Sign::zero &&
         orient2d(a.y, a.z, b.y, b.z, c.y, c.z) == Sign::zero &&
         orient2d(a.z, a.x, b.z, b.x, c.z, c.x) == Sign::zero;
}

}  // namespace cocoon
