#include "delaunay/kernel/conflict_search.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>

#include "delaunay/kernel/filter_bounds.h"
#include "geom/exact/common_unit.h"
#include "geom/exact/predicate_levels.h"
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
  ExactReaches reaches;
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

}  // namespace cocoon
#endif

// Compile everything between HWY_BEFORE_NAMESPACE and HWY_AFTER_NAMESPACE once per instruction set.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "delaunay/kernel/conflict_search.cpp"
#include <hwy/foreach_target.h>
// clang-format off: must come after foreach_target.h
#include "delaunay/kernel/neighbor_tests-inl.h"
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

HWY_INLINE NeighborPoints load_neighbors(const SearchView& view, const Cell& cell, VertexId last,
                                         const std::array<VertexId, 4>& apexes) {
  return {load_points(view.point(cell.vertices[0]), view.point(cell.vertices[1]),
                      view.point(cell.vertices[2]), view.point(last)),
          load_points(view.point(apexes[0]), view.point(apexes[1]), view.point(apexes[2]),
                      view.point(apexes[3]))};
}

// The cells behind the facets of a cell, of which `apexes` are the fourth vertices.
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
  return test_neighbors(load_neighbors(view, cell, last, tips), origin, infinite,
                        view.reaches.filter);
}

// `decision` where it is unsure. Out of line, and all is read once more, so that the loop around it
// has the registers.
HWY_NOINLINE NeighborDecision decide_unsure(const SearchView& view, const Cell& cell,
                                            NeighborDecision decision) {
  std::array<VertexId, 4> tips;
  for (std::size_t i = 0; i < 4; ++i) tips[i] = view.apex(cell.neighbors[i]);
  VertexId last = cell.vertices[3];
  replace_infinite(cell, last, tips);
  const FourVectors origin{broadcast(view.p.x), broadcast(view.p.y), broadcast(view.p.z)};
  const NeighborDecision again = test_again(load_neighbors(view, cell, last, tips), origin,
                                            decision.unsure, view.reaches.wide);
  view.counters.wide_inspheres +=
      static_cast<std::size_t>(std::popcount(decision.unsure & ~again.open));
  return {(decision.inside & ~decision.unsure) | again.inside,
          (decision.open & ~decision.unsure) | again.open, decision.on_sphere | again.on_sphere, 0};
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
      decision.unsure &= ~known;
      if (decision.unsure != 0) decision = decide_unsure(view, cell, decision);
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
      is_infinite(cell) ? insphere(a, b, c, d, p) : insphere_on_grid(a, b, c, d, p).sign;
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

ConflictSearch::ConflictSearch(CellPool& pool, const IdVector<VertexId, Point>& points,
                               const Execution& execution)
    : pool_(pool), points_(points) {
  read_points_again(execution);
}

void ConflictSearch::read_points_again(const Execution& execution) {
  unit_ = common_unit(points_.span(), execution);
  reaches_ = exact_reaches(unit_);
}

void ConflictSearch::admit(const Point& p) {
  if (reaches_.filter < 0) return;
  const double unit = common_unit(p);
  if (unit == 0 || unit >= unit_) return;  // the origin is on every grid
  unit_ = unit;
  reaches_ = exact_reaches(unit);
}

SearchView ConflictSearch::view(const Point& p, DelaunayCounters& counters) {
  static_assert(sizeof(Point) == 3 * sizeof(double));
  return {pool_.cells.raw().data(),
          pool_.marks.raw().data(),
          &points_.raw().data()->x,
          reaches_,
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
