// The cells around a vertex on one side of the surface.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "cocone/facet_set.h"
#include "delaunay/triangulation.h"
#include "geom/arrays/zeroed_array.h"

namespace cocoon {

class HalfStar {
 public:
  // Keeps references, which must outlive the object. O(1).
  HalfStar(const Triangulation& triangulation, const FacetSet& surface);

  // The cells at v that hang together with `first`, one of them, by facets at v off the surface,
  // beginning with it; valid until the next call. At a good vertex (umbrella.h): those on one side
  // of its disk. Complexity: O(cells found).
  std::span<const CellId> flood(VertexId v, CellId first);
  // Is the cell among those found last? O(1).
  bool contains(CellId c) const { return found_[c] != 0; }

 private:
  const Triangulation& triangulation_;
  const FacetSet& surface_;
  ZeroedArray<CellId, std::uint8_t> found_;
  std::vector<CellId> cells_;
};

}  // namespace cocoon
