#include "cocone/marking/yielding_labels.h"

#include <algorithm>
#include <limits>

#include "cocone/cell_marks.h"
#include "cocone/inputs/stage_inputs.h"
#include "geom/arrays/sort_ids.h"
#include "geom/mesh_check.h"
#include "geom/messages/require_size.h"

namespace cocoon {
namespace {

VertexSet widened(const Triangulation& triangulation, const VertexSet& flags) {
  VertexSet wide = flags;
  for (const CellId c : triangulation.finite_cells()) {
    const Cell& cell = triangulation.cell(c);
    if (!has_vertex_in(flags, cell)) continue;
    for (const VertexId v : cell.vertices) wide[v] = 1;
  }
  return wide;
}

}  // namespace

std::vector<VertexId> touching_vertices(const SurfaceMesh& surface, const Execution& execution) {
  constexpr std::size_t all = std::numeric_limits<std::size_t>::max();
  const MeshExamples found = mesh_check(surface.mesh, {.max_examples = all}, execution).examples;
  std::vector<VertexId> vertices;
  const auto take = [&](VertexId v) { vertices.push_back(surface.triangulation_vertex[v]); };
  for (const VertexPair& edge : found.overfull_edges) std::for_each(edge.begin(), edge.end(), take);
  std::for_each(found.pinched_vertices.begin(), found.pinched_vertices.end(), take);
  make_set(vertices);
  return vertices;
}

std::size_t yield_labels(const Triangulation& triangulation, std::span<const VertexId> at,
                         unsigned rings, const VertexSet& good,
                         IdVector<CellId, CellLabel>& labels) {
  require_vertex_flags("yield_labels", triangulation, good);
  require_size("yield_labels", "labels of cells", labels.size(), triangulation.num_cells());
  VertexSet flags(triangulation.num_vertices(), 0);
  for (const VertexId v : at) flags[v] = 1;
  for (unsigned r = 0; r < rings; ++r) flags = widened(triangulation, flags);
  std::size_t count = 0;
  for (const CellId c : triangulation.finite_cells()) {
    if (labels[c] == CellLabel::unmarked || is_poor(triangulation, good, c)) continue;
    if (!has_vertex_in(flags, triangulation.cell(c))) continue;
    labels[c] = CellLabel::unmarked;
    ++count;
  }
  return count;
}

}  // namespace cocoon
