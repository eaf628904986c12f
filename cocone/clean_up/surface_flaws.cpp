#include "cocone/clean_up/surface_flaws.h"

#include <algorithm>

#include "cocone/facets/surface_fan.h"
#include "geom/arrays/zeroed_array.h"
#include "geom/parallel/parallel_list.h"

namespace cocoon {

namespace {

// Vertices on the surface around which it is not one disk, of those of a range.
void add_pinched(const Triangulation& triangulation, const IdVector<CellId, std::uint8_t>& out,
                 const ZeroedArray<VertexId, SurfaceFan>& fans, std::size_t begin, std::size_t end,
                 std::vector<VertexId>& pinched) {
  std::vector<VertexId> edge_ends;
  for (VertexId v(begin); v.index() < end; ++v) {
    if (fans[v].facets == 0) continue;
    if (!is_one_umbrella(triangulation, out, v, fans[v], edge_ends)) pinched.push_back(v);
  }
}

}  // namespace

SurfaceFlaws find_surface_flaws(const Triangulation& triangulation, const DoubtfulRegion& region,
                                const IdVector<CellId, std::uint8_t>& out,
                                const Execution& execution) {
  ZeroedArray<VertexId, SurfaceFan> fans(triangulation.num_vertices());
  for (const CellId c : region.cells) {
    if (out[c] != 0) continue;
    for (int i = 0; i < 4; ++i) {
      if (out[triangulation.neighbor(c, i)] == 0) continue;
      for (const VertexId v : triangulation.facet_vertices(facet_id(c, i))) {
        if (region.contains(v)) fans[v].add(facet_id(c, i));
      }
    }
  }
  SurfaceFlaws flaws;
  for (const VertexId v : region.vertices) {
    if (fans[v].facets == 0) flaws.unused.push_back(v);
  }
  // In the order of memory, which is that of space.
  constexpr std::size_t vertices_per_chunk = 1024;
  flaws.pinched = parallel_list<VertexId>(
      execution, triangulation.num_vertices(), vertices_per_chunk,
      [&](std::size_t begin, std::size_t end, std::vector<VertexId>& pinched) {
        add_pinched(triangulation, out, fans, begin, end, pinched);
      });
  const auto earlier = [&](VertexId a, VertexId b) { return region.rank[a] < region.rank[b]; };
  std::sort(flaws.pinched.begin(), flaws.pinched.end(), earlier);
  return flaws;
}

}  // namespace cocoon
