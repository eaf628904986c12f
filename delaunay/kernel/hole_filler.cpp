#include "delaunay/kernel/hole_filler.h"

#include <bit>
#include <cassert>

#include "delaunay/kernel/first_cells.h"
#include "delaunay/kernel/insertion_order.h"
#include "geom/mesh/triangle_order.h"

namespace cocoon {
namespace {

constexpr std::uint32_t none = 0xFFFFFFFFU;

Triangle facet_of(const Cell& cell, int i) { return smallest_first(facet_vertices(cell, i)); }

std::size_t hash(const Triangle& t) {
  std::uint64_t h = t[0].value * 0x9E3779B97F4A7C15U;
  h = (h ^ t[1].value) * 0xBF58476D1CE4E5B9U;
  h = (h ^ (h >> 32) ^ t[2].value) * 0x94D049BB133111EBU;
  return static_cast<std::size_t>(h >> 32);
}

}  // namespace

void HoleFiller::clear() {
  points_.clear();
  pool_.cells.clear();
  pool_.marks.clear();
  pool_.free.clear();
}

bool HoleFiller::spans_space() {
  order_ = insertion_order(points_.span());
  return bring_simplex_to_front(points_, order_) == 3;
}

void HoleFiller::triangulate(DelaunayCounters& counters) {
  points_.push_back({});  // the kernel reads a little past the last vertex
  inserter_.read_points_again();
  make_first_cells(
      pool_, points_,
      {VertexId(order_[0]), VertexId(order_[1]), VertexId(order_[2]), VertexId(order_[3])});
  CellId hint(0);
  for (std::size_t i = 4; i < order_.size(); ++i) {
    const VertexId v(order_[i]);
    hint = inserter_.insert(v, inserter_.find_start(points_[v], hint, counters), counters);
  }
}

void HoleFiller::index_border(std::span<const Triangle> border) {
  border_.clear();
  const std::size_t slots = std::bit_ceil(2 * border.size() + 2);
  border_table_.assign(slots, none);
  for (const Triangle& triangle : border) {
    border_.push_back(smallest_first(triangle));
    std::size_t slot = hash(border_.back()) & (slots - 1);
    while (border_table_[slot] != none) slot = (slot + 1) & (slots - 1);
    border_table_[slot] = static_cast<std::uint32_t>(border_.size() - 1);
  }
}

// The position of an oriented triangle in the border, or none.
std::uint32_t HoleFiller::find_border(const Triangle& triangle) const {
  const std::size_t mask = border_table_.size() - 1;
  for (std::size_t slot = hash(triangle) & mask;; slot = (slot + 1) & mask) {
    const std::uint32_t found = border_table_[slot];
    if (found == none || border_[found] == triangle) return found;
  }
}

// A cell inside: the one at a facet of the border, any if there is no border.
CellId HoleFiller::first_cell_inside() const {
  for (const CellId c : pool_.cells.ids()) {
    if (pool_.is_free(c)) continue;
    if (border_.empty()) return c;
    for (int i = 0; i < 4; ++i) {
      if (facet_of(pool_.cells[c], i) == border_[0]) return c;
    }
  }
  assert(false);  // facets of the border are facets of the triangulation
  return {};
}

// The number of a cell inside the hole; gives it one if it has none.
std::uint32_t HoleFiller::enter(CellId c) {
  std::uint32_t& index = fill_index_[c];
  if (index == none) {
    index = static_cast<std::uint32_t>(inside_.size());
    inside_.push_back(c);
  }
  return index;
}

const HoleFilling& HoleFiller::fill(std::span<const Triangle> border, DelaunayCounters& counters) {
  triangulate(counters);
  index_border(border);
  filling_.cells.clear();
  filling_.facet_at_border.assign(border.size(), FacetId());
  inside_.clear();
  fill_index_.clear();
  fill_index_.resize(pool_.cells.size(), none);

  // Flood from one cell inside, up to the border.
  std::size_t border_facets = 0;
  enter(first_cell_inside());
  for (std::size_t k = 0; k < inside_.size(); ++k) {
    Cell cell = pool_.cells[inside_[k]];
    for (int i = 0; i < 4; ++i) {
      FacetId& neighbor = cell.neighbors[static_cast<std::size_t>(i)];
      const std::uint32_t at = find_border(facet_of(cell, i));
      if (at == none) {
        neighbor = facet_id(CellId(enter(cell_of(neighbor))), index_of(neighbor));
      } else {
        neighbor = FacetId();
        filling_.facet_at_border[at] = facet_id(CellId(k), i);
        ++border_facets;
      }
    }
    filling_.cells.push_back(cell);
  }
  assert(border_facets == border.size());
  static_cast<void>(border_facets);
  return filling_;
}

}  // namespace cocoon
