#include "cocone/certain_surface.h"

#include <algorithm>
#include <cstdint>

#include "geom/edge_components.h"
#include "geom/parallel_reduce.h"

namespace cocoon {
namespace {

bool is_closed_at_all_vertices(const LinkedFacets& triangles, const GoodVertices& good,
                               const Execution& execution) {
  VertexSet closed = good.good;
  for (const VertexId v : good.folded) closed[v] = 1;
  return first_failing(execution, triangles.size(), [&](std::size_t t) {
           const auto [a, b, c] = triangles.corners[t];
           return (closed[a] & closed[b] & closed[c]) != 0;
         }) == triangles.size();
}

// Triangles in one piece, and all halves on the same side of it.
bool has_one_side(const ManifoldSurface& surface, const VertexSet& good,
                  const Execution& execution) {
  const LinkedFacets& triangles = surface.triangles;
  const EdgeComponents pieces = edge_components(
      triangles.links, execution,
      [&](SideId side) {
        const auto [a, b] = triangles.ends(side);
        return (good[a] | good[b]) != 0;
      },
      [&](SideId side, SideId across) {
        return triangles.ends(side)[0] == triangles.ends(across)[0];
      });
  if (pieces.components.size() != 1 || pieces.components[0].is_contradictory) return false;
  const auto side_of_half = [&](std::size_t t) {
    const bool from_behind = surface.halves[t] != triangles.facets[t];
    return static_cast<unsigned>(pieces.turned[t]) ^ (from_behind ? 1U : 0U);
  };
  return first_failing(execution, triangles.size(), [&](std::size_t t) {
           return side_of_half(t) == side_of_half(0);
         }) == triangles.size();
}

bool is_seen_from_outside(const Triangulation& triangulation, const ManifoldSurface& surface) {
  return std::any_of(surface.halves.begin(), surface.halves.end(),
                     [&](FacetId half) { return triangulation.is_infinite(cell_of(half)); });
}

bool every_cell_has_good_vertex(const Triangulation& triangulation, const VertexSet& good,
                                const Execution& execution) {
  const std::size_t count = triangulation.num_finite_cells();
  return first_failing(execution, count, [&](std::size_t c) {
           const auto& [v0, v1, v2, v3] = triangulation.cell(CellId(c)).vertices;
           return (good[v0] | good[v1] | good[v2] | good[v3]) != 0;
         }) == count;
}

}  // namespace

bool is_certain(const Triangulation& triangulation, const ManifoldSurface& surface,
                const GoodVertices& good, const Execution& execution) {
  const bool all_good = good.count == triangulation.num_vertices();
  return is_seen_from_outside(triangulation, surface) &&
         (all_good || is_closed_at_all_vertices(surface.triangles, good, execution)) &&
         (all_good || every_cell_has_good_vertex(triangulation, good.good, execution)) &&
         has_one_side(surface, good.good, execution);
}

}  // namespace cocoon
