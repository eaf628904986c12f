#include "delaunay/cavity.h"

#include <algorithm>
#include <string>

#include "delaunay/conflict_batch.h"
#include "geom/errors.h"
#include "geom/orient3d.h"
#include "geom/perturbation.h"

namespace cocoon {
namespace {

constexpr std::uint8_t no_local_id = 0xFF;
// Above this the table of directed edges (its square times 4 bytes) leaves the L2 cache and local
// ids no longer fit a byte; larger holes pair their edges by sorting.
constexpr std::size_t max_table_vertices = 250;

// For facet j != i of a new cell whose apex is in slot i: the slots of the edge that the facet
// shares with the border facet, directed so that the cell behind sees the reverse direction.
// edge_slots[i][j] = the two slots other than i and j, in the order that makes
// (i, first, second) the corners of facet j, seen from outside.
struct EdgeSlots {
  std::uint8_t first;
  std::uint8_t second;
};

constexpr std::array<std::array<EdgeSlots, 4>, 4> make_edge_slots() {
  std::array<std::array<EdgeSlots, 4>, 4> slots{};
  for (std::size_t j = 0; j < 4; ++j) {
    for (int k = 0; k < 3; ++k) {
      const int apex = facet_corners[j][k];
      slots[static_cast<std::size_t>(apex)][j] = {
          static_cast<std::uint8_t>(facet_corners[j][(k + 1) % 3]),
          static_cast<std::uint8_t>(facet_corners[j][(k + 2) % 3])};
    }
  }
  return slots;
}

constexpr auto edge_slots = make_edge_slots();

}  // namespace

CavityInserter::CavityInserter(CellPool& pool, const IdVector<VertexId, Point>& points)
    : pool_(pool), points_(points), local_id_(points.size() + 1, no_local_id) {}

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

void CavityInserter::collect_candidates(CellId conflict_cell) {
  candidates_.make_room(4);
  for (const FacetId outer : pool_.cells[conflict_cell].neighbors) {
    const CellId neighbor = cell_of(outer);
    __builtin_prefetch(&pool_.cells[neighbor]);
    CellMark& mark = pool_.marks[neighbor];
    const bool is_new = mark == CellMark::untested;
    mark = is_new ? CellMark::outside : mark;  // until the test says otherwise
    candidates_.append_if(is_new, neighbor);
  }
}

// Tests the candidates from `first` on, at most a batch of them, and moves those in conflict to the
// conflict zone. Returns the first one left.
std::size_t CavityInserter::test_candidates(std::size_t first, const Point& p) {
  const std::size_t count = std::min(conflict_batch_size, candidates_.size() - first);
  conflict_cells_.make_room(count);
  const auto decide = [&](CellId c, bool conflict) {
    pool_.marks[c] = conflict ? CellMark::conflict : CellMark::outside;
    conflict_cells_.append_if(conflict, c);
  };
  std::array<CellId, conflict_batch_size> ids;
  std::array<const Cell*, conflict_batch_size> cells;
  std::size_t lanes = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const CellId c = candidates_[first + i];
    if (pool_.is_infinite(c)) {
      decide(c, in_conflict(pool_.cells[c], p));
    } else {
      ids[lanes] = c;
      cells[lanes++] = &pool_.cells[c];
    }
  }
  if (lanes > 0) {
    for (std::size_t i = lanes; i < conflict_batch_size; ++i) cells[i] = cells[0];
    BatchDecision decision = insphere_batch(cells, points_, p);
    for (std::size_t i = 0; i < lanes; ++i) {
      if (((decision.undecided >> i) & 1U) != 0 && in_conflict(*cells[i], p)) {
        decision.inside |= 1U << i;
      }
      decide(ids[i], ((decision.inside >> i) & 1U) != 0);
    }
  }
  return first + count;
}

void CavityInserter::find_conflict_zone(VertexId v, CellId start) {
  const Point p = points_[v];
  conflict_cells_.clear();
  candidates_.clear();
  conflict_cells_.make_room(1);
  conflict_cells_.append(start);
  pool_.marks[start] = CellMark::conflict;
  std::size_t tested = 0;
  std::size_t expanded = 0;
  while (expanded < conflict_cells_.size() || tested < candidates_.size()) {
    if (expanded < conflict_cells_.size()) {
      collect_candidates(conflict_cells_[expanded++]);
    } else {
      tested = test_candidates(tested, p);
    }
  }
}

void CavityInserter::collect_border(VertexId v) {
  border_facets_.clear();
  border_facets_.make_room(4 * conflict_cells_.size());
  for (const CellId c : conflict_cells_) {
    const Cell& cell = pool_.cells[c];
    for (int i = 0; i < 4; ++i) {
      const CellId neighbor = cell_of(cell.neighbors[static_cast<std::size_t>(i)]);
      border_facets_.append_if(pool_.marks[neighbor] != CellMark::conflict, facet_id(c, i));
    }
  }
  border_.clear();
  border_.make_room(border_facets_.size());
  border_vertices_.clear();
  border_vertices_.make_room(max_table_vertices + 1);
  for (const FacetId facet : border_facets_) describe_border_facet(facet, v);
  for (const VertexId entry : border_vertices_) local_id_[entry] = no_local_id;
}

// Border vertices are numbered in order of first sight, up to the number that the table of edges
// can hold. The vertex at infinity takes the entry behind the last vertex.
void CavityInserter::describe_border_facet(FacetId facet, VertexId v) {
  const Cell& cell = pool_.cells[cell_of(facet)];
  const auto apex = static_cast<std::size_t>(index_of(facet));
  CavityFacet result{cell.vertices, {}, cell.neighbors[apex], index_of(facet)};
  result.vertices[apex] = v;
  for (std::size_t k = 1; k < 4; ++k) {
    const std::size_t slot = (apex + k) % 4;
    const VertexId entry = std::min(cell.vertices[slot], VertexId(points_.size()));
    const std::uint8_t known = local_id_[entry];
    const bool is_new = known == no_local_id && border_vertices_.size() < max_table_vertices;
    const std::uint8_t id = is_new ? static_cast<std::uint8_t>(border_vertices_.size()) : known;
    local_id_[entry] = id;
    result.local_ids[slot] = id;
    border_vertices_.append_if(is_new, entry);
  }
  border_.append(result);
}

// New cells take the slots of the conflict cells first: those are in cache.
void CavityInserter::allocate_new_cells() {
  for (const CellId c : candidates_) pool_.marks[c] = CellMark::untested;
  pool_.marks[conflict_cells_[0]] = CellMark::untested;  // the start was no candidate
  new_cells_.clear();
  new_cells_.make_room(border_.size());
  const std::size_t reused = std::min(conflict_cells_.size(), border_.size());
  for (std::size_t i = 0; i < reused; ++i) new_cells_.append(conflict_cells_[i]);
  for (std::size_t i = reused; i < conflict_cells_.size(); ++i) {
    pool_.cells[conflict_cells_[i]].vertices[0] = VertexId();
    pool_.free.push_back(conflict_cells_[i]);
  }
  while (new_cells_.size() < border_.size() && !pool_.free.empty()) {
    new_cells_.append(pool_.free.back());
    pool_.free.pop_back();
  }
  if (const std::size_t missing = border_.size() - new_cells_.size(); missing > 0) {
    const std::size_t first = pool_.cells.size();
    if (first + missing > max_cells) {
      throw InputError("too many points: the triangulation needs more than " +
                       std::to_string(max_cells) + " tetrahedra, the most that can be numbered");
    }
    pool_.cells.resize(first + missing);
    pool_.marks.resize(first + missing, CellMark::untested);
    for (std::size_t i = 0; i < missing; ++i) new_cells_.append(CellId(first + i));
  }
}

void CavityInserter::build_cell(std::size_t border_index) {
  const CavityFacet& facet = border_[border_index];
  const CellId c = new_cells_[border_index];
  Cell& cell = pool_.cells[c];
  cell.vertices = facet.vertices;
  cell.neighbors[static_cast<std::size_t>(facet.apex)] = facet.outer;
  pool_.cells[cell_of(facet.outer)].neighbors[static_cast<std::size_t>(index_of(facet.outer))] =
      facet_id(c, facet.apex);
}

// Each edge of the border belongs to two border facets, so to two new cells, which see it in
// opposite directions: enter all, then look up the reverse of each.
void CavityInserter::fill_with_edge_table() {
  const std::size_t stride = border_vertices_.size();
  if (edge_table_.size() < stride * stride) edge_table_.resize(stride * stride);
  for (std::size_t b = 0; b < border_.size(); ++b) {
    build_cell(b);
    const CavityFacet& facet = border_[b];
    const auto& slots = edge_slots[static_cast<std::size_t>(facet.apex)];
    for (std::size_t k = 1; k < 4; ++k) {
      const std::size_t j = (static_cast<std::size_t>(facet.apex) + k) % 4;
      edge_table_[facet.local_ids[slots[j].first] * stride + facet.local_ids[slots[j].second]] =
          facet_id(new_cells_[b], static_cast<int>(j));
    }
  }
  for (std::size_t b = 0; b < border_.size(); ++b) {
    const CavityFacet& facet = border_[b];
    const auto& slots = edge_slots[static_cast<std::size_t>(facet.apex)];
    Cell& cell = pool_.cells[new_cells_[b]];
    for (std::size_t k = 1; k < 4; ++k) {
      const std::size_t j = (static_cast<std::size_t>(facet.apex) + k) % 4;
      cell.neighbors[j] =
          edge_table_[facet.local_ids[slots[j].second] * stride + facet.local_ids[slots[j].first]];
    }
  }
}

void CavityInserter::fill_with_sorted_edges() {
  struct EdgeFacet {
    VertexId low, high;  // the edge, undirected
    FacetId facet;
  };
  std::vector<EdgeFacet> edges;
  edges.reserve(border_.size() * 3);
  for (std::size_t b = 0; b < border_.size(); ++b) {
    build_cell(b);
    const CavityFacet& facet = border_[b];
    const auto& slots = edge_slots[static_cast<std::size_t>(facet.apex)];
    for (std::size_t j = 0; j < 4; ++j) {
      if (static_cast<int>(j) == facet.apex) continue;
      const auto [low, high] =
          std::minmax(facet.vertices[slots[j].first], facet.vertices[slots[j].second]);
      edges.push_back({low, high, facet_id(new_cells_[b], static_cast<int>(j))});
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

CellId CavityInserter::insert(VertexId v, CellId start, DelaunayCounters& counters) {
  find_conflict_zone(v, start);
  collect_border(v);
  allocate_new_cells();
  if (border_vertices_.size() < max_table_vertices) {
    fill_with_edge_table();
  } else {
    fill_with_sorted_edges();
  }
  counters.conflict_tests += candidates_.size();
  counters.cells_created += border_.size();
  counters.cells_deleted += conflict_cells_.size();
  return new_cells_[new_cells_.size() - 1];
}

}  // namespace cocoon
