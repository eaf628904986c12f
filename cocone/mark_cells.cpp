#include "cocone/mark_cells.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>

#include "cocone/known_sides.h"
#include "delaunay/circulate.h"

namespace cocoon {
namespace {

constexpr std::size_t ahead = 16;  // cells lie here and there in memory: fetch those that come soon

struct LabelCount {
  std::size_t out = 0;
  std::size_t in = 0;

  void add(CellLabel label) {
    out += label == CellLabel::out;
    in += label == CellLabel::in;
  }
  bool mixed() const { return out != 0 && in != 0; }
  CellLabel majority() const {
    if (out == 0 && in == 0) return CellLabel::unmarked;
    return out >= in ? CellLabel::out : CellLabel::in;
  }
};

CellLabel opposite(CellLabel label) {
  return label == CellLabel::out ? CellLabel::in : CellLabel::out;
}

// What the rounds give where no two vertices disagree. The vertices that get their turn are those
// joined to the hull by triangles of the surface. A side of the surface, carried from triangle to
// triangle around them, labels the cells on both sides of it; cells that share a facet at such a
// vertex, off the surface, have the same label. Labels that meet all these conditions are those of
// the rounds: OUT is what hangs together with an infinite cell by such facets, IN what lies behind.
class ConsistentMarking {
 public:
  // `corner_at`: as in GoodVertices.
  ConsistentMarking(const Triangulation& triangulation, const LinkedFacets& surface,
                    const IdVector<VertexId, SideId>& corner_at, CellMarks& marks)
      : triangulation_(triangulation), surface_(surface), corner_at_(corner_at), marks_(marks) {}

  // False if the labels contradict each other; the marks are then of no use.
  bool run() {
    for (const CellId c : triangulation_.infinite_cells()) marks_.labels[c] = CellLabel::out;
    return visit_surface() && label_sides() && label_others();
  }

 private:
  static constexpr std::uint8_t unknown = 2;

  // Goes over the surface from the hull, by good vertices. Of each triangle at one it learns on
  // which side OUT is: 0, in the cell that numbers the facet, 1, in the one behind.
  bool visit_surface() {
    out_side_.assign(surface_.size(), unknown);
    for (const CellId c : triangulation_.infinite_cells()) {
      for (unsigned i = 0; i < 3; ++i) {
        const VertexId v = triangulation_.cell(c).vertices[i];
        if (marks_.good[v] == 0 || marks_.visited[v] != 0) continue;
        const FacetId seen = surface_seen_from(c, v);
        const std::uint32_t t = triangle_of_facet(seen, v);
        if (!visit_from(t, seen == surface_.facets[t] ? 0 : 1)) return false;
      }
    }
    return true;
  }

  // The first facet of the surface at v met from the infinite cell c, seen from that side.
  // Precondition: v is good.
  FacetId surface_seen_from(CellId c, VertexId v) const {
    std::vector<CellId> half{c};
    for (std::size_t next = 0;; ++next) {
      const int opposite_facet = index_of_vertex(triangulation_.cell(half[next]), v);
      for (int i = 0; i < 4; ++i) {
        if (i == opposite_facet) continue;
        const FacetId f = facet_id(half[next], i);
        if (surface_.set.contains(f)) return f;
        const CellId behind = cell_of(triangulation_.mirror(f));
        if (std::find(half.begin(), half.end(), behind) == half.end()) half.push_back(behind);
      }
    }
  }

  // The position of a facet of the surface at the good vertex v: found by going around v.
  std::uint32_t triangle_of_facet(FacetId f, VertexId v) const {
    SideId crossed = corner_at_[v];
    for (std::size_t arrived = next_corner(corner_of_side(crossed));;) {
      const std::uint32_t t = triangle_of_side(crossed);
      if (surface_.facets[t] == f || surface_.mirrors[t] == f) return t;
      const Triangle& corners = surface_.corners[t];
      std::size_t leaving = next_corner(arrived);
      if (corners[leaving] == v) leaving = next_corner(leaving);
      crossed = surface_.links[3 * t + static_cast<SideId>(leaving)];
      arrived = corner_of_side(crossed);
    }
  }

  bool visit_from(std::uint32_t first, std::uint8_t out_side) {
    stack_.assign(1, first);
    out_side_[first] = out_side;
    while (!stack_.empty()) {
      const std::uint32_t t = stack_.back();
      stack_.pop_back();
      const Triangle& corners = surface_.corners[t];
      for (std::size_t i = 0; i < 3; ++i) {
        const VertexId a = corners[next_corner(i)];
        if ((marks_.good[a] | marks_.good[corners[previous_corner(i)]]) == 0) continue;
        // Around a good vertex every edge has two triangles.
        const SideId across = surface_.links[3 * t + i];
        const bool turned = surface_.ends(across)[0] == a;
        const auto expected = static_cast<std::uint8_t>(out_side_[t] ^ (turned ? 1U : 0U));
        std::uint8_t& found = out_side_[triangle_of_side(across)];
        if (found == unknown) {
          found = expected;
          stack_.push_back(triangle_of_side(across));
        } else if (found != expected) {
          return false;
        }
      }
      for (const VertexId v : corners) {
        const auto visited = static_cast<std::uint8_t>(marks_.visited[v] | marks_.good[v]);
        marks_.visited_vertices += visited ^ marks_.visited[v];
        marks_.visited[v] = visited;
      }
    }
    return true;
  }

  // Every triangle whose sides are known has a visited corner: it was reached from one.
  bool label_sides() {
    bool agrees = true;
    const auto label = [&](FacetId f, CellLabel wanted) {
      CellLabel& known = marks_.labels[cell_of(f)];
      known = known == CellLabel::unmarked ? wanted : known;
      agrees &= known == wanted;
    };
    for (std::uint32_t t = 0; t < surface_.size(); ++t) {
      if (t + ahead < surface_.size()) {
        __builtin_prefetch(&marks_.labels[cell_of(surface_.facets[t + ahead])]);
        __builtin_prefetch(&marks_.labels[cell_of(surface_.mirrors[t + ahead])]);
      }
      if (out_side_[t] == unknown) continue;
      const bool out_here = out_side_[t] == 0;
      label(surface_.facets[t], out_here ? CellLabel::out : CellLabel::in);
      label(surface_.mirrors[t], out_here ? CellLabel::in : CellLabel::out);
    }
    return agrees;
  }

  // Labels pass through facets at visited vertices; in the order of memory, as often as it takes.
  // Each cell is compared with those around it when it has its label, so that of any two the second
  // sees the first. False if they contradict each other, or if none comes to a cell.
  bool label_others() {
    unsigned wrong = 0;
    std::vector<CellId> left;
    for (const CellId c : triangulation_.cells()) {
      if (!take_label(c, wrong) && passing_facets(c) != 0) left.push_back(c);
    }
    for (std::size_t before = left.size() + 1; left.size() < before;) {
      before = left.size();
      std::reverse(left.begin(), left.end());
      std::erase_if(left, [&](CellId c) { return take_label(c, wrong); });
    }
    return wrong == 0 && left.empty();
  }

  // Bit i: facet i has a vertex that has had its turn. A branch only on whether all have.
  unsigned passing_facets(CellId c) const {
    if (marks_.visited_vertices == triangulation_.num_vertices()) return 15;
    const Cell& cell = triangulation_.cell(c);
    unsigned bits = 0;
    for (unsigned i = 0; i < (triangulation_.is_infinite(c) ? 3U : 4U); ++i) {
      bits |= static_cast<unsigned>(marks_.visited[cell.vertices[i]]) << i;
    }
    const bool is_one = (bits & (bits - 1)) == 0;
    return bits == 0 ? 0U : is_one ? 15U & ~bits : 15U;
  }

  // Gives the cell a label, if it has none, and looks whether it agrees with those around it, by
  // the bits of labels: a branch for each facet would be guessed wrong half of the time. Where the
  // cells around contradict each other it takes any of their labels. False if there is none yet.
  bool take_label(CellId c, unsigned& wrong) {
    constexpr auto out = static_cast<unsigned>(CellLabel::out);
    static_assert(out == 1 && static_cast<unsigned>(CellLabel::in) == 2);
    const Cell& cell = triangulation_.cell(c);
    std::uint32_t labels = 0;  // of the cells around, one in each byte
    for (unsigned i = 0; i < 4; ++i) {
      labels |= static_cast<std::uint32_t>(marks_.labels[cell_of(cell.neighbors[i])]) << (8 * i);
    }
    const std::uint32_t told = labels & byte_of_bit[passing_facets(c)];
    const std::uint32_t closed = byte_of_bit[surface_.set.bits(c)];
    const unsigned same = any_byte(told & ~closed);     // told by cells that have the same label
    const unsigned opposite = any_byte(told & closed);  // by cells beyond the surface
    const auto known = static_cast<unsigned>(marks_.labels[c]);
    const unsigned label = known != 0 ? known : (same & out) != 0 ? out : same;
    const unsigned all = same | opposite >> 1 | (opposite << 1 & 2U);  // these bits change places
    wrong |= label != 0 ? all & ~label : 0U;
    marks_.labels[c] = static_cast<CellLabel>(label);
    return label != 0;
  }

  // Byte i: whether bit i is set, in both bits of a label.
  static constexpr std::array<std::uint32_t, 16> byte_of_bit = [] {
    std::array<std::uint32_t, 16> masks{};
    for (std::uint32_t bits = 0; bits < 16; ++bits) {
      for (unsigned i = 0; i < 4; ++i) masks[bits] |= 3 * ((bits >> i) & 1U) << (8 * i);
    }
    return masks;
  }();
  // The bits of a label that are set in any of four bytes.
  static unsigned any_byte(std::uint32_t bytes) {
    bytes |= bytes >> 16;
    return (bytes | bytes >> 8) & 3U;
  }

  const Triangulation& triangulation_;
  const LinkedFacets& surface_;
  const IdVector<VertexId, SideId>& corner_at_;
  CellMarks& marks_;
  std::vector<std::uint8_t> out_side_;  // per triangle
  std::vector<std::uint32_t> stack_;
};

void clear_marks(const Triangulation& triangulation, CellMarks& marks) {
  marks.labels = IdVector<CellId, CellLabel>(triangulation.num_cells(), CellLabel::unmarked);
  marks.visited = VertexSet(triangulation.num_vertices(), 0);
  marks.visited_vertices = 0;
}

// Gives the cells their known labels, if they touch a good vertex: others are left to the peel.
// Their good vertices are among the first to have their turn.
void take_known_sides(const Triangulation& triangulation, const LinkedFacets& surface,
                      std::span<const KnownTriangle> triangles, CellMarks& marks,
                      std::vector<VertexId>& seeds) {
  if (triangles.empty()) return;
  const KnownSides known = known_sides(triangulation, surface, triangles);
  for (const CellId c : triangulation.finite_cells()) {
    if (known.labels[c] == CellLabel::unmarked) continue;
    for (const VertexId v : triangulation.cell(c).vertices) {
      if (marks.good[v] == 0) continue;
      seeds.push_back(v);
      if (marks.labels[c] != CellLabel::unmarked) continue;
      marks.labels[c] = known.labels[c];
      ++marks.known_cells;
    }
  }
}

}  // namespace

MarkingRounds::MarkingRounds(const Triangulation& triangulation, const FacetSet& surface,
                             CellMarks& marks)
    : triangulation_(triangulation),
      stars_(triangulation),
      surface_(surface),
      marks_(marks),
      scratch_(triangulation.num_cells()) {}

void MarkingRounds::run(std::span<const VertexId> seeds, std::vector<CellId>& out_cells) {
  std::vector<VertexId> frontier;
  for (const VertexId v : seeds) {
    if (visit(v)) frontier.push_back(v);
  }
  std::vector<VertexId> next;
  while (!frontier.empty()) {
    ++marks_.rounds;
    for (const VertexId v : frontier) decide(v);
    apply(out_cells);
    next.clear();
    for (const VertexId v : frontier) append_neighbors(v, next);
    std::swap(frontier, next);
  }
}

// Takes v's turn if it is good and has not had it.
bool MarkingRounds::visit(VertexId v) {
  if (marks_.good[v] == 0 || marks_.visited[v] != 0) return false;
  marks_.visited[v] = 1;
  ++marks_.visited_vertices;
  return true;
}

void MarkingRounds::decide(VertexId v) {
  const std::span<const CellId> star = stars_.star(v);
  bool complete = true;
  for (const CellId c : star) complete &= marks_.labels[c] != CellLabel::unmarked;
  if (complete) return;
  flood_half(v, star.front());
  LabelCount flooded;
  LabelCount rest;
  for (const CellId c : star) (scratch_[c] != 0 ? flooded : rest).add(marks_.labels[c]);
  CellLabel of_flooded = flooded.majority();
  CellLabel of_rest = rest.majority();
  if (of_flooded == CellLabel::unmarked) of_flooded = opposite(of_rest);
  if (of_rest == CellLabel::unmarked) of_rest = opposite(of_flooded);
  if (flooded.mixed() || rest.mixed() || of_flooded == of_rest) ++marks_.conflicts;
  propose(v, of_flooded, of_rest);
  for (const CellId c : half_) scratch_[c] = 0;
}

// Collects the cells of star(v) on one side of the surface's disk at v.
void MarkingRounds::flood_half(VertexId v, CellId first) {
  half_.assign(1, first);
  scratch_[first] = 1;
  for (std::size_t next = 0; next < half_.size(); ++next) {
    const CellId c = half_[next];
    const int opposite_facet = index_of_vertex(triangulation_.cell(c), v);
    for (int i = 0; i < 4; ++i) {
      const FacetId f = facet_id(c, i);
      if (i == opposite_facet || surface_.contains(f)) continue;
      const CellId behind = cell_of(triangulation_.mirror(f));
      if (scratch_[behind] != 0) continue;
      scratch_[behind] = 1;
      half_.push_back(behind);
    }
  }
}

void MarkingRounds::propose(VertexId v, CellLabel flooded, CellLabel rest) {
  for (const CellId c : stars_.star(v)) {
    if (marks_.labels[c] != CellLabel::unmarked) continue;
    proposals_.push_back({c, scratch_[c] != 0 ? flooded : rest});
  }
}

void MarkingRounds::apply(std::vector<CellId>& out_cells) {
  constexpr std::uint8_t both = 3;
  for (const Proposal& p : proposals_) {
    scratch_[p.cell] =
        static_cast<std::uint8_t>(scratch_[p.cell] | (p.label == CellLabel::out ? 1U : 2U));
  }
  for (const Proposal& p : proposals_) {
    std::uint8_t& told = scratch_[p.cell];
    if (told == 0) continue;  // done: cells are proposed several times
    marks_.conflicts += told == both;
    marks_.labels[p.cell] = (told & 1U) != 0 ? CellLabel::out : CellLabel::in;
    if ((told & 1U) != 0) out_cells.push_back(p.cell);
    told = 0;
  }
  proposals_.clear();
}

// The good vertices on the surface's triangles at v that have not had their turn.
void MarkingRounds::append_neighbors(VertexId v, std::vector<VertexId>& frontier) {
  for (const CellId c : stars_.star(v)) {
    const unsigned facets = surface_.bits(c);
    if (facets == 0) continue;
    const Cell& cell = triangulation_.cell(c);
    const int opposite_facet = index_of_vertex(cell, v);
    for (int i = 0; i < 4; ++i) {
      if (i == opposite_facet || ((facets >> i) & 1U) == 0) continue;
      for (const int k : facet_corners[i]) {
        const VertexId w = cell.vertices[static_cast<std::size_t>(k)];
        if (visit(w)) frontier.push_back(w);
      }
    }
  }
}

void mark_in_rounds(const Triangulation& triangulation, const FacetSet& surface,
                    std::span<const VertexId> seeds, CellMarks& marks) {
  for (const CellId c : triangulation.infinite_cells()) marks.labels[c] = CellLabel::out;
  std::vector<CellId> out_cells;
  MarkingRounds(triangulation, surface, marks).run(seeds, out_cells);
}

CellMarks mark_cells(const Triangulation& triangulation, const LinkedFacets& surface,
                     const VertexSet& boundary, const GoodVertexOptions& options,
                     const Execution& execution) {
  return mark_cells(triangulation, surface, boundary, std::span<const KnownTriangle>(), options,
                    execution);
}

CellMarks mark_cells(const Triangulation& triangulation, const LinkedFacets& surface,
                     const VertexSet& boundary, std::span<const KnownTriangle> known,
                     const GoodVertexOptions& options, const Execution& execution) {
  report_progress(execution, "mark_cells", 0);
  GoodVertices good = good_vertices(surface, boundary, options, execution);
  report_progress(execution, "mark_cells", 0.4);
  CellMarks marks;
  marks.good = std::move(good.good);
  marks.good_vertices = good.count;
  marks.demoted_vertices = good.demoted;
  clear_marks(triangulation, marks);
  if (!ConsistentMarking(triangulation, surface, good.corner_at, marks).run()) {
    clear_marks(triangulation, marks);
    // the first to have their turn: good vertices on the hull
    std::vector<VertexId> seeds;
    for (const CellId c : triangulation.infinite_cells()) {
      for (int i = 0; i < 3; ++i) seeds.push_back(triangulation.vertex(c, i));
    }
    take_known_sides(triangulation, surface, known, marks, seeds);
    mark_in_rounds(triangulation, surface.set, seeds, marks);
  }
  report_progress(execution, "mark_cells", 1);
  return marks;
}

}  // namespace cocoon
