#include "delaunay/conflict_batch.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

#include "geom/common_unit.h"
#include "geom/insphere.h"

#ifndef COCOON_CONFLICT_BATCH_ONCE
#define COCOON_CONFLICT_BATCH_ONCE
namespace cocoon {

// Where the lanes find their cells and coordinates.
class Batch {
 public:
  Batch(const IdVector<CellId, Cell>& cells, const CellId* ids,
        const IdVector<VertexId, Point>& points)
      : coordinates_(&points.raw().data()->x),
        last_(static_cast<std::uint32_t>(points.size() - 2)) {
    for (std::size_t lane = 0; lane < conflict_batch_size; ++lane) lanes_[lane] = &cells[ids[lane]];
  }

  const double* corner(std::size_t lane, std::size_t slot) const {
    std::uint32_t vertex = lanes_[lane]->vertices[slot].value;
    if (slot == 3) vertex = std::min(vertex, last_);  // for the vertex at infinity, any other
    return coordinates_ + 3 * std::size_t{vertex};
  }
  unsigned infinite() const {
    unsigned bits = 0;
    for (std::size_t lane = 0; lane < conflict_batch_size; ++lane) {
      bits |= (lanes_[lane]->vertices[3] == infinite_vertex ? 1U : 0U) << lane;
    }
    return bits;
  }

 private:
  const double* coordinates_;
  std::uint32_t last_;  // the last vertex, before the element behind
  std::array<const Cell*, conflict_batch_size> lanes_;
};

}  // namespace cocoon
#endif

// Compile everything between HWY_BEFORE_NAMESPACE and HWY_AFTER_NAMESPACE once per instruction set.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "delaunay/conflict_batch.cpp"
#include <hwy/foreach_target.h>
// clang-format off: must come after foreach_target.h
#include <hwy/highway.h>
// clang-format on

HWY_BEFORE_NAMESPACE();
namespace cocoon::HWY_NAMESPACE {

#if HWY_TARGET == HWY_AVX2 || HWY_TARGET == HWY_AVX3 || HWY_TARGET == HWY_AVX3_DL

namespace hn = hwy::HWY_NAMESPACE;
using Lanes = hn::FixedTag<double, 4>;
using Vector = hn::Vec<Lanes>;

// The same vertex slot of four cells, relative to p, one vector per axis.
struct Corner {
  Vector x, y, z;
};

HWY_INLINE Corner load_corner(const Batch& batch, std::size_t slot, const Corner& p) {
  const Lanes d;
  const auto load = [&](std::size_t lane) { return hn::LoadU(d, batch.corner(lane, slot)); };
  const Vector v0 = load(0), v1 = load(1), v2 = load(2), v3 = load(3);
  const Vector low01 = hn::InterleaveLower(d, v0, v1);   // x0 x1 z0 z1
  const Vector high01 = hn::InterleaveUpper(d, v0, v1);  // y0 y1
  const Vector low23 = hn::InterleaveLower(d, v2, v3);
  const Vector high23 = hn::InterleaveUpper(d, v2, v3);
  return {hn::ConcatLowerLower(d, low23, low01) - p.x,
          hn::ConcatLowerLower(d, high23, high01) - p.y,
          hn::ConcatUpperUpper(d, low23, low01) - p.z};
}

HWY_INLINE Vector squared_norm(const Corner& v) { return v.x * v.x + v.y * v.y + v.z * v.z; }
HWY_INLINE Vector minor_xy(const Corner& v, const Corner& w) { return v.x * w.y - v.y * w.x; }

HWY_INLINE Vector largest(Vector a, Vector b, Vector c, Vector d) {
  return hn::Max(hn::Max(a, b), hn::Max(c, d));
}

// The expression, the bound and its derivation are those of insphere_filter.
BatchDecision decide(const Batch& batch, const Point& point, double exact_product) {
  const Lanes d;
  const Corner e{hn::Set(d, point.x), hn::Set(d, point.y), hn::Set(d, point.z)};
  const Corner p = load_corner(batch, 0, e);
  const Corner q = load_corner(batch, 1, e);
  const Corner r = load_corner(batch, 2, e);
  const Corner s = load_corner(batch, 3, e);
  const Vector pq = minor_xy(p, q);
  const Vector pr = minor_xy(p, r);
  const Vector ps = minor_xy(p, s);
  const Vector qr = minor_xy(q, r);
  const Vector qs = minor_xy(q, s);
  const Vector rs = minor_xy(r, s);
  const Vector pp = squared_norm(p);
  const Vector qq = squared_norm(q);
  const Vector rr = squared_norm(r);
  const Vector ss = squared_norm(s);
  const Vector value =
      (pp * (q.z * rs - r.z * qs + s.z * qr) - qq * (p.z * rs - r.z * ps + s.z * pr)) +
      (rr * (p.z * qs - q.z * ps + s.z * pq) - ss * (p.z * qr - q.z * pr + r.z * pq));
  const Vector reach_x = largest(hn::Abs(p.x), hn::Abs(q.x), hn::Abs(r.x), hn::Abs(s.x));
  const Vector reach_y = largest(hn::Abs(p.y), hn::Abs(q.y), hn::Abs(r.y), hn::Abs(s.y));
  const Vector reach_z = largest(hn::Abs(p.z), hn::Abs(q.z), hn::Abs(r.z), hn::Abs(s.z));
  const Vector product = (reach_x * reach_y * reach_z) * largest(pp, qq, rr, ss);
  const Vector error = hn::Set(d, insphere_filter_coefficient) * product;
  // Comparisons with NaN are false, so overflow decides nothing.
  const auto is_finite = hn::Le(hn::Abs(value), hn::Set(d, std::numeric_limits<double>::max()));
  const auto in_range =
      hn::Ge(hn::Min(hn::Min(reach_x, reach_y), reach_z), hn::Set(d, insphere_filter_smallest));
  const auto exact = hn::And(is_finite, hn::Le(product, hn::Set(d, exact_product)));
  const auto certain = hn::And(hn::And(is_finite, in_range), hn::Gt(hn::Abs(value), error));
  const auto decided = hn::Or(exact, certain);
  const auto inside = hn::And(decided, hn::Gt(value, hn::Zero(d)));
  const auto on_sphere = hn::And(exact, hn::Eq(value, hn::Zero(d)));
  const auto bits = [&](auto mask) {
    std::array<std::uint8_t, 8> bytes;  // StoreMaskBits may write this many
    hn::StoreMaskBits(d, mask, bytes.data());
    return bytes[0] & 0xFU;
  };
  return {bits(inside), bits(on_sphere), bits(decided) ^ 0xFU, batch.infinite()};
}

#else

BatchDecision decide(const Batch& batch, const Point& p, double exact_product) {
  const auto corner = [&](std::size_t lane, std::size_t slot) {
    const double* at = batch.corner(lane, slot);
    return Point{at[0], at[1], at[2]};
  };
  BatchDecision decision;
  for (std::size_t i = 0; i < conflict_batch_size; ++i) {
    const FilteredDeterminant filter =
        insphere_filter(corner(i, 0), corner(i, 1), corner(i, 2), corner(i, 3), p);
    const bool exact = std::fabs(filter.value) <= std::numeric_limits<double>::max() &&
                       filter.product <= exact_product;
    if (!exact && !filter.is_certain()) {
      decision.undecided |= 1U << i;
    } else if (filter.value > 0) {
      decision.inside |= 1U << i;
    } else if (filter.value == 0) {
      decision.on_sphere |= 1U << i;
    }
  }
  decision.infinite = batch.infinite();
  return decision;
}

#endif

}  // namespace cocoon::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace cocoon {

HWY_EXPORT(decide);

namespace {

// If all coordinates are multiples of `unit`, so are the differences, and every intermediate value
// of the determinant is an integer multiple of a power of it. The largest, the sums of the four
// summands, stay below 24 X Y Z L, so they are exact up to 2^53 unit^5; a squared length alone is,
// since the product of the three reaches is at least unit^3 or the whole value is zero. 2^48 leaves
// room for the factor 24 and for the rounding of the product.
double largest_exact_product(double unit) {
  // Inside this range unit^5 and the products are far from overflow and underflow.
  if (!(unit > 0x1p-100 && unit < 0x1p100)) return -1;
  return 0x1p48 * (unit * unit * unit * unit * unit);
}

}  // namespace

ConflictFilter::ConflictFilter(const IdVector<VertexId, Point>& points)
    : points_(points),
      unit_(common_unit(points.span())),
      exact_product_(largest_exact_product(unit_)) {}

void ConflictFilter::read_points_again() {
  unit_ = common_unit(points_.span());
  exact_product_ = largest_exact_product(unit_);
}

void ConflictFilter::admit(const Point& p) {
  if (exact_product_ < 0) return;
  const double unit = common_unit(p);
  if (unit == 0 || unit >= unit_) return;  // the origin is on every grid
  unit_ = unit;
  exact_product_ = largest_exact_product(unit);
}

BatchDecision ConflictFilter::test(const IdVector<CellId, Cell>& cells, const CellId* ids,
                                   const Point& p) const {
  static_assert(sizeof(Point) == 3 * sizeof(double));
  return HWY_DYNAMIC_DISPATCH(decide)(Batch(cells, ids, points_), p, exact_product_);
}

}  // namespace cocoon

#endif  // HWY_ONCE
