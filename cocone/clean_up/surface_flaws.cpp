#include "cocone/clean_up/surface_flaws.h"

#include <algorithm>

#include "cocone/facets/surface_fan.h"
#include "geom/zeroed_array.h"

namespace cocoon {

SurfaceFlaws find_surface_flaws(const Triangulation& triangulation, const DoubtfulRegion& region,
                                const IdVector<CellId, std::uint8_t>& out) {
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
  std::vector<VertexId> edge_ends;
  // In the order of memory, which is that of space.
  for (const VertexId v : triangulation.vertices()) {
    if (!region.contains(v)) continue;
    if (fans[v].facets == 0) {
      flaws.unused.push_back(v);
    } else if (!is_one_umbrella(triangulation, out, v, fans[v], edge_ends)) {
      flaws.pinched.push_back(v);
    }
  }
  const auto earlier = [&](VertexId a, VertexId b) { return region.rank[a] < region.rank[b]; };
  std::sort(flaws.unused.begin(), flaws.unused.end(), earlier);
  std::sort(flaws.pinched.begin(), flaws.pinched.end(), earlier);
  return flaws;
}

}  // namespace cocoon
