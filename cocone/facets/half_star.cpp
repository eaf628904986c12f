#include "cocone/facets/half_star.h"

#include "delaunay/circulate.h"

namespace cocoon {

HalfStar::HalfStar(const Triangulation& triangulation, const FacetSet& surface)
    : triangulation_(triangulation), surface_(surface), found_(triangulation.num_cells()) {}

std::span<const CellId> HalfStar::flood(VertexId v, CellId first) {
  for (const CellId c : cells_) found_[c] = 0;
  cells_.assign(1, first);
  found_[first] = 1;
  for (std::size_t next = 0; next < cells_.size(); ++next) {
    const CellId c = cells_[next];
    const int opposite = index_of_vertex(triangulation_.cell(c), v);
    for (int i = 0; i < 4; ++i) {
      if (i == opposite || surface_.contains(facet_id(c, i))) continue;
      const CellId behind = triangulation_.neighbor(c, i);
      if (found_[behind] != 0) continue;
      found_[behind] = 1;
      cells_.push_back(behind);
    }
  }
  return cells_;
}

}  // namespace cocoon
