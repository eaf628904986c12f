#include "cocone/surface_flaws.h"

#include <algorithm>

#include "cocone/surface_walk.h"

namespace cocoon {
namespace {

// The surface facets at a vertex, each seen from its cell with out = 0.
struct Fan {
  std::uint32_t facets;
  FacetId first;  // if there are any
};

// Does a walk around v from surface facet to surface facet, on the side of `first`, meet that many,
// and no edge twice, until `first` comes again?
bool is_simple_cycle(const Triangulation& triangulation, const IdVector<CellId, std::uint8_t>& out,
                     VertexId v, FacetId first, std::uint32_t facets,
                     std::vector<VertexId>& edge_ends) {
  edge_ends.clear();
  const bool is_simple = walk_around(triangulation, out, v, first, [&](FacetId, VertexId end) {
    if (std::find(edge_ends.begin(), edge_ends.end(), end) != edge_ends.end()) return false;
    edge_ends.push_back(end);
    return true;
  });
  return is_simple && edge_ends.size() == facets;
}

}  // namespace

SurfaceFlaws find_surface_flaws(const Triangulation& triangulation, const DoubtfulRegion& region,
                                const IdVector<CellId, std::uint8_t>& out) {
  ZeroedArray<VertexId, Fan> fans(triangulation.num_vertices());
  for (const CellId c : region.cells) {
    if (out[c] != 0) continue;
    for (int i = 0; i < 4; ++i) {
      if (out[triangulation.neighbor(c, i)] == 0) continue;
      for (const VertexId v : triangulation.facet_vertices(facet_id(c, i))) {
        if (!region.contains(v)) continue;
        ++fans[v].facets;
        fans[v].first = facet_id(c, i);
      }
    }
  }
  SurfaceFlaws flaws;
  std::vector<VertexId> edge_ends;
  // In the order of memory, which is that of space.
  for (const VertexId v : triangulation.vertices()) {
    if (!region.contains(v)) continue;
    const auto& [facets, first] = fans[v];
    if (facets == 0) {
      flaws.unused.push_back(v);
    } else if (!is_simple_cycle(triangulation, out, v, first, facets, edge_ends)) {
      flaws.pinched.push_back(v);
    }
  }
  const auto earlier = [&](VertexId a, VertexId b) { return region.rank[a] < region.rank[b]; };
  std::sort(flaws.unused.begin(), flaws.unused.end(), earlier);
  std::sort(flaws.pinched.begin(), flaws.pinched.end(), earlier);
  return flaws;
}

}  // namespace cocoon
