#include "delaunay/kernel/conflict_search.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>

#include "geom/exact/common_unit.h"
#include "geom/insphere.h"
#include "geom/lanes/vector_dispatch.h"
#include "geom/orient3d.h"
#include "geom/perturbation.h"

#ifndef COCOON_CONFLICT_SEARCH_ONCE
#define COCOON_CONFLICT_SEARCH_ONCE
namespace cocoon {

// One search, as the loops below see it whatever their instruction set.
struct SearchView {
  const Cell* cells;
  CellMark* marks;
  const double* coordinates;
  double exact_reach;
  Point p;
  const IdVector<VertexId, Point>& points;
  DelaunayCounters& counters;
  ClaimHolder* holder;
  bool has_infinite = false;  // has one come into view?

  const Cell& cell_behind(FacetId outer) const { return cells[cell_of(outer).index()]; }
  const double* point(VertexId v) const { return coordinates + 3 * v.index(); }
  VertexId apex(FacetId outer) const {
    return cell_behind(outer).vertices[static_cast<std::size_t>(index_of(outer))];
  }

  bool in_conflict(const Cell& cell) const;
  bool in_conflict_on_sphere(const Cell& cell) const;
  unsigned decide_open(const std::array<FacetId, 4>& outer, unsigned inside, unsigned open,
                       unsigned on_sphere);
  unsigned facets_beyond(const Cell& cell, unsigned facets) const;

  // Holds the vertices of a cell that a walk enters through one of its facets, if others let it. A
  // long walk gives back what it left behind.
  bool hold_on_the_way(FacetId entry) const {
    constexpr std::size_t many = 64;
    if (!holder->take(apex(entry))) return false;
    if (holder->num_held() > many) [[unlikely]]
      holder->release_but(cell_behind(entry));
    return true;
  }
};

// The loops compute what insphere_filter and orient3d_filter do, but round only once where a
// product is added: each error that is missing can only tighten the bounds that are derived there.
//
// The filters of the loops bound X, Y, Z, the largest |difference| on each axis, by the root of L,
// the largest squared length, which is at hand: sqrt(L) (1 + 2 u) is at least each, u = 2^-53. So
// by the derivations in geom/insphere.h and geom/orient3d.h the errors are below 384.02 u L^(5/2)
// and 48.02 u L^(3/2). What is compared are squares, value^2 > coefficient L^5 + smallest; rounding
// them costs less than 8 u, for which 385 and 49 have room. If L overflows, or its power does, the
// bound is infinite and decides nothing; if it does not, neither does the value. If L is so small,
// below 2^-180, that underflow might count, |value| is below 24.1 L^(5/2) or 6.1 L^(3/2), and its
// square below `smallest`.
constexpr double square(double a) { return a * a; }
inline constexpr double insphere_coefficient = square(385 * 0x1p-53);
inline constexpr double insphere_smallest = 0x1p-890;
inline constexpr double orient3d_coefficient = square(49 * 0x1p-53);
inline constexpr double orient3d_smallest = 0x1p-534;

}  // namespace cocoon
#endif

// Compile everything between HWY_BEFORE_NAMESPACE and HWY_AFTER_NAMESPACE once per instruction set.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "delaunay/kernel/conflict_search.cpp"
#include <hwy/foreach_target.h>
// clang-format off: must come after foreach_target.h
#include "geom/lanes/four_lanes-inl.h"
// clang-format on

HWY_BEFORE_NAMESPACE();
namespace cocoon::HWY_NAMESPACE {

// Vertices are fewer than cells, so fewer than 2^30; the one at infinity has the highest bit set.
HWY_INLINE bool has_infinite(const std::array<VertexId, 4>& vertices, VertexId fifth) {
  static_assert(max_cells <= std::size_t{1} << 31);
  return ((vertices[0].value | vertices[1].value | vertices[2].value | vertices[3].value |
           fifth.value) >>
          31) != 0;
}

// One bit for each facet of a cell, about the cell behind it.
struct NeighborDecision {
  unsigned inside;     // its circumsphere contains the point; only for cells that are not open
  unsigned open;       // neither filter nor perturbation can tell, or the cell is infinite
  unsigned on_sphere;  // certainly: the point lies on the circumsphere of a finite cell
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

// Puts another vertex in the place of that at infinity, whether it is the last corner or an apex.
// Returns the lanes that do not count then.
HWY_INLINE unsigned replace_infinite(const Cell& cell, VertexId& last,
                                     std::array<VertexId, 4>& apexes) {
  unsigned infinite = 0;
  // An infinite cell has three infinite neighbors, behind the facets with the vertex at infinity.
  if (last == infinite_vertex) infinite = 0x7U;
  if (last == infinite_vertex) last = cell.vertices[0];
  for (unsigned i = 0; i < 4; ++i) {
    if (apexes[i] != infinite_vertex) continue;
    infinite |= 1U << i;
    apexes[i] = cell.vertices[0];
  }
  return infinite;
}

// The four cells around a cell in SIMD lanes, lane i behind its facet i. They share three vertices
// each with it, and with each other many of the 2 x 2 minors. `apexes` are the fourth vertices. The
// expression is that of insphere_filter, of the facet's corners and then the apex.
HWY_INLINE NeighborDecision decide_neighbors(SearchView& view, const Cell& cell,
                                             const std::array<VertexId, 4>& apexes,
                                             const FourVectors& origin) {
  VertexId last = cell.vertices[3];
  std::array<VertexId, 4> tips = apexes;
  unsigned infinite = 0;
  if (has_infinite(apexes, last)) [[unlikely]] {
    view.has_infinite = true;
    infinite = replace_infinite(cell, last, tips);
  }
  const FourVectors v = load_points(view.point(cell.vertices[0]), view.point(cell.vertices[1]),
                                    view.point(cell.vertices[2]), view.point(last)) -
                        origin;
  const FourVectors s = load_points(view.point(tips[0]), view.point(tips[1]), view.point(tips[2]),
                                    view.point(tips[3])) -
                        origin;
  // Corners (1, 2, 3), (2, 3, 0), (3, 0, 1), (0, 1, 2): every second is a reflection.
  const FourVectors p = rotate<1>(v);
  const FourVectors q = rotate<2>(v);
  const FourVectors r = rotate<3>(v);
  const Four vv = squared_norm(v);
  const Four pp = rotate<1>(vv);
  const Four qq = rotate<2>(vv);
  const Four rr = rotate<3>(vv);
  const Four ss = squared_norm(s);
  const Four pq = minor_xy(p, q);
  const Four pr = minor_xy(p, r);
  const Four ps = minor_xy(p, s);
  const Four qr = rotate<1>(pq);
  const Four qs = minor_xy(q, s);
  const Four rs = minor_xy(r, s);
  const Four qrs = alternating_sum(q.z, rs, r.z, qs, s.z, qr);
  const Four prs = alternating_sum(p.z, rs, r.z, ps, s.z, pr);
  const Four pqs = alternating_sum(p.z, qs, q.z, ps, s.z, pq);
  const Four pqr = alternating_sum(p.z, qr, q.z, pr, r.z, pq);
  const Four value =
      alternate_signs(multiply_subtract(pp, qrs, qq * prs) + multiply_subtract(rr, pqs, ss * pqr));
  const Four reach = larger(larger(pp, qq), larger(rr, ss));
  const Four reach_2 = reach * reach;
  const Four error_2 =
      broadcast(insphere_coefficient) * (reach_2 * reach_2 * reach) + broadcast(insphere_smallest);
  const unsigned certain = is_greater(value * value, error_2);
  const unsigned inside = is_greater(value, broadcast(0));
  NeighborDecision decision{inside, (~certain & 0xFU) | infinite, 0};
  if (decision.open == 0) [[likely]]
    return decision;
  // Where the value is exact, so are its cofactors and the differences of coordinates.
  const unsigned exact = ~(is_greater(reach, broadcast(view.exact_reach)) | infinite) & 0xFU;
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
  return decision;
}

// Bit i to byte i.
HWY_INLINE std::uint32_t spread_bits(unsigned four_bits) {
  return (four_bits * 0x204081U) & 0x1010101U;
}

// Breadth first. Nothing here branches on the result of a test: no branch predictor could learn it.
// Returns whether all was found: not if another thread is in the way.
template <bool beside_others>
bool search_zone(SearchView& view, ConflictZone& zone, CellId start) {
  const FourVectors origin{broadcast(view.p.x), broadcast(view.p.y), broadcast(view.p.z)};
  ZoneLists lists = zone.start_lists();
  std::size_t num_cells = 1;
  std::size_t num_border = 0;
  lists.cells[0] = start;
  std::copy_n(view.cells[start.index()].vertices.begin(), 4, lists.vertices);
  view.marks[start.index()] = CellMark::conflict;
  CellId next = start;
  for (std::size_t expanded = 0; expanded < num_cells; ++expanded) {
    // The other corners are held with the cell that it was found from.
    if (beside_others && !view.holder->take(lists.vertices[expanded + 3])) [[unlikely]] {
      zone.finish(num_cells, num_border, view.has_infinite);
      return false;
    }
    const Cell& cell = view.cells[next.index()];
    const bool knows_next = expanded + 1 < num_cells;
    next = lists.cells[expanded + 1];
    const std::array<FacetId, 4>& outer = cell.neighbors;
    const CellId n0 = cell_of(outer[0]), n1 = cell_of(outer[1]);
    const CellId n2 = cell_of(outer[2]), n3 = cell_of(outer[3]);
    const std::array<VertexId, 4> apexes = {view.apex(outer[0]), view.apex(outer[1]),
                                            view.apex(outer[2]), view.apex(outer[3])};
    const auto is_known = [&](CellId c) { return static_cast<unsigned>(view.marks[c.index()]); };
    const unsigned known =
        (is_known(n0) + 2 * is_known(n1)) + 4 * (is_known(n2) + 2 * is_known(n3));
    NeighborDecision decision = decide_neighbors(view, cell, apexes, origin);
    decision.open &= ~known;
    if ((decision.open | decision.on_sphere) != 0) [[unlikely]] {
      view.counters.perturbed_inspheres +=
          static_cast<std::size_t>(std::popcount(decision.on_sphere & ~known));
      decision.inside = view.decide_open(outer, decision.inside, decision.open, decision.on_sphere);
    }
    const unsigned inside = decision.inside & ~known;
    const unsigned outside = ~decision.inside & ~known & 0xFU;
    const std::uint32_t marks = spread_bits(known | inside);
    view.marks[n0.index()] = static_cast<CellMark>(marks & 1U);
    view.marks[n1.index()] = static_cast<CellMark>((marks >> 8) & 1U);
    view.marks[n2.index()] = static_cast<CellMark>((marks >> 16) & 1U);
    view.marks[n3.index()] = static_cast<CellMark>(marks >> 24);
    num_border += append(&outer[0].value, outside, &lists.border[num_border].value);
    append(&apexes[0].value, inside, &lists.vertices[num_cells + 3].value);
    num_cells += append<2>(&outer[0].value, inside, &lists.cells[num_cells].value);  // cell_of
    if (num_cells + 4 > lists.capacity) [[unlikely]] {
      lists = zone.grow();
    }
    if (!knows_next) [[unlikely]]
      next = lists.cells[expanded + 1];
  }
  view.counters.conflict_tests += num_cells - 1 + num_border;  // each test has found one of them
  zone.finish(num_cells, num_border, view.has_infinite);
  return true;
}

bool find_zone(SearchView& view, ConflictZone& zone, CellId start) {
  return view.holder == nullptr ? search_zone<false>(view, zone, start)
                                : search_zone<true>(view, zone, start);
}

// In lane i the facet opposite vertex i of one cell: the determinant of its corners relative to p,
// positive where p lies on the inner side.
struct Facets {
  Four side;
  Four lift;   // squared distances of the vertices from p
  Four reach;  // the largest of them, in all lanes
};

HWY_INLINE Facets facets_of(const SearchView& view, const Cell& cell, const FourVectors& origin) {
  const FourVectors v = load_points(view.point(cell.vertices[0]), view.point(cell.vertices[1]),
                                    view.point(cell.vertices[2]), view.point(cell.vertices[3])) -
                        origin;
  // Corners (1, 2, 3), (2, 3, 0), (3, 0, 1), (0, 1, 2): every second is a reflection.
  const FourVectors a = rotate<1>(v);
  const FourVectors b = rotate<2>(v);
  const FourVectors c = rotate<3>(v);
  const Four ab = minor_xy(a, b);
  const Four bc = rotate<1>(ab);
  const Four ac = minor_xy(a, c);
  const Four determinant = alternating_sum(a.z, bc, b.z, ac, c.z, ab);
  const Four lift = squared_norm(v);
  const Four pairs = larger(lift, rotate<2>(lift));
  return {alternate_signs(determinant), lift, larger(pairs, rotate<1>(pairs))};
}

// The first facet of a finite cell that has p strictly beyond it; -1 if there is none, or if the
// circumsphere certainly contains p. Its determinant, along the column of the squared distances, is
// their sum weighted by the sides.
HWY_INLINE int exit_facet(SearchView& view, const Cell& cell, const FourVectors& origin) {
  const Facets facets = facets_of(view, cell, origin);
  std::array<double, 4> summands;
  store(facets.lift * facets.side, summands.data());
  const double value = (summands[0] + summands[1]) + (summands[2] + summands[3]);
  const double reach = first_lane(facets.reach);
  const double reach_2 = reach * reach;
  const double error_2 = insphere_coefficient * (reach_2 * reach_2 * reach) + insphere_smallest;
  if (value > 0 && value * value > error_2) return -1;
  const Four error_orient =
      broadcast(orient3d_coefficient) * (facets.reach * facets.reach * facets.reach) +
      broadcast(orient3d_smallest);
  const unsigned certain = is_greater(facets.side * facets.side, error_orient);
  unsigned beyond = is_greater(broadcast(0), facets.side) & certain;
  if (certain != 0xFU) [[unlikely]] {
    beyond |= view.facets_beyond(cell, ~certain & 0xFU);
  }
  return beyond == 0 ? -1 : std::countr_zero(beyond);
}

CellId find_start(SearchView& view, CellId hint) {
  const FourVectors origin{broadcast(view.p.x), broadcast(view.p.y), broadcast(view.p.z)};
  CellId current = hint;
  // From an infinite cell, step through its hull facet: p is seen from inside or beyond.
  if (is_infinite(view.cells[current.index()])) {
    current = cell_of(view.cells[current.index()].neighbors[3]);
  }
  for (;;) {
    const Cell& cell = view.cells[current.index()];
    const int exit = exit_facet(view, cell, origin);
    if (exit < 0) return current;
    const FacetId behind = cell.neighbors[static_cast<std::size_t>(exit)];
    current = cell_of(behind);
    ++view.counters.walk_steps;
    if (view.holder != nullptr && !view.hold_on_the_way(behind)) return {};
    if (is_infinite(view.cells[current.index()])) return current;
  }
}

}  // namespace cocoon::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace cocoon {

COCOON_VECTOR_EXPORT(find_zone);
COCOON_VECTOR_EXPORT(find_start);

// A finite cell is in conflict iff its (perturbed) circumsphere contains p. An infinite cell is
// iff p lies beyond its hull facet; a point in the plane of the hull facet lies in the facet's
// circumcircle iff it lies in the sphere of the finite cell behind it, perturbation included.
bool SearchView::in_conflict(const Cell& cell) const {
  const Cell* finite = &cell;
  if (is_infinite(cell)) {
    const Sign side =
        orient3d(points[cell.vertices[0]], points[cell.vertices[1]], points[cell.vertices[2]], p);
    if (side != Sign::zero) return side == Sign::positive;
    finite = &cell_behind(cell.neighbors[3]);
  }
  const Point& a = points[finite->vertices[0]];
  const Point& b = points[finite->vertices[1]];
  const Point& c = points[finite->vertices[2]];
  const Point& d = points[finite->vertices[3]];
  const Sign sign =
      is_infinite(cell) ? insphere(a, b, c, d, p) : insphere_after_filter(a, b, c, d, p);
  return (sign != Sign::zero ? sign : break_cospherical_tie(a, b, c, d, p)) == Sign::positive;
}

// The same for a finite cell that has p on its circumsphere.
bool SearchView::in_conflict_on_sphere(const Cell& cell) const {
  return break_cospherical_tie(points[cell.vertices[0]], points[cell.vertices[1]],
                               points[cell.vertices[2]], points[cell.vertices[3]],
                               p) == Sign::positive;
}

// What the filter leaves open, ties, and infinite cells, one by one. Returns `inside` completed.
unsigned SearchView::decide_open(const std::array<FacetId, 4>& outer, unsigned inside,
                                 unsigned open, unsigned on_sphere) {
  for (; open != 0; open &= open - 1) {
    const auto lane = static_cast<unsigned>(std::countr_zero(open));
    const Cell& cell = cell_behind(outer[lane]);
    const bool is_tie = ((on_sphere >> lane) & 1U) != 0;
    const bool conflict = is_tie ? in_conflict_on_sphere(cell) : in_conflict(cell);
    counters.exact_inspheres += is_tie || is_infinite(cell) ? 0 : 1;
    inside = (inside & ~(1U << lane)) | ((conflict ? 1U : 0U) << lane);
  }
  return inside;
}

// Of the given facets of a finite cell those that have p strictly beyond them.
unsigned SearchView::facets_beyond(const Cell& cell, unsigned facets) const {
  unsigned beyond = 0;
  for (; facets != 0; facets &= facets - 1) {
    const int i = std::countr_zero(facets);
    const auto [a, b, c] = facet_vertices(cell, i);
    const Sign side = orient3d(points[a], points[b], points[c], p);
    beyond |= (side == Sign::positive ? 1U : 0U) << i;
  }
  return beyond;
}

// --- Lists -----------------------------------------------------------------------------------

// Around a cell at most four cells and facets are found, and four are written before they are
// counted.
ZoneLists ConflictZone::start_lists() {
  if (cells_.size() < capacity_ + 4) {
    cells_.resize(capacity_ + 4);
    vertices_.resize(capacity_ + 7);
    border_.resize(4 * capacity_ + 4);
  }
  return {cells_.data(), vertices_.data(), border_.data(), capacity_};
}

ZoneLists ConflictZone::grow() {
  capacity_ *= 2;
  return start_lists();
}

// --- The searches -----------------------------------------------------------------------------

namespace {

// If all coordinates are multiples of `unit`, so are the differences, and every intermediate value
// of the determinant is an integer multiple of a power of it. The largest, the sums of the four
// summands, stay below 24 L^(5/2) for the largest squared length L, so they are exact up to
// 2^53 unit^5: for L <= 2^19 unit^2 they are below 2^(47.5 + 4.6) unit^5. Negative, so that nothing
// is exact, if there is no unit, or one so extreme that powers of it may under- or overflow.
double largest_exact_reach(double unit) {
  if (!(unit > 0x1p-100 && unit < 0x1p100)) return -1;
  return 0x1p19 * (unit * unit);
}

}  // namespace

ConflictSearch::ConflictSearch(CellPool& pool, const IdVector<VertexId, Point>& points,
                               const Execution& execution)
    : pool_(pool), points_(points) {
  read_points_again(execution);
}

void ConflictSearch::read_points_again(const Execution& execution) {
  unit_ = common_unit(points_.span(), execution);
  exact_reach_ = largest_exact_reach(unit_);
}

void ConflictSearch::admit(const Point& p) {
  if (exact_reach_ < 0) return;
  const double unit = common_unit(p);
  if (unit == 0 || unit >= unit_) return;  // the origin is on every grid
  unit_ = unit;
  exact_reach_ = largest_exact_reach(unit);
}

SearchView ConflictSearch::view(const Point& p, DelaunayCounters& counters) {
  static_assert(sizeof(Point) == 3 * sizeof(double));
  return {pool_.cells.raw().data(),
          pool_.marks.raw().data(),
          &points_.raw().data()->x,
          exact_reach_,
          p,
          points_,
          counters,
          holder_};
}

CellId ConflictSearch::find_start(const Point& p, CellId hint, DelaunayCounters& counters) {
  SearchView search = view(p, counters);
  return COCOON_VECTOR_CALL(find_start)(search, hint);
}

bool ConflictSearch::find_zone(const Point& p, CellId start, DelaunayCounters& counters) {
  SearchView search = view(p, counters);
  const bool is_found = COCOON_VECTOR_CALL(find_zone)(search, zone_, start);
  if (!is_found) unmark_zone();
  return is_found;
}

void ConflictSearch::unmark_zone() {
  CellMark* const marks = pool_.marks.raw().data();
  for (const CellId c : zone_.cells()) marks[c.index()] = CellMark::untested;
}

}  // namespace cocoon

#endif  // HWY_ONCE
