#include "cocone/mark_cells.h"

#include <utility>

#include "cocone/triangle_fans.h"
#include "delaunay/circulate.h"

namespace cocoon {
namespace {

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

// What the rounds give where no two vertices disagree, in one pass over the cells. The vertices
// that get their turn are those joined to the hull by triangles of the surface. Two cells at such a
// vertex are in one half if facets at the vertex lead from one to the other without crossing the
// surface: so OUT spreads through these facets, and IN likewise from behind the surface. If no cell
// is told both, every half has one label, the one that the rounds find.
class ConsistentMarking {
 public:
  ConsistentMarking(const Triangulation& triangulation, const FacetSet& surface,
                    const TriangleFans& fans, CellMarks& marks)
      : triangulation_(triangulation), surface_(surface), fans_(fans), marks_(marks) {}

  // False if the labels contradict each other; the marks are then of no use.
  bool run(std::span<const VertexId> seeds) {
    visit_surface(seeds);
    for (const CellId c : triangulation_.infinite_cells()) label(c, CellLabel::out);
    spread(CellLabel::out);
    for (const CellId c : behind_surface_) {
      if (marks_.labels[c] == CellLabel::out) return false;
      if (marks_.labels[c] == CellLabel::unmarked) label(c, CellLabel::in);
    }
    return spread(CellLabel::in);
  }

 private:
  void visit_surface(std::span<const VertexId> seeds) {
    std::vector<VertexId> stack;
    const auto visit = [&](VertexId v) {
      if (marks_.good[v] == 0 || marks_.visited[v] != 0) return;
      marks_.visited[v] = 1;
      ++marks_.visited_vertices;
      stack.push_back(v);
    };
    for (const VertexId v : seeds) visit(v);
    while (!stack.empty()) {
      const VertexId v = stack.back();
      stack.pop_back();
      for (const std::uint32_t t : fans_.around(v)) {
        for (const VertexId w : fans_.corners[t]) visit(w);
      }
    }
  }

  void label(CellId c, CellLabel label_of_c) {
    marks_.labels[c] = label_of_c;
    stack_.push_back(c);
  }

  bool spread(CellLabel own) {
    while (!stack_.empty()) {
      const CellId c = stack_.back();
      stack_.pop_back();
      const unsigned visited = visited_corners(c);
      if (visited == 0) continue;
      for (int i = 0; i < 4; ++i) {
        if ((visited & ~(1U << i)) == 0) continue;
        const CellId behind = triangulation_.neighbor(c, i);
        const CellLabel known = marks_.labels[behind];
        if (surface_.contains(facet_id(c, i))) {
          if (own == CellLabel::out) behind_surface_.push_back(behind);
        } else if (known == CellLabel::unmarked) {
          label(behind, own);
        } else if (known != own) {
          return false;
        }
      }
    }
    return true;
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

  const Triangulation& triangulation_;
  const FacetSet& surface_;
  const TriangleFans& fans_;
  CellMarks& marks_;
  std::vector<CellId> stack_;
  std::vector<CellId> behind_surface_;  // cells across a facet of the surface from an OUT cell
};

void clear_marks(const Triangulation& triangulation, CellMarks& marks) {
  marks.labels = IdVector<CellId, CellLabel>(triangulation.num_cells(), CellLabel::unmarked);
  marks.visited = VertexSet(triangulation.num_vertices(), 0);
  marks.visited_vertices = 0;
}

}  // namespace

MarkingRounds::MarkingRounds(const Triangulation& triangulation, const VertexStars& stars,
                             const FacetSet& surface, CellMarks& marks)
    : triangulation_(triangulation),
      stars_(stars),
      surface_(surface),
      marks_(marks),
      scratch_(triangulation.num_cells(), 0) {}

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

void mark_in_rounds(const Triangulation& triangulation, const VertexStars& stars,
                    const FacetSet& surface, std::span<const VertexId> seeds, CellMarks& marks) {
  for (const CellId c : triangulation.infinite_cells()) marks.labels[c] = CellLabel::out;
  std::vector<CellId> out_cells;
  MarkingRounds(triangulation, stars, surface, marks).run(seeds, out_cells);
}

CellMarks mark_cells(const Triangulation& triangulation, const VertexStars& stars,
                     const FacetSet& surface, const VertexSet& boundary,
                     const GoodVertexOptions& options, const Execution& execution) {
  report_progress(execution, "mark_cells", 0);
  const TriangleFans fans = triangle_fans(triangulation, surface, execution);
  GoodVertices good = good_vertices(fans, boundary, options, execution);
  report_progress(execution, "mark_cells", 0.6);
  CellMarks marks;
  marks.good = std::move(good.good);
  marks.good_vertices = good.count;
  marks.demoted_vertices = good.demoted;
  // the first to have their turn: good vertices on the hull
  std::vector<VertexId> seeds;
  for (const CellId c : triangulation.infinite_cells()) {
    for (int i = 0; i < 3; ++i) seeds.push_back(triangulation.vertex(c, i));
  }
  clear_marks(triangulation, marks);
  if (!ConsistentMarking(triangulation, surface, fans, marks).run(seeds)) {
    clear_marks(triangulation, marks);
    mark_in_rounds(triangulation, stars, surface, seeds, marks);
  }
  report_progress(execution, "mark_cells", 1);
  return marks;
}

}  // namespace cocoon
