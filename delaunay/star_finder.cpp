#include "delaunay/star_finder.h"

#include <array>

namespace cocoon {

// A star hangs together by facets at its vertex. So all stars are flooded at once, through the
// facets that have one of the vertices.
std::span<const CellId> StarFinder::stars(const TriangulationView& view,
                                          const IdVector<VertexId, CellId>& cell_at,
                                          std::span<const VertexId> vertices) {
  seen_.resize(view.cell_records().size(), 0);
  in_list_.resize(cell_at.size(), 0);
  cells_.clear();
  for (const VertexId v : vertices) in_list_[v] = 1;
  const auto find = [&](CellId c) {
    if (seen_[c] != 0) return;
    seen_[c] = 1;
    cells_.push_back(c);
    __builtin_prefetch(&view.cell(c));  // looked at later
  };
  constexpr std::size_t ahead = 8;  // cells whose neighbors are asked for early
  std::size_t next = 0;
  for (const VertexId v : vertices) {
    find(cell_at[v]);
    for (; next < cells_.size(); ++next) {
      if (next + ahead < cells_.size()) {
        for (const FacetId f : view.cell(cells_[next + ahead]).neighbors) {
          __builtin_prefetch(&seen_[cell_of(f)]);
        }
      }
      const Cell& cell = view.cell(cells_[next]);
      int listed = 0;
      std::array<int, 4> is_listed{};
      for (std::size_t i = 0; i < 4; ++i) {
        const VertexId w = cell.vertices[i];
        is_listed[i] = w != infinite_vertex && in_list_[w] != 0 ? 1 : 0;
        listed += is_listed[i];
      }
      for (std::size_t i = 0; i < 4; ++i) {
        if (listed > is_listed[i]) find(cell_of(cell.neighbors[i]));
      }
    }
  }
  for (const CellId c : cells_) seen_[c] = 0;
  for (const VertexId v : vertices) in_list_[v] = 0;
  return cells_;
}

}  // namespace cocoon
