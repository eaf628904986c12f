#include "cocone/local_patch.h"

#include <algorithm>
#include <utility>

namespace cocoon {

LocalPatch PatchBuilder::build(const DynamicDelaunay& delaunay, std::span<const VertexId> core) {
  const TriangulationView view = delaunay.view();
  cell_here_.resize(view.cell_records().size());
  vertex_here_.resize(delaunay.num_vertex_slots());
  const std::span<const CellId> cells = stars_.stars(delaunay, core);
  slots_.assign(cells.begin(), cells.end());
  const auto first_infinite = std::stable_partition(slots_.begin(), slots_.end(),
                                                    [&](CellId c) { return !view.is_infinite(c); });
  const auto finite_cells = static_cast<std::size_t>(first_infinite - slots_.begin());
  for (std::size_t i = 0; i < slots_.size(); ++i) cell_here_[slots_[i]] = CellId(i);

  LocalPatch patch;
  TriangulationArrays arrays;
  arrays.cells.reserve(slots_.size());
  for (std::size_t k = 0; k < slots_.size(); ++k) {
    const CellId here(k);
    Cell cell = view.cell(slots_[k]);
    for (VertexId& v : cell.vertices) {
      if (v == infinite_vertex) continue;
      if (vertex_here_[v].is_none()) {
        vertex_here_[v] = arrays.points.push_back(view.point(v));
        patch.vertex_in_whole.push_back(v);
      }
      v = vertex_here_[v];
    }
    for (int i = 0; i < 4; ++i) {
      FacetId& f = cell.neighbors[static_cast<std::size_t>(i)];
      const CellId behind = cell_here_[cell_of(f)];
      f = behind.is_none() ? facet_id(here, i) : facet_id(behind, index_of(f));
    }
    arrays.cells.push_back(cell);
  }
  patch.is_core = VertexSet(arrays.points.size(), 0);
  for (const VertexId v : core) patch.is_core[vertex_here_[v]] = 1;
  for (const CellId c : slots_) cell_here_[c] = CellId();
  for (const VertexId v : patch.vertex_in_whole) vertex_here_[v] = VertexId();
  for (const VertexId v : arrays.points.ids()) arrays.vertex_of_point.push_back(v);
  patch.triangulation = Triangulation(std::move(arrays), finite_cells);
  patch.slot_of_cell = IdVector<CellId, CellId>(slots_);
  return patch;
}

}  // namespace cocoon
