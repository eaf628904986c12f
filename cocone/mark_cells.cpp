#include "cocone/mark_cells.h"

#include <algorithm>
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

// Disjoint sets of cells. Sets are joined under the smaller root.
class CellSets {
 public:
  explicit CellSets(std::size_t num_cells) {
    parent_.reserve(num_cells);
    for (const CellId c : id_range<CellId>(num_cells)) parent_.push_back(c);
  }
  // Halves the path.
  CellId root(CellId c) {
    while (parent_[c] != c) c = parent_[c] = parent_[parent_[c]];
    return c;
  }
  void join(CellId a, CellId b) {
    a = root(a);
    b = root(b);
    parent_[std::max(a, b)] = std::min(a, b);
  }

 private:
  IdVector<CellId, CellId> parent_;
};

// What the rounds give where no two vertices disagree, in one pass over the cells. The vertices
// that get their turn are those joined to the hull by triangles of the surface. Two cells at such a
// vertex are in one half if facets at the vertex lead from one to the other without crossing the
// surface: cells joined by such facets have one label. It is OUT for the sets of the infinite
// cells, IN for those behind the surface seen from there. If no set is told both, every half has
// one label, the one that the rounds find.
class ConsistentMarking {
 public:
  ConsistentMarking(const Triangulation& triangulation, const FacetSet& surface,
                    const TriangleFans& fans, CellMarks& marks)
      : triangulation_(triangulation),
        surface_(surface),
        fans_(fans),
        marks_(marks),
        sets_(triangulation.num_cells()) {}

  // False if the labels contradict each other; the marks are then of no use.
  bool run(std::span<const VertexId> seeds) {
    visit_surface(seeds);
    join_cells();
    // The label of a set is kept at its root until all are known.
    for (const CellId c : triangulation_.infinite_cells()) {
      marks_.labels[sets_.root(c)] = CellLabel::out;
    }
    for (const FacetId f : dividing_) {
      const CellId front = sets_.root(cell_of(f));
      const CellId back = sets_.root(triangulation_.neighbor(cell_of(f), index_of(f)));
      const bool front_out = marks_.labels[front] == CellLabel::out;
      const bool back_out = marks_.labels[back] == CellLabel::out;
      if (front_out && back_out) return false;
      if (front_out) marks_.labels[back] = CellLabel::in;
      if (back_out) marks_.labels[front] = CellLabel::in;
    }
    for (const CellId c : triangulation_.cells()) marks_.labels[c] = marks_.labels[sets_.root(c)];
    return true;
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

  // Facets at a visited vertex join their cells, or divide them if they lie on the surface.
  void join_cells() {
    for (const CellId c : triangulation_.cells()) {
      const unsigned visited = visited_corners(c);
      if (visited == 0) continue;
      for (int i = 0; i < 4; ++i) {
        const FacetId f = facet_id(c, i);
        const CellId behind = triangulation_.neighbor(c, i);
        if (c < behind || (visited & ~(1U << i)) == 0) continue;  // told once, by the larger cell
        if (surface_.contains(f)) {
          dividing_.push_back(f);
        } else {
          sets_.join(c, behind);
        }
      }
    }
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
  CellSets sets_;
  std::vector<FacetId> dividing_;  // facets of the surface at a visited vertex
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
