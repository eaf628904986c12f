#include "cocone/mark_cells.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <utility>

#include "cocone/known_sides.h"
#include "delaunay/circulate.h"

namespace cocoon {
namespace {

constexpr std::size_t cells_per_chunk = 16384;

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
  ConsistentMarking(const Triangulation& triangulation, const LinkedFacets& surface,
                    CellMarks& marks)
      : triangulation_(triangulation), surface_(surface), marks_(marks) {}

  // False if the labels contradict each other; the marks are then of no use.
  bool run(const Execution& execution) {
    for (const CellId c : triangulation_.infinite_cells()) marks_.labels[c] = CellLabel::out;
    if (!visit_surface() || !label_sides()) return false;
    label_others();
    return is_consistent(execution);
  }

 private:
  static constexpr std::uint8_t unknown = 2;

  // Goes over the surface from the hull, by good vertices. Of each triangle at one it learns on
  // which side OUT is: 0, in the cell that numbers the facet, 1, in the one behind.
  bool visit_surface() {
    out_side_.assign(surface_.size(), unknown);
    side_opposite_.resize(triangulation_.num_vertices());
    for (SideId side = 0; side < surface_.links.size(); ++side) {
      side_opposite_[surface_.corners[triangle_of_side(side)][corner_of_side(side)]] = side;
    }
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
    SideId crossed = side_opposite_[v];
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
      for (SideId side = 3 * t; side < 3 * t + 3; ++side) {
        const auto [a, b] = surface_.ends(side);
        if ((marks_.good[a] | marks_.good[b]) == 0) continue;
        // Around a good vertex every edge has two triangles.
        const SideId across = surface_.links[side];
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
      for (const VertexId v : surface_.corners[t]) {
        if (marks_.good[v] == 0 || marks_.visited[v] != 0) continue;
        marks_.visited[v] = 1;
        ++marks_.visited_vertices;
      }
    }
    return true;
  }

  bool label(CellId c, CellLabel wanted) {
    CellLabel& label = marks_.labels[c];
    if (label == CellLabel::unmarked) label = wanted;
    return label == wanted;
  }

  bool label_sides() {
    for (std::uint32_t t = 0; t < surface_.size(); ++t) {
      if (out_side_[t] == unknown || !has_visited_corner(surface_.corners[t])) continue;
      const CellId here = cell_of(surface_.facets[t]);
      const CellId behind = cell_of(surface_.mirrors[t]);
      const bool out_here = out_side_[t] == 0;
      if (!label(here, out_here ? CellLabel::out : CellLabel::in)) return false;
      if (!label(behind, out_here ? CellLabel::in : CellLabel::out)) return false;
    }
    return true;
  }

  bool has_visited_corner(const Triangle& corners) const {
    return (marks_.visited[corners[0]] | marks_.visited[corners[1]] | marks_.visited[corners[2]]) !=
           0;
  }

  bool all_visited() const { return marks_.visited_vertices == triangulation_.num_vertices(); }

  // Labels pass through facets at visited vertices; in the order of memory, as often as it takes.
  void label_others() {
    const bool all = all_visited();
    std::vector<CellId> left;
    for (const CellId c : triangulation_.cells()) {
      if (marks_.labels[c] != CellLabel::unmarked) continue;
      if (all) {
        if (!take_any_label(c)) left.push_back(c);
      } else if (visited_corners(c) != 0) {
        if (!take_label(c)) left.push_back(c);
      }
    }
    for (std::size_t before = left.size() + 1; left.size() < before;) {
      before = left.size();
      std::reverse(left.begin(), left.end());
      std::erase_if(left, [&](CellId c) { return take_label(c); });
    }
  }

  bool take_label(CellId c) {
    const unsigned visited = visited_corners(c);
    for (int i = 0; i < 4; ++i) {
      const FacetId f = facet_id(c, i);
      if ((visited & ~(1U << i)) == 0 || surface_.set.contains(f)) continue;
      const CellLabel label = marks_.labels[triangulation_.neighbor(c, i)];
      if (label == CellLabel::unmarked) continue;
      marks_.labels[c] = label;
      return true;
    }
    return false;
  }

  // The labels behind the facets off the surface; those that are not there yet are 0.
  std::array<unsigned, 4> passing_labels(CellId c) const {
    const unsigned closed = surface_.set.bits(c);
    const Cell& cell = triangulation_.cell(c);
    std::array<unsigned, 4> labels;
    for (unsigned i = 0; i < 4; ++i) {
      const auto label = static_cast<unsigned>(marks_.labels[cell_of(cell.neighbors[i])]);
      labels[i] = label & (((closed >> i) & 1U) - 1U);
    }
    return labels;
  }

  // Where all vertices have been visited: without a branch for each facet. Where labels contradict
  // each other it takes any of them: that shows in the end.
  bool take_any_label(CellId c) {
    const auto [a, b, d, e] = passing_labels(c);
    const unsigned labels = a | b | d | e;
    marks_.labels[c] = (labels & static_cast<unsigned>(CellLabel::out)) != 0 ? CellLabel::out
                       : labels != 0                                         ? CellLabel::in
                                                                             : CellLabel::unmarked;
    return labels != 0;
  }

  // Bit i: vertex i has had its turn.
  unsigned visited_corners(CellId c) const {
    const Cell& cell = triangulation_.cell(c);
    unsigned bits = 0;
    for (unsigned i = 0; i < (triangulation_.is_infinite(c) ? 3U : 4U); ++i) {
      bits |= static_cast<unsigned>(marks_.visited[cell.vertices[i]]) << i;
    }
    return bits;
  }

  bool is_consistent(const Execution& execution) const {
    std::atomic<bool> consistent = true;
    const bool all = all_visited();
    parallel_chunks(execution, triangulation_.num_cells(), cells_per_chunk,
                    [&](std::size_t begin, std::size_t end) {
                      bool agrees = true;
                      for (CellId c(begin); c.index() < end; ++c) {
                        agrees &= all ? agrees_with_all_neighbors(c)
                                      : agrees_with_neighbors(c, visited_corners(c));
                      }
                      if (!agrees) consistent = false;
                    });
    return consistent;
  }

  // Where all vertices have been visited. Asked from both sides of a facet: cheaper than a branch.
  bool agrees_with_all_neighbors(CellId c) const {
    static_assert((static_cast<unsigned>(CellLabel::out) ^ static_cast<unsigned>(CellLabel::in)) ==
                  3);
    const Cell& cell = triangulation_.cell(c);
    const unsigned facets = surface_.set.bits(c);
    const auto label = static_cast<unsigned>(marks_.labels[c]);
    unsigned wrong = label == 0 ? 1U : 0U;
    for (unsigned i = 0; i < 4; ++i) {
      const unsigned turned = ((facets >> i) & 1U) * 3;
      wrong |= label ^ turned ^ static_cast<unsigned>(marks_.labels[cell_of(cell.neighbors[i])]);
    }
    return wrong == 0;
  }

  bool agrees_with_neighbors(CellId c, unsigned visited) const {
    const CellLabel label = marks_.labels[c];
    for (int i = 0; i < 4; ++i) {
      const FacetId f = facet_id(c, i);
      const CellId behind = triangulation_.neighbor(c, i);
      if (behind < c || (visited & ~(1U << i)) == 0) continue;  // told once, by the smaller cell
      if (label == CellLabel::unmarked) return false;
      const CellLabel expected = surface_.set.contains(f) ? opposite(label) : label;
      if (marks_.labels[behind] != expected) return false;
    }
    return true;
  }

  const Triangulation& triangulation_;
  const LinkedFacets& surface_;
  CellMarks& marks_;
  std::vector<std::uint8_t> out_side_;        // per triangle
  IdVector<VertexId, SideId> side_opposite_;  // of some triangle at the vertex
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
  if (!ConsistentMarking(triangulation, surface, marks).run(execution)) {
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
