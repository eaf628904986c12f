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

// What tells the cells of one bucket apart: vertices 1, 2 and 3 of the record.
struct KeyedCell {
  std::uint64_t second_and_third;
  VertexId fourth;
  CellId id;

  friend bool operator<(const KeyedCell& x, const KeyedCell& y) {
    if (x.second_and_third != y.second_and_third) return x.second_and_third < y.second_and_third;
    return x.fourth < y.fourth;
  }
};

KeyedCell keyed(const Cell& cell, CellId id) {
  const auto& [first, second, third, fourth] = cell.vertices;
  return {std::uint64_t{second.value} << 32 | third.value, fourth, id};
}

// order[new id] = old id. Precondition: canonical slots.
std::vector<CellId> sorted_cells(const IdVector<CellId, Cell>& cells, std::size_t num_vertices) {
  // Counting sort by (infinite, smallest vertex), which is vertices[0] of a canonical record ...
  std::vector<std::uint32_t> offsets(2 * num_vertices + 1, 0);
  const auto bucket = [&](const Cell& cell) {
    return cell.vertices[0].index() + (cell.vertices[3] == infinite_vertex ? num_vertices : 0);
  };
  for (const Cell& cell : cells) ++offsets[bucket(cell) + 1];
  for (std::size_t b = 1; b < offsets.size(); ++b) offsets[b] += offsets[b - 1];
  std::vector<CellId> order(cells.size());
  for (const CellId c : cells.ids()) order[offsets[bucket(cells[c])]++] = c;
  // ... then by the whole record inside each bucket. The offsets now are the buckets' ends. Records
  // lie anywhere in memory: fetch those that come soon, and sort copies of their keys.
  constexpr std::size_t ahead = 32;
  std::vector<KeyedCell> bucket_cells;
  std::size_t begin = 0;
  for (std::size_t b = 0; b < 2 * num_vertices; ++b) {
    const std::size_t end = offsets[b];
    bucket_cells.clear();
    for (std::size_t i = begin; i < end; ++i) {
      if (i + ahead < order.size()) __builtin_prefetch(&cells[order[i + ahead]]);
      bucket_cells.push_back(keyed(cells[order[i]], order[i]));
    }
    std::sort(bucket_cells.begin(), bucket_cells.end());
    for (std::size_t i = begin; i < end; ++i) order[i] = bucket_cells[i - begin].id;
    begin = end;
  }
  return order;
}

}  // namespace

Triangulation canonical_order(Triangulation triangulation) {
  const std::size_t finite_cells = triangulation.num_finite_cells();
  TriangulationArrays arrays = std::move(triangulation).release();
  IdVector<CellId, Cell>& cells = arrays.cells;

  IdVector<CellId, SlotMap> slot_maps(cells.size(), 0);
  for (const CellId c : cells.ids()) slot_maps[c] = canonicalize_slots(cells[c]);

  // Copy each record to its place and translate its neighbors to the new numbers.
  const std::vector<CellId> order = sorted_cells(cells, arrays.points.size());
  IdVector<CellId, CellId> new_id(cells.size());
  for (std::size_t i = 0; i < order.size(); ++i) new_id[order[i]] = CellId(i);
  IdVector<CellId, Cell> sorted;
  sorted.reserve(cells.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    // Fetch the records that come soon, and then what their neighbors became.
    constexpr std::size_t ahead = 16;
    if (i + 2 * ahead < order.size()) __builtin_prefetch(&cells[order[i + 2 * ahead]]);
    if (i + ahead < order.size()) {
      for (const FacetId neighbor : cells[order[i + ahead]].neighbors) {
        __builtin_prefetch(&new_id[cell_of(neighbor)]);
        __builtin_prefetch(&slot_maps[cell_of(neighbor)]);
      }
    }
    Cell cell = cells[order[i]];
    for (FacetId& neighbor : cell.neighbors) {
      const CellId old = cell_of(neighbor);
      const std::uint32_t old_slot = static_cast<std::uint32_t>(index_of(neighbor));
      neighbor = facet_id(new_id[old], static_cast<int>(new_slot(slot_maps[old], old_slot)));
    }
    sorted.push_back(cell);
  }
  arrays.cells = std::move(sorted);
  return Triangulation(std::move(arrays), finite_cells);
}

}  // namespace cocoon
