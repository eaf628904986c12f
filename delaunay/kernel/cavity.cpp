#include "delaunay/kernel/cavity.h"

#include <algorithm>
#include <array>
#include <bit>
#include <utility>

namespace cocoon {
namespace {

// Vertices of a zone are numbered by their places in its list. Of the table of directed edges most
// zones use 24 rows of 24 entries, which stay in the L1 cache. Local ids fit a byte, and a table of
// 256 rows the L2 cache; the few larger zones pair their edges by hashing.
constexpr unsigned small_stride = 64;
constexpr unsigned large_stride = 256;

// Entry of local_id_: the vertex at infinity, number 2^32 - 2, has the first.
constexpr std::size_t entry_of(VertexId v) { return v.value + 2U; }
static_assert(entry_of(infinite_vertex) == 0);

// facet_corners in four bytes each.
constexpr std::uint8_t facet_slots[4][4] = {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}};

// The vertices of a facet, in the order that faces the cell in front of it.
Triangle corners_of(const Cell& behind, FacetId facet) {
  const auto& corner = facet_slots[index_of(facet)];
  return {behind.vertices[corner[0]], behind.vertices[corner[1]], behind.vertices[corner[2]]};
}

}  // namespace

CavityInserter::CavityInserter(CellPool& pool, const IdVector<VertexId, Point>& points,
                               const Execution& execution)
    : pool_(pool),
      points_(points),
      shared_{nullptr, &pool.free, nullptr},
      search_(pool, points, execution),
      local_id_(points.size() + 2),
      edge_table_(std::size_t{large_stride} * large_stride) {}

CavityInserter::CavityInserter(const CavityInserter& other, const SharedInsertion& shared)
    : pool_(other.pool_),
      points_(other.points_),
      shared_(shared),
      search_(other.search_),
      local_id_(other.local_id_.size()),
      edge_table_(std::size_t{large_stride} * large_stride) {
  search_.search_beside_others(*shared.holder);
}

void CavityInserter::admit(const Point& p) {
  if (local_id_.size() < points_.size() + 2) local_id_.resize(points_.size() + 2);
  search_.admit(p);
}

void CavityInserter::read_points_again() {
  if (local_id_.size() < points_.size() + 2) local_id_.resize(points_.size() + 2);
  search_.read_points_again();
}

std::size_t CavityInserter::num_slots_wanted() const {
  const ConflictZone& zone = search_.zone();
  return std::max(zone.border().size(), zone.cells().size()) - zone.cells().size();
}

// Makes one new cell for each border facet: its corners, and the new vertex in slot 3. Each edge of
// the border belongs to two facets, which see it in opposite directions: enter the new cell's facet
// at each directed edge, in a table by local numbers of the vertices, then look up the reverse.
// Edge (corner 0, corner 1) belongs to the facet opposite corner 2, and so on around.
template <unsigned stride, bool notes_cells>
void CavityInserter::build_star(VertexId v, const ConflictZone& zone) {
  const std::span<const FacetId> border = zone.border();
  const std::span<const VertexId> vertices = zone.vertices();
  if (reverse_edges_.size() < border.size()) reverse_edges_.resize(2 * border.size());
  Cell* const cells = pool_.cells.raw().data();
  std::uint8_t* const local_id = local_id_.data();
  FacetId* const table = edge_table_.data();
  std::array<std::uint16_t, 3>* const reverse_edges = reverse_edges_.data();
  const CellId* const slots = slots_.data();
  // A vertex that is listed twice gets the second number.
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    local_id[entry_of(vertices[i])] = static_cast<std::uint8_t>(i);
  }
  for (std::size_t b = 0; b < border.size(); ++b) {
    const FacetId outer = border[b];
    const CellId c = slots[b];
    Cell& behind = cells[cell_of(outer).index()];
    Cell& created = cells[c.index()];
    const auto [v0, v1, v2] = corners_of(behind, outer);
    created.vertices = {v0, v1, v2, v};
    created.neighbors[3] = outer;
    behind.neighbors[static_cast<std::size_t>(index_of(outer))] = facet_id(c, 3);
    const std::size_t id0 = local_id[entry_of(v0)];
    const std::size_t id1 = local_id[entry_of(v1)];
    const std::size_t id2 = local_id[entry_of(v2)];
    if constexpr (notes_cells) {
      for (const VertexId w : {v0, v1, v2}) shared_.cell_at[w.index()] = c;
    }
    const std::size_t row0 = stride * id0;
    const std::size_t row1 = stride * id1;
    const std::size_t row2 = stride * id2;
    table[row0 + id1] = facet_id(c, 2);
    table[row1 + id2] = facet_id(c, 0);
    table[row2 + id0] = facet_id(c, 1);
    reverse_edges[b] = {static_cast<std::uint16_t>(row2 + id1),
                        static_cast<std::uint16_t>(row0 + id2),
                        static_cast<std::uint16_t>(row1 + id0)};
  }
  for (std::size_t b = 0; b < border.size(); ++b) {
    Cell& cell = cells[slots[b].index()];
    for (std::size_t i = 0; i < 3; ++i) cell.neighbors[i] = table[reverse_edges[b][i]];
  }
}

// The same for borders of any size: the first of the two facets at an edge waits for the other one
// in a hash table.
void CavityInserter::build_large_star(VertexId v, std::span<const FacetId> border) {
  const std::size_t size = std::bit_ceil(4 * border.size());
  const int shift = 64 - std::countr_zero(size);
  waiting_.assign(size, {});
  const auto pair_up = [&](FacetId facet, VertexId a, VertexId b) {
    const std::uint64_t edge = std::uint64_t{std::min(a, b).value} << 32 | std::max(a, b).value;
    std::size_t place = edge * 0x9E3779B97F4A7C15U >> shift;
    while (waiting_[place].edge != edge && waiting_[place].edge != no_edge) {
      place = (place + 1) & (size - 1);
    }
    if (waiting_[place].edge == no_edge) {
      waiting_[place] = {edge, facet};
      return;
    }
    const FacetId other = waiting_[place].facet;
    pool_.cells[cell_of(facet)].neighbors[static_cast<std::size_t>(index_of(facet))] = other;
    pool_.cells[cell_of(other)].neighbors[static_cast<std::size_t>(index_of(other))] = facet;
  };
  for (std::size_t b = 0; b < border.size(); ++b) {
    const FacetId outer = border[b];
    const CellId c = slots_[b];
    Cell& behind = pool_.cells[cell_of(outer)];
    const auto [v0, v1, v2] = corners_of(behind, outer);
    pool_.cells[c].vertices = {v0, v1, v2, v};
    pool_.cells[c].neighbors[3] = outer;
    behind.neighbors[static_cast<std::size_t>(index_of(outer))] = facet_id(c, 3);
    pair_up(facet_id(c, 0), v1, v2);
    pair_up(facet_id(c, 1), v2, v0);
    pair_up(facet_id(c, 2), v0, v1);
  }
}

void CavityInserter::note_cells_at_corners() {
  for (const CellId c : slots_) {
    for (const VertexId w : pool_.cells[c].vertices) {
      if (w != infinite_vertex) shared_.cell_at[w.index()] = c;
    }
  }
}

// Brings the vertex at infinity to slot 3 of a new cell that has it elsewhere.
void CavityInserter::put_infinite_last(CellId c) {
  Cell& cell = pool_.cells[c];
  const auto slot = static_cast<std::size_t>(
      std::find(cell.vertices.begin(), cell.vertices.begin() + 3, infinite_vertex) -
      cell.vertices.begin());
  if (slot == 3) return;
  // Two exchanges keep the orientation.
  const auto exchange = [&](std::size_t i, std::size_t k) {
    std::swap(cell.vertices[i], cell.vertices[k]);
    std::swap(cell.neighbors[i], cell.neighbors[k]);
  };
  exchange(slot, 3);
  exchange((slot + 1) % 3, (slot + 2) % 3);
  for (int i = 0; i < 4; ++i) {
    const FacetId outer = cell.neighbors[static_cast<std::size_t>(i)];
    pool_.cells[cell_of(outer)].neighbors[static_cast<std::size_t>(index_of(outer))] =
        facet_id(c, i);
  }
}

void CavityInserter::fill_hole(VertexId v, const ConflictZone& zone) {
  const bool is_shared = shared_.cell_at != nullptr;
  const std::size_t vertices = zone.vertices().size();
  const bool notes_cells = is_shared && !zone.has_infinite() && vertices <= large_stride;
  if (vertices <= small_stride) {
    notes_cells ? build_star<small_stride, true>(v, zone)
                : build_star<small_stride, false>(v, zone);
  } else if (vertices <= large_stride) {
    notes_cells ? build_star<large_stride, true>(v, zone)
                : build_star<large_stride, false>(v, zone);
  } else {
    build_large_star(v, zone.border());
  }
  if (is_shared && !notes_cells) note_cells_at_corners();
  if (is_shared) shared_.cell_at[v.index()] = slots_[0];
}

CellId CavityInserter::insert(VertexId v, CellId start, DelaunayCounters& counters) {
  search_.find_zone(points_[v], start, counters);
  return fill_zone(v, counters);
}

CellId CavityInserter::fill_zone(VertexId v, DelaunayCounters& counters) {
  const ConflictZone& zone = search_.zone();
  search_.unmark_zone();
  // The places of the cells that go are in cache.
  take_places(pool_, *shared_.free, zone.cells(), zone.border().size(), slots_);
  fill_hole(v, zone);
  if (zone.has_infinite()) {
    for (const CellId c : slots_) put_infinite_last(c);
  }
  counters.cells_created += zone.border().size();
  counters.cells_deleted += zone.cells().size();
  return slots_[0];
}

}  // namespace cocoon
