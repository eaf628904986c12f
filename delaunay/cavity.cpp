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

// Takes c into the conflict zone, and its neighbors into the candidates.
void CavityInserter::add_conflict(CellId c) {
  pool_.marks[c] = CellMark::conflict;
  conflict_cells_.push_back(c);
  for (const FacetId outer : pool_.cells[c].neighbors) {
    const CellId neighbor = cell_of(outer);
    CellMark& mark = pool_.marks[neighbor];
    if (mark != CellMark::untested) continue;
    mark = CellMark::outside;  // until the test says otherwise
    candidates_.push_back(neighbor);
  }
}

// Tests the candidates from `first` on, at most a batch of them; returns the first one left.
std::size_t CavityInserter::test_batch(std::size_t first, const Point& p) {
  const std::size_t count = std::min(conflict_batch_size, candidates_.size() - first);
  std::array<CellId, conflict_batch_size> cells;
  std::array<const Cell*, conflict_batch_size> finite;
  unsigned undecided = 0;
  std::size_t lanes = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const CellId c = candidates_[first + i];
    if (pool_.is_infinite(c)) {
      if (in_conflict(pool_.cells[c], p)) add_conflict(c);
    } else {
      cells[lanes] = c;
      finite[lanes++] = &pool_.cells[c];
    }
  }
  if (lanes == 0) return first + count;
  for (std::size_t i = lanes; i < conflict_batch_size; ++i) finite[i] = finite[0];
  const BatchDecision decision = insphere_batch(finite, points_, p);
  undecided = decision.undecided;
  for (std::size_t i = 0; i < lanes; ++i) {
    const bool inside = ((undecided >> i) & 1U) != 0 ? in_conflict(*finite[i], p)
                                                     : ((decision.inside >> i) & 1U) != 0;
    if (inside) add_conflict(cells[i]);
  }
  return first + count;
}

void CavityInserter::find_conflict_zone(VertexId v, CellId start, DelaunayCounters& counters) {
  const Point p = points_[v];
  conflict_cells_.clear();
  candidates_.clear();
  add_conflict(start);
  for (std::size_t next = 0; next < candidates_.size();) next = test_batch(next, p);
  counters.conflict_tests += candidates_.size();
  collect_border(v);
}

void CavityInserter::collect_border(VertexId v) {
  border_.clear();
  for (const CellId c : conflict_cells_) {
    const Cell& cell = pool_.cells[c];
    for (std::size_t i = 0; i < 4; ++i) {
      const FacetId outer = cell.neighbors[i];
      if (pool_.marks[cell_of(outer)] == CellMark::conflict) continue;
      CavityFacet& facet =
          border_.emplace_back(CavityFacet{cell.vertices, outer, static_cast<int>(i)});
      facet.vertices[i] = v;
    }
  }
}

// New cells take the slots of the conflict cells first: those are in cache.
void CavityInserter::allocate_new_cells() {
  new_cells_.clear();
  for (const CellId c : candidates_) pool_.marks[c] = CellMark::untested;
  for (const CellId c : conflict_cells_) {
    pool_.marks[c] = CellMark::untested;
    if (new_cells_.size() < border_.size()) {
      new_cells_.push_back(c);
    } else {
      pool_.cells[c].vertices[0] = VertexId();
      pool_.free.push_back(c);
    }
  }
  while (new_cells_.size() < border_.size() && !pool_.free.empty()) {
    new_cells_.push_back(pool_.free.back());
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
    for (std::size_t i = 0; i < missing; ++i) new_cells_.push_back(CellId(first + i));
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

// The vertex at infinity takes the entry behind the last vertex.
void CavityInserter::number_border_vertices() {
  border_vertices_.clear();
  for (const CavityFacet& facet : border_) {
    for (std::size_t i = 0; i < 4; ++i) {
      if (static_cast<int>(i) == facet.apex) continue;
      const VertexId vertex =
          facet.vertices[i] == infinite_vertex ? VertexId(points_.size()) : facet.vertices[i];
      if (local_id_[vertex] == no_local_id) {
        local_id_[vertex] = static_cast<std::uint8_t>(border_vertices_.size());
        border_vertices_.push_back(vertex);
      }
    }
  }
}

// Each edge of the border belongs to two border facets, so to two new cells, which see it in
// opposite directions: enter all, then look up the reverse of each.
void CavityInserter::fill_with_edge_table() {
  number_border_vertices();
  const std::size_t stride = border_vertices_.size();
  if (edge_table_.size() < stride * stride) edge_table_.resize(stride * stride);
  const auto local = [&](VertexId vertex) -> std::size_t {
    return local_id_[vertex == infinite_vertex ? VertexId(points_.size()) : vertex];
  };
  for (std::size_t b = 0; b < border_.size(); ++b) {
    build_cell(b);
    const CavityFacet& facet = border_[b];
    const auto& slots = edge_slots[static_cast<std::size_t>(facet.apex)];
    for (std::size_t j = 0; j < 4; ++j) {
      if (static_cast<int>(j) == facet.apex) continue;
      edge_table_[local(facet.vertices[slots[j].first]) * stride +
                  local(facet.vertices[slots[j].second])] =
          facet_id(new_cells_[b], static_cast<int>(j));
    }
  }
  for (std::size_t b = 0; b < border_.size(); ++b) {
    const CavityFacet& facet = border_[b];
    const auto& slots = edge_slots[static_cast<std::size_t>(facet.apex)];
    Cell& cell = pool_.cells[new_cells_[b]];
    for (std::size_t j = 0; j < 4; ++j) {
      if (static_cast<int>(j) == facet.apex) continue;
      cell.neighbors[j] = edge_table_[local(facet.vertices[slots[j].second]) * stride +
                                      local(facet.vertices[slots[j].first])];
    }
  }
  for (const VertexId vertex : border_vertices_) local_id_[vertex] = no_local_id;
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
  find_conflict_zone(v, start, counters);
  allocate_new_cells();
  counters.cells_created += border_.size();
  counters.cells_deleted += conflict_cells_.size();
  // The border is a triangulated sphere: as many vertices as half its facets, plus two.
  if (border_.size() / 2 + 2 <= max_table_vertices) {
    fill_with_edge_table();
  } else {
    fill_with_sorted_edges();
  }
  return new_cells_.back();
}

}  // namespace cocoon
