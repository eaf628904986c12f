// On which side of the spheres of the four cells around a cell does a point lie? In SIMD lanes; the
// same on every instruction set. It opens its namespaces itself: include it after
// hwy/foreach_target.h, outside of any.
#if defined(COCOON_NEIGHBOR_TESTS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef COCOON_NEIGHBOR_TESTS_INL_H
#undef COCOON_NEIGHBOR_TESTS_INL_H
#else
#define COCOON_NEIGHBOR_TESTS_INL_H
#endif

#include <array>

#include "delaunay/kernel/filter_bounds.h"
#include "geom/lanes/double_words-inl.h"
#include "geom/lanes/four_lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace cocoon::HWY_NAMESPACE {

// One bit for each facet of a cell, about the cell behind it.
struct NeighborDecision {
  unsigned inside;     // its circumsphere contains the point; only for cells that are not open
  unsigned open;       // neither filter nor perturbation can tell, or the cell is infinite
  unsigned on_sphere;  // certainly: the point lies on the circumsphere of a finite cell
  unsigned unsure;     // finite cells that are open, and may be so only for want of precision
};

// Lane i: corner i of a cell, and the fourth vertex of the cell behind facet i.
struct NeighborPoints {
  FourVectors corners, apexes;
};

// Points, each with the coefficient of its lift in the determinant of insphere.
struct Lifted {
  FourVectors point;
  Four coefficient;
};

// The same as break_cospherical_tie, in each lane: the sign of the coefficient of the lift that is
// raised most, that of the point of highest lexicographic rank. Zero if the next rank decides. All
// is relative to the point that is new, whose own coefficient is negative.
HWY_INLINE Four perturbed_value(const std::array<Lifted, 4>& corners) {
  const Four zero = broadcast(0);
  Lifted top{{zero, zero, zero}, broadcast(-1)};
  for (const Lifted& corner : corners) {
    const FourVectors& v = corner.point;
    const FourVectors& t = top.point;
    const FourMask above = either(
        greater(v.x, t.x),
        both(equal(v.x, t.x), either(greater(v.y, t.y), both(equal(v.y, t.y), greater(v.z, t.z)))));
    top = {{choose(above, v.x, t.x), choose(above, v.y, t.y), choose(above, v.z, t.z)},
           choose(above, corner.coefficient, top.coefficient)};
  }
  return top.coefficient;
}

// What the determinant of insphere in each lane is made of: the squared lengths of a facet's
// corners p, q, r and of the apex s, and 3 x 3 minors, all relative to the point.
template <class Number>
struct InsphereParts {
  Number pp, qq, rr, ss;
  Number qrs, prs, pqs, pqr;
};

// The four cells share three vertices each with the one between them, and with each other many of
// the 2 x 2 minors. The expressions are those of insphere_filter.
template <class Number, class Vectors>
HWY_INLINE InsphereParts<Number> insphere_parts(const Vectors& p, const Vectors& q,
                                                const Vectors& r, const Vectors& s,
                                                const Number& vv) {
  const Number pq = minor_xy(p, q);
  const Number pr = minor_xy(p, r);
  const Number ps = minor_xy(p, s);
  const Number qr = rotate<1>(pq);
  const Number qs = minor_xy(q, s);
  const Number rs = minor_xy(r, s);
  return {rotate<1>(vv),
          rotate<2>(vv),
          rotate<3>(vv),
          squared_norm(s),
          alternating_sum(q.z, rs, r.z, qs, s.z, qr),
          alternating_sum(p.z, rs, r.z, ps, s.z, pr),
          alternating_sum(p.z, qs, q.z, ps, s.z, pq),
          alternating_sum(p.z, qr, q.z, pr, r.z, pq)};
}

// Where `value` is certain: its square is beyond the bound (delaunay/kernel/filter_bounds.h).
HWY_INLINE unsigned is_certain(const Four& value, const Four& reach, double coefficient) {
  const Four reach_2 = reach * reach;
  const Four error_2 =
      broadcast(coefficient) * (reach_2 * reach_2 * reach) + broadcast(insphere_smallest);
  return is_greater(value * value, error_2);
}

// Decides again, in pairs of doubles, the cells of `unsure`, which doubles left open. A value that
// is not zero is certain up to the squared length `exact_reach`.
HWY_INLINE NeighborDecision test_again(const NeighborPoints& points, const FourVectors& origin,
                                       unsigned unsure, double exact_reach) {
  const FourWideVectors v = wide_difference(points.corners, origin);
  const FourWideVectors s = wide_difference(points.apexes, origin);
  const auto [pp, qq, rr, ss, qrs, prs, pqs, pqr] =
      insphere_parts(rotate<1>(v), rotate<2>(v), rotate<3>(v), s, squared_norm(v));
  const FourWide sum = (pp * qrs - qq * prs) + (rr * pqs - ss * pqr);
  const Four value = alternate_signs(sum.high + sum.low);
  const Four reach = larger(larger(pp.high, qq.high), larger(rr.high, ss.high));
  const unsigned open = unsure & ~is_certain(value, reach, wide_insphere_coefficient);
  return {unsure & is_greater(value, broadcast(0)), open,
          open & ~is_greater(reach, broadcast(exact_reach)), 0};
}

// `infinite` are lanes that do not count; all is exact up to the squared length `exact_reach`.
HWY_INLINE NeighborDecision test_neighbors(const NeighborPoints& points, const FourVectors& origin,
                                           unsigned infinite, double exact_reach) {
  const FourVectors v = points.corners - origin;
  const FourVectors s = points.apexes - origin;
  const FourVectors p = rotate<1>(v);
  const FourVectors q = rotate<2>(v);
  const FourVectors r = rotate<3>(v);
  const auto [pp, qq, rr, ss, qrs, prs, pqs, pqr] = insphere_parts(p, q, r, s, squared_norm(v));
  const Four value =
      alternate_signs(multiply_subtract(pp, qrs, qq * prs) + multiply_subtract(rr, pqs, ss * pqr));
  const Four reach = larger(larger(pp, qq), larger(rr, ss));
  const unsigned certain = is_certain(value, reach, insphere_coefficient);
  const unsigned inside = is_greater(value, broadcast(0));
  NeighborDecision decision{inside, (~certain & 0xFU) | infinite, 0, 0};
  if (decision.open == 0) [[likely]]
    return decision;
  // Where the value is exact, so are its cofactors and the differences of coordinates.
  const unsigned exact = ~(is_greater(reach, broadcast(exact_reach)) | infinite) & 0xFU;
  if ((decision.open & exact) != 0) {
    const unsigned zero = ~(inside | is_greater(broadcast(0), value));
    const Four zero_minus = broadcast(0);
    const Four tie_break = perturbed_value(
        {Lifted{p, alternate_signs(qrs)}, Lifted{q, zero_minus - alternate_signs(prs)},
         Lifted{r, alternate_signs(pqs)}, Lifted{s, zero_minus - alternate_signs(pqr)}});
    decision.on_sphere = exact & zero;
    decision.inside |= decision.on_sphere & is_greater(tie_break, broadcast(0));
    decision.open &= ~exact | (zero & bits_of(equal(tie_break, broadcast(0))));
  }
  decision.unsure = decision.open & ~(exact | infinite);
  return decision;
}

}  // namespace cocoon::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
