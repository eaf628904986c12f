#include "geom/insphere.h"

#include "geom/exact/exact_determinants.h"
#include "geom/exact/predicate_levels.h"

namespace cocoon {

namespace {

// The 3 x 3 determinant det[p; q; r] with all signs positive.
double permanent_of(const Vec3& p, const Vec3& q, const Vec3& r) {
  const auto minor = [](const Vec3& s, const Vec3& t) {
    return std::fabs(s.x * t.y) + std::fabs(s.y * t.x);
  };
  return std::fabs(p.z) * minor(q, r) + std::fabs(q.z) * minor(p, r) + std::fabs(r.z) * minor(p, q);
}

}  // namespace

// As in insphere_filter each product passes 16 roundings, so |error| < 16.01 u * permanent, the
// determinant with all signs positive. The computed permanent is at least (1 - u)^16 times the
// true one: 17 u of it is enough. Underflow is paid for by 2^-60 of the first filter's bound.
FilteredDeterminant insphere_permanent(const Point& a, const Point& b, const Point& c,
                                       const Point& d, const Point& e) {
  if (a.x == e.x && b.x == e.x && c.x == e.x && d.x == e.x) return {0, 0};
  if (a.y == e.y && b.y == e.y && c.y == e.y && d.y == e.y) return {0, 0};
  if (a.z == e.z && b.z == e.z && c.z == e.z && d.z == e.z) return {0, 0};
  const FilteredDeterminant filter = insphere_filter(a, b, c, d, e);
  const Vec3 p = a - e;
  const Vec3 q = b - e;
  const Vec3 r = c - e;
  const Vec3 s = d - e;
  const double permanent =
      squared_norm(p) * permanent_of(q, r, s) + squared_norm(q) * permanent_of(p, r, s) +
      squared_norm(r) * permanent_of(p, q, s) + squared_norm(s) * permanent_of(p, q, r);
  return {filter.value, 17 * 0x1p-53 * permanent + 0x1p-60 * filter.error};
}

PredicateDecision insphere_on_grid(const Point& a, const Point& b, const Point& c, const Point& d,
                                   const Point& e, PredicateLevel narrowest) {
  const double reach = std::max(std::max(max_norm(a - e), max_norm(b - e)),
                                std::max(max_norm(c - e), max_norm(d - e)));
  const CommonGrid grid = common_grid<15>(
      {a.x, a.y, a.z, b.x, b.y, b.z, c.x, c.y, c.z, d.x, d.y, d.z, e.x, e.y, e.z}, reach);
  const std::array<Point, 5> points = {a, b, c, d, e};
  const auto decide = [&]<std::size_t K>() {
    return PredicateDecision{exact_insphere<K>(points, grid.unit), level_of_limbs(K)};
  };
  return in_fewest_limbs(grid, decide, limbs_of(narrowest));
}

namespace {

PredicateDecision decide_after_filter(const Point& a, const Point& b, const Point& c,
                                      const Point& d, const Point& e) {
  const FilteredDeterminant permanent = insphere_permanent(a, b, c, d, e);
  if (permanent.is_certain() || permanent.error == 0)
    return {sign_of(permanent.value), PredicateLevel::permanent};
  return insphere_on_grid(a, b, c, d, e);
}

}  // namespace

PredicateDecision decide_insphere(const Point& a, const Point& b, const Point& c, const Point& d,
                                  const Point& e) {
  const FilteredDeterminant filter = insphere_filter(a, b, c, d, e);
  if (filter.is_certain()) return {sign_of(filter.value), PredicateLevel::filter};
  return decide_after_filter(a, b, c, d, e);
}

Sign insphere_after_filter(const Point& a, const Point& b, const Point& c, const Point& d,
                           const Point& e) {
  return decide_after_filter(a, b, c, d, e).sign;
}

}  // namespace cocoon
