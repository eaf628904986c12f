#include "cocone/kept/kept_marks.h"

#include <algorithm>
#include <utility>

#include "cocone/facets/good_parts.h"
#include "cocone/mark_cells.h"
#include "cocone/marking/pass_labels.h"
#include "geom/arrays/disjoint_sets.h"
#include "geom/arrays/sort_ids.h"
#include "geom/arrays/visit_where.h"

namespace cocoon {
namespace {

// Besides the flags of the state.
constexpr unsigned is_new = 64;      // of a cell
constexpr unsigned has_changed = 4;  // of a vertex

// Labels of cells from those beside them.
class Labeling {
 public:
  Labeling(const Triangulation& triangulation, const FacetSet& surface, CellMarks& marks)
      : triangulation_(triangulation), surface_(surface), marks_(marks) {}

  // Labels these cells anew, which have none. False if there is a label that does not fit.
  bool run(std::span<const CellId> cells) {
    std::vector<CellId> left;
    for (const CellId c : cells) {
      if (triangulation_.is_infinite(c)) {
        marks_.labels[c] = CellLabel::out;
      } else if (has_good_vertex(c)) {
        left.push_back(c);
      }
    }
    pass_labels(left, [&](CellId c) { return take_label(c); });
    return left.empty() &&
           std::all_of(cells.begin(), cells.end(), [&](CellId c) { return fits(c); });
  }

 private:
  bool is_good_vertex(VertexId v) const { return v != infinite_vertex && marks_.good[v] != 0; }

  bool has_good_vertex(CellId c) const {
    const auto& vertices = triangulation_.cell(c).vertices;
    return std::any_of(vertices.begin(), vertices.end(),
                       [&](VertexId v) { return is_good_vertex(v); });
  }

  // Through facet i: the label of the cell behind it says that of c. Unmarked: it says nothing.
  CellLabel told(CellId c, int i) const {
    const auto corners = triangulation_.facet_vertices(facet_id(c, i));
    if (std::none_of(corners.begin(), corners.end(),
                     [&](VertexId v) { return is_good_vertex(v); })) {
      return CellLabel::unmarked;
    }
    const CellLabel behind = marks_.labels[triangulation_.neighbor(c, i)];
    if (behind == CellLabel::unmarked || !surface_.contains(facet_id(c, i))) return behind;
    return behind == CellLabel::out ? CellLabel::in : CellLabel::out;
  }

  bool take_label(CellId c) {
    for (int i = 0; i < 4 && marks_.labels[c] == CellLabel::unmarked; ++i) {
      marks_.labels[c] = told(c, i);
    }
    return marks_.labels[c] != CellLabel::unmarked;
  }

  bool fits(CellId c) const {
    for (int i = 0; i < 4; ++i) {
      const CellLabel label = told(c, i);
      if (label != CellLabel::unmarked && label != marks_.labels[c]) return false;
    }
    return true;
  }

  const Triangulation& triangulation_;
  const FacetSet& surface_;
  CellMarks& marks_;
};

// Joins good vertices by edges of the surface between them; returns how many parts there are.
std::size_t join_all_good(const LinkedFacets& surface, const CellMarks& marks, DisjointSets& sets) {
  std::size_t parts = marks.good_vertices;
  for (const Triangle& corners : surface.corners) {
    if (parts == 1) break;
    parts -= join_good(sets, corners, [&](VertexId v) { return marks.good[v] != 0; });
  }
  return parts;
}

// Whether labels were told at once, by all good vertices.
bool are_told_at_once(const CellMarks& marks) {
  return marks.rounds == 0 && marks.visited_vertices == marks.good_vertices;
}

// Whether each of the parts has a good vertex on the hull.
bool are_on_hull(const Triangulation& triangulation, const CellMarks& marks, std::size_t parts,
                 DisjointSets& sets) {
  std::vector<std::uint32_t> seen;
  for (const CellId c : triangulation.infinite_cells()) {
    for (int i = 0; i < 3 && seen.size() < parts; ++i) {
      const VertexId v = triangulation.vertex(c, i);
      if (marks.good[v] == 0) continue;
      const std::uint32_t root = sets.root(v.value);
      if (std::find(seen.begin(), seen.end(), root) == seen.end()) seen.push_back(root);
    }
  }
  return seen.size() == parts;
}

}  // namespace

void KeptMarks::resume(MarkState state) { state_ = std::move(state); }

void KeptMarks::update(const DynamicDelaunay& delaunay, const DelaunayChange& change,
                       const LiveCandidates& candidates) {
  state_.cells.resize(delaunay.view().cell_records().size(), 0);
  state_.vertices.resize(delaunay.num_vertex_slots(), 0);
  for (const CellId c : change.created) state_.cells[c] = is_new;
  for (const VertexId v : candidates.changed()) {
    state_.vertices[v] = static_cast<std::uint8_t>(state_.vertices[v] | has_changed);
  }
}

void KeptMarks::renumber(const Renumbering& renumbering, const DynamicDelaunay& delaunay) {
  for (const auto& [a, b] : renumbering.cells) std::swap(state_.cells[a], state_.cells[b]);
  for (const auto& [from, to] : renumbering.vertices) state_.vertices[to] = state_.vertices[from];
  state_.cells.resize(delaunay.view().cell_records().size());
  state_.vertices.resize(delaunay.num_vertex_slots());
}

CellMarks KeptMarks::mark(const Triangulation& triangulation,
                          const IdVector<VertexId, CellId>& cell_at, const LinkedFacets& surface,
                          const VertexSet& boundary, const KnownLabelsSource& known,
                          const GoodVertexOptions& options, const Execution& execution) {
  std::optional<CellMarks> marks;
  if (exists()) {
    report_progress(execution, "mark_cells", 0);
    marks = go_on({triangulation, cell_at, surface, boundary}, options);
    report_progress(execution, "mark_cells", 1);
  }
  if (marks) {
    ++local_marks_;
  } else {
    marks = mark_cells(triangulation, surface, boundary, known, options, execution);
  }
  keep(surface.set, *marks);
  return std::move(*marks);
}

// None if it is not told by what is kept.
std::optional<CellMarks> KeptMarks::go_on(const Input& input, const GoodVertexOptions& options) {
  std::vector<CellId> cells = changed_cells(input.surface.set);
  const VertexSet changed = changed_vertices(input.triangulation, cells);
  CellMarks marks;
  const std::vector<VertexId> turned = find_good(input, changed, options, marks);
  const std::span<const CellId> stars = stars_.stars(input.triangulation, input.cell_at, turned);
  cells.insert(cells.end(), stars.begin(), stars.end());
  make_set(cells);

  marks.labels.resize(state_.cells.size());
  for (const CellId c : state_.cells.ids()) marks.labels[c] = MarkState::label_of(state_.cells[c]);
  for (const CellId c : cells) marks.labels[c] = CellLabel::unmarked;
  if (!Labeling(input.triangulation, input.surface.set, marks).run(cells)) return {};
  DisjointSets sets(input.triangulation.num_vertices());
  const std::size_t parts = join_all_good(input.surface, marks, sets);
  if (!are_on_hull(input.triangulation, marks, parts, sets)) return {};
  marks.visited = marks.good;
  marks.visited_vertices = marks.good_vertices;
  return marks;
}

// New ones, and those where a facet of the surface came or went.
std::vector<CellId> KeptMarks::changed_cells(const FacetSet& surface) const {
  std::vector<CellId> changed;
  visit_where(
      state_.cells.size(),
      [&](std::size_t c) {
        return (state_.cells[CellId(c)] & (mark_flag::surface_facets | is_new)) !=
               surface.bits(CellId(c));
      },
      [&](std::size_t c) { changed.push_back(CellId(c)); });
  return changed;
}

VertexSet KeptMarks::changed_vertices(const Triangulation& triangulation,
                                      std::span<const CellId> cells) const {
  VertexSet changed(state_.vertices.size());
  for (const VertexId v : state_.vertices.ids())
    changed[v] = (state_.vertices[v] & has_changed) != 0 ? 1 : 0;
  for (const CellId c : cells) {
    for (const VertexId v : triangulation.cell(c).vertices) {
      if (v != infinite_vertex) changed[v] = 1;
    }
  }
  return changed;
}

// Which vertices are good. Returns those that were not before, and the other way round.
std::vector<VertexId> KeptMarks::find_good(const Input& input, const VertexSet& changed,
                                           const GoodVertexOptions& options, CellMarks& marks) {
  std::vector<FacetId> facets;
  for (std::size_t t = 0; t < input.surface.size(); ++t) {
    const auto& [a, b, c] = input.surface.corners[t];
    if ((changed[a] | changed[b] | changed[c]) != 0) facets.push_back(input.surface.facets[t]);
  }
  const LocalFacets local = collector_.link(input.triangulation, std::move(facets));
  VertexSet boundary(local.num_vertices());
  for (const VertexId v : boundary.ids()) boundary[v] = input.boundary[local.vertex_in_whole[v]];
  const GoodVertices found = good_vertices(local.triangles, boundary, options);

  IdVector<VertexId, std::uint8_t> now(changed.size());
  for (const VertexId v : now.ids()) {
    now[v] =
        changed[v] != 0
            ? 0
            : static_cast<std::uint8_t>(state_.vertices[v] & (mark_flag::good | mark_flag::folded));
  }
  for (const VertexId v : found.good.ids()) {
    const VertexId whole = local.vertex_in_whole[v];
    if (changed[whole] != 0 && found.good[v] != 0) now[whole] = mark_flag::good;
  }
  for (const VertexId v : found.folded) {
    const VertexId whole = local.vertex_in_whole[v];
    if (changed[whole] != 0) now[whole] = mark_flag::folded;
  }
  std::vector<VertexId> turned;
  marks.good.resize(now.size());
  for (const VertexId v : now.ids()) {
    marks.good[v] = now[v] & mark_flag::good;
    marks.good_vertices += marks.good[v];
    if ((now[v] & mark_flag::folded) != 0) marks.folded.push_back(v);
    if (((now[v] ^ state_.vertices[v]) & mark_flag::good) != 0) turned.push_back(v);
  }
  return turned;
}

void KeptMarks::keep(const FacetSet& surface, const CellMarks& marks) {
  clear();
  if (!are_told_at_once(marks)) return;
  state_.cells.resize(marks.labels.size());
  for (const CellId c : state_.cells.ids()) {
    const unsigned label = static_cast<unsigned>(marks.labels[c]) << mark_flag::label_shift;
    state_.cells[c] = static_cast<std::uint8_t>(surface.bits(c) | label);
  }
  state_.vertices = marks.good;
  for (const VertexId v : marks.folded) state_.vertices[v] = mark_flag::folded;
}

}  // namespace cocoon
