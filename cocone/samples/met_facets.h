// Which facets meet a cocone, told by what their two cells see of the corners: many at once in SIMD
// lanes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "cocone/samples/cone_sides.h"
#include "delaunay/triangulation.h"
#include "geom/id_vector.h"

namespace cocoon {

struct MetFacets {
  std::vector<FacetId> facets;     // canonical ids, ascending
  std::vector<std::uint8_t> rows;  // of each: bit j = it meets the cocone of vertex j of its cell
};

// The facets whose canonical ids lie in the cells begin .. end - 1, finite ones, and whose dual
// edges meet a cocone: unless both ends lie in the same nappe (meets_cocone in double_cone.h).
// Complexity: O(end - begin).
MetFacets met_facets(const Triangulation& triangulation, const IdVector<CellId, CornerSides>& sides,
                     std::size_t begin, std::size_t end);

}  // namespace cocoon
