#include "delaunay/canonical_order.h"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

namespace cocoon {
namespace {

// Where each slot of a record went: two bits per old slot.
using SlotMap = std::uint8_t;

constexpr std::uint32_t new_slot(SlotMap map, std::uint32_t old_slot) {
  return (static_cast<std::uint32_t>(map) >> (2 * old_slot)) & 3U;
}

// Brings one record into canonical form by an even permutation of its slots.
SlotMap canonicalize_slots(Cell& cell) {
  struct Slot {
    VertexId vertex;
    FacetId neighbor;
    std::uint32_t old;
  };
  std::array<Slot, 4> slots;
  for (std::uint32_t i = 0; i < 4; ++i) slots[i] = {cell.vertices[i], cell.neighbors[i], i};
  const auto swap_if_greater = [&](std::size_t i, std::size_t j) {
    if (!(slots[j].vertex < slots[i].vertex)) return 0;
    std::swap(slots[i], slots[j]);
    return 1;
  };
  if (cell.vertices[3] == infinite_vertex) {
    const auto smallest =
        std::min_element(slots.begin(), slots.begin() + 3,
                         [](const Slot& a, const Slot& b) { return a.vertex < b.vertex; });
    std::rotate(slots.begin(), smallest, slots.begin() + 3);
  } else {
    const int swaps = swap_if_greater(0, 1) + swap_if_greater(2, 3) + swap_if_greater(0, 2) +
                      swap_if_greater(1, 3) + swap_if_greater(1, 2);
    if (swaps % 2 != 0) std::swap(slots[2], slots[3]);
  }
  SlotMap map = 0;
  for (std::uint32_t i = 0; i < 4; ++i) {
    cell.vertices[i] = slots[i].vertex;
    cell.neighbors[i] = slots[i].neighbor;
    map = static_cast<SlotMap>(map | (i << (2 * slots[i].old)));
  }
  return map;
}

// Cells in canonical order, then the free ones: order[new id] = old id.
std::vector<CellId> sorted_cells(const CellPool& pool, std::size_t num_vertices,
                                 std::size_t& finite_cells, std::size_t& live_cells) {
  // Counting sort by (infinite, smallest vertex), which is vertices[0] of a canonical record ...
  std::vector<std::uint32_t> offsets(2 * num_vertices + 2, 0);
  const auto bucket = [&](CellId c) {
    if (pool.is_free(c)) return 2 * num_vertices;
    return pool.cells[c].vertices[0].index() + (pool.is_infinite(c) ? num_vertices : 0);
  };
  for (const CellId c : pool.cells.ids()) ++offsets[bucket(c) + 1];
  for (std::size_t b = 1; b < offsets.size(); ++b) offsets[b] += offsets[b - 1];
  finite_cells = offsets[num_vertices];
  live_cells = offsets[2 * num_vertices];
  std::vector<CellId> order(pool.cells.size());
  for (const CellId c : pool.cells.ids()) order[offsets[bucket(c)]++] = c;
  // ... then by the whole record inside each bucket. The offsets now are the buckets' ends.
  std::size_t begin = 0;
  for (std::size_t b = 0; b < 2 * num_vertices; ++b) {
    const std::size_t end = offsets[b];
    std::sort(order.begin() + static_cast<std::ptrdiff_t>(begin),
              order.begin() + static_cast<std::ptrdiff_t>(end),
              [&](CellId x, CellId y) { return pool.cells[x].vertices < pool.cells[y].vertices; });
    begin = end;
  }
  return order;
}

// cells[i] = old cells[order[i]], following the cycles of the permutation.
void permute_in_place(IdVector<CellId, Cell>& cells, std::vector<CellId>& order) {
  for (std::size_t first = 0; first < order.size(); ++first) {
    if (order[first] == CellId(first)) continue;
    const Cell saved = cells[CellId(first)];
    std::size_t hole = first;
    while (order[hole] != CellId(first)) {
      const CellId from = order[hole];
      cells[CellId(hole)] = cells[from];
      order[hole] = CellId(hole);
      hole = from.index();
    }
    cells[CellId(hole)] = saved;
    order[hole] = CellId(hole);
  }
}

}  // namespace

std::size_t canonicalize_cells(CellPool& pool, std::size_t num_vertices) {
  // Give each record its canonical slots; the marks' memory is not needed any more.
  pool.marks = {};
  IdVector<CellId, SlotMap> slot_maps(pool.cells.size(), 0);
  for (const CellId c : pool.cells.ids()) {
    if (!pool.is_free(c)) slot_maps[c] = canonicalize_slots(pool.cells[c]);
  }

  std::size_t finite_cells = 0;
  std::size_t live_cells = 0;
  std::vector<CellId> order = sorted_cells(pool, num_vertices, finite_cells, live_cells);

  // Translate the neighbors to the new numbers, then move the records.
  IdVector<CellId, CellId> new_id(pool.cells.size());
  for (std::size_t i = 0; i < order.size(); ++i) new_id[order[i]] = CellId(i);
  for (const CellId c : pool.cells.ids()) {
    if (pool.is_free(c)) continue;
    for (FacetId& neighbor : pool.cells[c].neighbors) {
      const CellId old = cell_of(neighbor);
      const std::uint32_t old_slot = static_cast<std::uint32_t>(index_of(neighbor));
      neighbor = facet_id(new_id[old], static_cast<int>(new_slot(slot_maps[old], old_slot)));
    }
  }
  permute_in_place(pool.cells, order);
  pool.cells.resize(live_cells);
  pool.free.clear();
  return finite_cells;
}

}  // namespace cocoon
