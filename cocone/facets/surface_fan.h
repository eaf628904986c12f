// The surface between two sides of the cells as it is around one vertex.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "cocone/facets/surface_walk.h"
#include "delaunay/triangulation.h"
#include "geom/id_vector.h"
#include "geom/ids.h"

namespace cocoon {

// The facets of the surface at a vertex: how many, and one of them, seen from its cell with
// out = 0. All bits zero: none.
struct SurfaceFan {
  std::uint32_t facets;
  FacetId first;

  void add(FacetId f) {
    ++facets;
    first = f;
  }
};

// Whether they are one closed umbrella: a walk around v from facet to facet, on the side of
// `fan.first`, meets all of them, and no edge twice. `edge_ends`: scratch. Complexity: O(cells
// around v).
inline bool is_one_umbrella(const Triangulation& triangulation,
                            const IdVector<CellId, std::uint8_t>& out, VertexId v,
                            const SurfaceFan& fan, std::vector<VertexId>& edge_ends) {
  if (fan.facets == 0) return false;
  edge_ends.clear();
  const bool is_simple = walk_around(triangulation, out, v, fan.first, [&](FacetId, VertexId end) {
    if (std::find(edge_ends.begin(), edge_ends.end(), end) != edge_ends.end()) return false;
    edge_ends.push_back(end);
    return true;
  });
  return is_simple && edge_ends.size() == fan.facets;
}

}  // namespace cocoon
