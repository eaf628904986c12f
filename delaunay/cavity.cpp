#include "delaunay/cavity.h"

#include <algorithm>
#include <array>
#include <bit>
#include <string>

#include "geom/errors.h"
#include "geom/orient3d.h"
#include "geom/perturbation.h"

namespace cocoon {
namespace {

constexpr std::uint8_t no_local_id = 0xFF;
// Local ids fit a byte, and the table of directed edges stays in the L2 cache; the few larger
// borders pair their edges by sorting.
constexpr std::size_t max_table_vertices = 250;
// A border of at most 2^small_shift vertices uses a table of 4 KiB, which stays in the L1 cache.
constexpr unsigned small_shift = 5;
constexpr unsigned large_shift = 8;

}  // namespace

CavityInserter::CavityInserter(CellPool& pool, const IdVector<VertexId, Point>& points)
    : pool_(pool),
      points_(points),
      filter_(points),
      edge_table_(std::size_t{1} << (2 * large_shift)) {
  make_room_for_points();
}

void CavityInserter::make_room_for_points() {
  if (local_id_.size() < points_.size()) local_id_.resize(points_.size(), no_local_id);
}

void CavityInserter::read_points_again() {
  make_room_for_points();
  filter_.read_points_again();
}

// A finite cell is in conflict iff its (perturbed) circumsphere contains p. An infinite cell is
// iff p lies beyond its hull facet; a point in the plane of the hull facet lies in the facet's
// circumcircle iff it lies in the sphere of the finite cell behind it, perturbation included.
bool CavityInserter::in_conflict(const Cell& cell, const Point& p) const {
  const Cell* finite = &cell;
  if (cell.vertices[3] == infinite_vertex) {
    const Sign side = orient3d(points_[cell.vertices[0]], points_[cell.vertices[1]],
                               points_[cell.vertices[2]], p);
    if (side != Sign::zero) return side == Sign::positive;
    finite = &pool_.cells[cell_of(cell.neighbors[3])];
  }
  return insphere_perturbed(points_[finite->vertices[0]], points_[finite->vertices[1]],
                            points_[finite->vertices[2]], points_[finite->vertices[3]],
                            p) == Sign::positive;
}

// The same for a finite cell that has p on its circumsphere.
bool CavityInserter::in_conflict_on_sphere(const Cell& cell, const Point& p) const {
  return break_cospherical_tie(points_[cell.vertices[0]], points_[cell.vertices[1]],
                               points_[cell.vertices[2]], points_[cell.vertices[3]],
                               p) == Sign::positive;
}

void CavityInserter::collect_candidates(CellId conflict_cell) {
  auto candidates = candidates_.writer(4);
  CellMark* const marks = pool_.marks.raw().data();
  for (const FacetId outer : pool_.cells[conflict_cell].neighbors) {
    const CellId neighbor = cell_of(outer);
    __builtin_prefetch(&pool_.cells[neighbor]);
    const CellMark mark = marks[neighbor.index()];
    const bool is_new = mark == CellMark::untested;
    marks[neighbor.index()] = is_new ? CellMark::outside : mark;  // until the test says otherwise
    candidates.append_if(is_new, neighbor);
  }
  candidates_.commit(candidates);
}

// Tests the candidates from `first` on, at most a batch of them, and moves those in conflict to the
// conflict zone. Returns the first one left.
std::size_t CavityInserter::test_candidates(std::size_t first, const Point& p,
                                            DelaunayCounters& counters) {
  const std::size_t count = std::min(conflict_batch_size, candidates_.size() - first);
  std::array<CellId, conflict_batch_size> ids;
  for (std::size_t i = 0; i < conflict_batch_size; ++i) {
    ids[i] = candidates_[first + std::min(i, count - 1)];
  }
  BatchDecision decision = filter_.test(pool_.cells, ids.data(), p);
  // What the filter leaves open, and infinite cells, one by one.
  const unsigned lanes = (1U << count) - 1;
  counters.conflict_tests += count;
  for (unsigned open = (decision.on_sphere | decision.undecided | decision.infinite) & lanes;
       open != 0; open &= open - 1) {
    const auto lane = static_cast<unsigned>(std::countr_zero(open));
    const Cell& cell = pool_.cells[ids[lane]];
    const auto has = [&](unsigned lanes_of_kind) { return ((lanes_of_kind >> lane) & 1U) != 0; };
    const bool is_tie = has(decision.on_sphere) && !has(decision.infinite);
    const bool conflict = is_tie ? in_conflict_on_sphere(cell, p) : in_conflict(cell, p);
    counters.perturbed_inspheres += is_tie ? 1 : 0;
    counters.exact_inspheres += is_tie || has(decision.infinite) ? 0 : 1;
    decision.inside = (decision.inside & ~(1U << lane)) | ((conflict ? 1U : 0U) << lane);
  }
  auto conflict_cells = conflict_cells_.writer(conflict_batch_size);
  CellMark* const marks = pool_.marks.raw().data();
  for (std::size_t i = 0; i < count; ++i) {
    const bool conflict = ((decision.inside >> i) & 1U) != 0;
    marks[ids[i].index()] = conflict ? CellMark::conflict : CellMark::outside;
    conflict_cells.append_if(conflict, ids[i]);
  }
  conflict_cells_.commit(conflict_cells);
  return first + count;
}

void CavityInserter::find_conflict_zone(VertexId v, CellId start, DelaunayCounters& counters) {
  const Point p = points_[v];
  candidates_.clear();
  conflict_cells_.clear();
  auto conflict_cells = conflict_cells_.writer(1);
  conflict_cells.append(start);
  conflict_cells_.commit(conflict_cells);
  pool_.marks[start] = CellMark::conflict;
  std::size_t expanded = 0;
  std::size_t tested = 0;
  while (expanded < conflict_cells_.size() || tested < candidates_.size()) {
    if (expanded < conflict_cells_.size()) {
      collect_candidates(conflict_cells_[expanded++]);
    } else {
      tested = test_candidates(tested, p, counters);
    }
  }
}

void CavityInserter::collect_border() {
  border_.clear();
  auto border = border_.writer(4 * conflict_cells_.size());
  const CellMark* const marks = pool_.marks.raw().data();
  const Cell* const cells = pool_.cells.raw().data();
  for (const CellId c : conflict_cells_) {
    for (int i = 0; i < 4; ++i) {
      const CellId neighbor = cell_of(cells[c.index()].neighbors[static_cast<std::size_t>(i)]);
      border.append_if(marks[neighbor.index()] != CellMark::conflict, facet_id(c, i));
    }
  }
  border_.commit(border);
}

// Appends `count` cells to the pool.
void CavityInserter::grow_pool(std::size_t count) {
  const std::size_t end = pool_.cells.size() + count;
  if (end > max_cells) {
    unmark_cells();
    throw InputError("too many points: the triangulation needs more than " +
                     std::to_string(max_cells) + " tetrahedra, the most that can be numbered");
  }
  pool_.cells.resize(end);
  pool_.marks.resize(end, CellMark::untested);
}

// Makes one new cell for each border facet, linked to the cell outside, and numbers the vertices of
// the border in order of first sight, as far as a byte goes. The vertex at infinity has the
// entry behind the last vertex in local_id_.
void CavityInserter::build_star(VertexId v) {
  // Cells freed just now, which are in cache, go first.
  const std::size_t reused = std::min(border_.size(), pool_.free.size());
  const CellId* free_end = pool_.free.data() + pool_.free.size();
  const CellId* const last_reused = free_end - reused;
  CellId fresh(pool_.cells.size());
  if (reused < border_.size()) grow_pool(border_.size() - reused);
  Cell* const cells = pool_.cells.raw().data();
  std::uint8_t* const local_id = local_id_.raw().data();
  const VertexId past_last(points_.size() - 1);
  star_.clear();
  local_corners_.clear();
  border_vertices_.clear();
  auto star = star_.writer(border_.size());
  auto local_corners = local_corners_.writer(border_.size());
  auto border_vertices = border_vertices_.writer(3 * border_.size());
  unsigned numbered = 0;
  for (const FacetId facet : border_) {
    const Cell& old = cells[cell_of(facet).index()];
    const auto apex = static_cast<std::size_t>(index_of(facet));
    const FacetId outer = old.neighbors[apex];
    CellId slot = fresh;
    if (free_end != last_reused) {
      slot = *--free_end;
    } else {
      ++fresh;
    }
    const FacetId inner = facet_id(slot, index_of(facet));
    Cell& created = cells[cell_of(inner).index()];
    created.vertices = old.vertices;
    created.vertices[apex] = v;
    created.neighbors[apex] = outer;
    cells[cell_of(outer).index()].neighbors[static_cast<std::size_t>(index_of(outer))] = inner;
    LocalIds ids;
    for (std::size_t k = 0; k < 3; ++k) {
      const auto corner = static_cast<std::size_t>(facet_corners[apex][k]);
      const VertexId entry = std::min(old.vertices[corner], past_last);
      // Arithmetic instead of branches: whether a vertex was seen before is a coin toss.
      const unsigned known = local_id[entry.index()];
      const unsigned is_new = (known + 1) >> 8;  // known == no_local_id
      const unsigned id = known ^ ((known ^ numbered) & (0U - is_new));
      ids[k] = static_cast<std::uint8_t>(id);
      local_id[entry.index()] = ids[k];
      numbered += is_new;
      border_vertices.append_if(is_new != 0, entry);
    }
    star.append(inner);
    local_corners.append(ids);
  }
  star_.commit(star);
  local_corners_.commit(local_corners);
  border_vertices_.commit(border_vertices);
  pool_.free.resize(pool_.free.size() - reused);
  for (const VertexId entry : border_vertices_) local_id[entry.index()] = no_local_id;
}

// The border is an oriented sphere: each of its edges belongs to two facets, which see it in
// opposite directions. Enter the new cell's facet at each directed edge, then look up the reverse.
// The facet at edge (corner 0, corner 1) lies opposite corner 2, and so on around.
void CavityInserter::link_by_edge_table(unsigned shift) {
  Cell* const cells = pool_.cells.raw().data();
  FacetId* const table = edge_table_.data();
  const auto entry = [&](std::uint8_t from, std::uint8_t to) -> FacetId& {
    return table[(std::size_t{from} << shift) | to];
  };
  for (std::size_t b = 0; b < star_.size(); ++b) {
    const CellId c = cell_of(star_[b]);
    const int* corners = facet_corners[index_of(star_[b])];
    const LocalIds ids = local_corners_[b];
    entry(ids[0], ids[1]) = facet_id(c, corners[2]);
    entry(ids[1], ids[2]) = facet_id(c, corners[0]);
    entry(ids[2], ids[0]) = facet_id(c, corners[1]);
  }
  for (std::size_t b = 0; b < star_.size(); ++b) {
    Cell& cell = cells[cell_of(star_[b]).index()];
    const int* corners = facet_corners[index_of(star_[b])];
    const LocalIds ids = local_corners_[b];
    cell.neighbors[static_cast<std::size_t>(corners[2])] = entry(ids[1], ids[0]);
    cell.neighbors[static_cast<std::size_t>(corners[0])] = entry(ids[2], ids[1]);
    cell.neighbors[static_cast<std::size_t>(corners[1])] = entry(ids[0], ids[2]);
  }
}

// The same for borders of any size.
void CavityInserter::link_by_sorted_edges() {
  struct EdgeFacet {
    VertexId low, high;  // the edge, undirected
    FacetId facet;
  };
  std::vector<EdgeFacet> edges;
  edges.reserve(star_.size() * 3);
  for (const FacetId facet : star_) {
    const Cell& cell = pool_.cells[cell_of(facet)];
    const int* corners = facet_corners[index_of(facet)];
    for (int k = 0; k < 3; ++k) {
      const auto [low, high] =
          std::minmax(cell.vertices[static_cast<std::size_t>(corners[(k + 1) % 3])],
                      cell.vertices[static_cast<std::size_t>(corners[(k + 2) % 3])]);
      edges.push_back({low, high, facet_id(cell_of(facet), corners[k])});
    }
  }
  std::sort(edges.begin(), edges.end(), [](const EdgeFacet& a, const EdgeFacet& b) {
    return a.low != b.low ? a.low < b.low : a.high < b.high;
  });
  const auto link = [&](FacetId facet, FacetId to) {
    pool_.cells[cell_of(facet)].neighbors[static_cast<std::size_t>(index_of(facet))] = to;
  };
  for (std::size_t i = 0; i < edges.size(); i += 2) {
    link(edges[i].facet, edges[i + 1].facet);
    link(edges[i + 1].facet, edges[i].facet);
  }
}

void CavityInserter::unmark_cells() {
  CellMark* const marks = pool_.marks.raw().data();
  marks[conflict_cells_[0].index()] = CellMark::untested;  // the start was no candidate
  for (const CellId c : candidates_) marks[c.index()] = CellMark::untested;
}

void CavityInserter::release_conflict_zone() {
  unmark_cells();
  for (const CellId c : conflict_cells_) pool_.cells[c].vertices[0] = VertexId();
  pool_.free.insert(pool_.free.end(), conflict_cells_.begin(), conflict_cells_.end());
}

CellId CavityInserter::insert(VertexId v, CellId start, DelaunayCounters& counters) {
  filter_.admit(points_[v]);
  find_conflict_zone(v, start, counters);
  collect_border();
  build_star(v);
  if (border_vertices_.size() <= (std::size_t{1} << small_shift)) {
    link_by_edge_table(small_shift);
  } else if (border_vertices_.size() < max_table_vertices) {
    link_by_edge_table(large_shift);
  } else {
    link_by_sorted_edges();
  }
  release_conflict_zone();
  counters.cells_created += star_.size();
  counters.cells_deleted += conflict_cells_.size();
  return cell_of(star_[0]);
}

}  // namespace cocoon
