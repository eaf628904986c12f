#include "cocone/star_finder.h"

#include "delaunay/circulate.h"

namespace cocoon {

std::span<const CellId> StarFinder::star(const DynamicDelaunay& delaunay, VertexId v) {
  const TriangulationView view = delaunay.view();
  seen_.resize(view.cell_records().size(), 0);
  if (++call_ == 0) {  // all numbers were used: begin again
    seen_ = IdVector<CellId, std::uint32_t>(seen_.size(), 0);
    call_ = 1;
  }
  queue_.assign(1, delaunay.cell_at(v));
  seen_[queue_[0]] = call_;
  for (std::size_t next = 0; next < queue_.size(); ++next) {
    const Cell& cell = view.cell(queue_[next]);
    const int opposite = index_of_vertex(cell, v);
    for (int i = 0; i < 4; ++i) {
      const CellId behind = cell_of(cell.neighbors[static_cast<std::size_t>(i)]);
      if (i == opposite || seen_[behind] == call_) continue;
      seen_[behind] = call_;
      queue_.push_back(behind);
    }
  }
  return queue_;
}

}  // namespace cocoon
