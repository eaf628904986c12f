#include "cocone/live/local_patch.h"

#include <utility>

namespace cocoon {

LocalPatch PatchBuilder::build(const DynamicDelaunay& delaunay, std::span<const VertexId> core) {
  const TriangulationView view = delaunay.view();
  cell_here_.resize(view.cell_records().size());
  vertex_here_.resize(delaunay.num_vertex_slots());
  // Finite cells first.
  const std::span<const CellId> cells = stars_.stars(delaunay, core);
  slots_.clear();
  infinite_.clear();
  for (const CellId c : cells) (view.is_infinite(c) ? infinite_ : slots_).push_back(c);
  const std::size_t finite_cells = slots_.size();
  slots_.insert(slots_.end(), infinite_.begin(), infinite_.end());
  for (std::size_t i = 0; i < slots_.size(); ++i) cell_here_[slots_[i]] = CellId(i);

  LocalPatch patch;
  TriangulationArrays arrays;
  arrays.cells.resize(slots_.size());
  for (std::size_t k = 0; k < slots_.size(); ++k) {
    // Cells and what lies at their neighbors are asked for in advance.
    if (k + 16 < slots_.size()) __builtin_prefetch(&view.cell(slots_[k + 16]));
    if (k + 8 < slots_.size()) {
      for (const FacetId f : view.cell(slots_[k + 8]).neighbors) {
        __builtin_prefetch(&cell_here_[cell_of(f)]);
      }
    }
    const CellId here(k);
    Cell& cell = arrays.cells[here];
    cell = view.cell(slots_[k]);
    for (VertexId& v : cell.vertices) {
      if (v == infinite_vertex) continue;
      VertexId& number = vertex_here_[v];
      if (number.is_none()) {
        number = arrays.points.push_back(view.point(v));
        patch.vertex_in_whole.push_back(v);
      }
      v = number;
    }
    for (int i = 0; i < 4; ++i) {
      FacetId& f = cell.neighbors[static_cast<std::size_t>(i)];
      const CellId behind = cell_here_[cell_of(f)];
      f = behind.is_none() ? facet_id(here, i) : facet_id(behind, index_of(f));
    }
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
